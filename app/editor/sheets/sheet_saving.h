// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "catalog/catalog.h"
#include "material/material.h"
#include "sheet/contact_sheet.h"

namespace patina {

/// Writes a sheet of a material to a file, so that it can be drawn from there. A sheet names a
/// preset in its own folder or among those that ship: where none that it names is this material,
/// one is written beside it, and never over another file. Returns the sheet as it is in the file.
Result<Sheet> saveSheet(const std::filesystem::path& file, Sheet sheet, const Material& start,
                        const Catalog& catalog);

} // namespace patina
