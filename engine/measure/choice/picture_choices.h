// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "measure/choice/choices.h"

namespace patina {

/// Sets a choice of the scope Picture to one of its levels in the frame.
void choosePicture(ChosenFrame& frame, const Choice& choice, const std::string& level,
                   const Catalog& catalog);

/// Tells whether a choice's levels are numbers of samples per pixel.
bool isOfSamples(const Choice& choice);

/// Tells whether a choice's levels are numbers of directions of an environment.
bool isOfDirections(const Choice& choice);

} // namespace patina
