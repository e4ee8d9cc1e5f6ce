// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "measure/choice/choices.h"

namespace patina {

/// Gives a choice of the scope Picture one of its levels.
void choosePicture(ChosenFrame& frame, const Choice& choice, const std::string& level,
                   const Catalog& catalog);

/// Tells whether its levels are numbers of samples per pixel.
bool isOfSamples(const Choice& choice);

/// Tells whether its levels are numbers of directions of an environment.
bool isOfDirections(const Choice& choice);

} // namespace patina
