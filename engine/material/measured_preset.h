// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "material/preset_file.h"

namespace patina {

/// Returns the parameter of a block that names a file with a table; null where it has none.
const Parameter* tableParameter(const Block& block);

/// Returns the number, by tableNumber(), of the table that a block's function reads; 0 for none.
int measuredTableOf(const Block& block, const Values& values);

/// Reads the file of the measured surface that a material shows, so that its table is at hand.
/// Fails where it cannot be read, or was withheld because it lies outside its preset's folder; a
/// material without one has nothing to read.
Result<void> readMeasuredOf(const Material& material, const Catalog& catalog);

/// Returns the material of the first model that reads such a file, with its grain where it has one,
/// with the file's name and path. It is read only: a file of measurements is not written over.
/// Errors are those of readTable().
Checked<PresetReading> readMeasuredPreset(const std::filesystem::path& file,
                                          const Catalog& catalog);

} // namespace patina
