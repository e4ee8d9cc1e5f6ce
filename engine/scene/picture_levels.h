// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/error.h"
#include "scene/scene.h"

namespace patina {

/// Tells whether an assignment of `--set` is about the picture's accuracy:
/// "picture.<choice>=<level>".
bool isOfPicture(const std::string& assignment);

/// Makes such an assignment. It is an error where there is no such choice or level.
Result<void> choosePictureAccuracy(Scene& scene, const std::string& assignment);

} // namespace patina
