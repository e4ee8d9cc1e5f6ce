// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tiny_gltf.h>

#include "io/left_out.h"

namespace patina {

/// Returns what the file has beside the triangles and the looks that are read.
LeftOut leftOutOf(const tinygltf::Model& model);

} // namespace patina
