// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "measure/lobe/reflectance_table.h"

namespace patina {

/// Returns the table as the bytes of an OpenEXR file of 32-bit floats without compression, the
/// first row first. Attributes that begin with "patina." say what its axes and values are.
std::string tableExr(const ReflectanceTable& table, const std::string& name);

/// Returns a GLSL function that reads the table.
std::string tableCode(const ReflectanceTable& table, const std::string& name);

} // namespace patina
