// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include <tiny_gltf.h>

#include "core/error.h"
#include "io/gltf_views.h"

namespace patina {

/// Returns the values of an accessor as floats, `components` per element: of any component type,
/// normalised where the accessor says so, sparse replacements applied. It is an error when there is
/// no such accessor, when it has another number of components, or when its data reaches beyond its
/// buffer view.
Result<std::vector<float>> readFloats(const tinygltf::Model& model, GltfViews& views, int accessor,
                                      std::size_t components);

/// Returns how many numbers an element of the accessor has; 0 where there is no such accessor.
std::size_t componentsOf(const tinygltf::Model& model, int accessor);

/// Returns the values of a scalar accessor of unsigned integers.
Result<std::vector<std::uint32_t>> readIndices(const tinygltf::Model& model, GltfViews& views,
                                               int accessor);

} // namespace patina
