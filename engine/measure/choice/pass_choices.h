// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "measure/choice/choices.h"

namespace patina {

/// Returns the choices of the scene's picture passes that compute the same look more cheaply: their
/// parameters of the role "accuracy", as far as they count and their pass does anything. One is
/// "pass.<block>.<parameter>"; passes of the same block share it.
std::vector<Choice> choicesOfPasses(const Scene& scene, const Catalog& catalog);

/// Tells whether a choice is one of those.
bool isOfPass(const Choice& choice);

/// Tells whether one of the levels is of a pass, so that errors show behind the passes alone.
bool hasPassLevel(const ChosenLevels& levels);

/// Returns the level that the scene's passes have: where they differ the first that is not exact,
/// and none for other choices.
std::string passLevel(const Scene& scene, const Choice& choice, const Catalog& catalog);

/// Gives all passes that have the choice the level; leaves other choices alone.
void choosePass(Scene& scene, const Choice& choice, const std::string& level,
                const Catalog& catalog);

} // namespace patina
