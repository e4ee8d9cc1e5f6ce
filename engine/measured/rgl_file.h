// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string_view>

#include "core/error.h"
#include "measured/measured_reflectance.h"

namespace patina {

/// Reads the bytes of a file of RGL's collection, isotropic or not, RGB or spectral: the
/// reflectance over a grid that follows the distribution of normals that are seen (Dupuy and Jakob
/// 2018, "An adaptive parameterization for efficient material acquisition and rendering").
Result<std::shared_ptr<const MeasuredReflectance>> rglReflectance(std::string_view bytes);

} // namespace patina
