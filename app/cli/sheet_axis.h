// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/error.h"
#include "sheet/contact_sheet.h"

namespace patina {

/// Reads an axis as it is typed: "metalness=0:1:8" (from, to and steps), "lobe=strauss,ggx", values
/// with commas between semicolons ("diffuse.color=1,0,0;0,1,0"), "models=lambert,strauss", or a
/// name alone for all there is: "smoothness", "models", "accuracy", "lights", "environments".
Result<SheetAxis> axisFromText(const std::string& text);

} // namespace patina
