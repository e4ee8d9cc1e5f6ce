// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "core/error.h"
#include "measured/half_difference_table.h"

namespace patina {

using SharedTable = std::shared_ptr<const HalfDifferenceTable>;

/// Reads a file of a measured surface into a table, with the grain where the surface has one, and
/// keeps it for keptTable(), under its absolute and normal path; a file that has not changed since
/// it was kept is not read again. Errors are those of readMeasured(), and that a table is too large
/// for a graphics card.
Result<SharedTable> readTable(const std::filesystem::path& file);

/// Reads the table with a number of tableNumber(), as the other does, whatever grain its surface
/// has.
Result<SharedTable> readTable(int number);

/// Returns the table with a number of tableNumber(), made of the file's full path: the one that
/// readTable() read last, or it is read now. Number 0, no file, has a grey that is matte; a file
/// that cannot be read has magenta, until readTable() reads it. Tables that nobody holds are
/// forgotten, the oldest first, when all are larger than 256 MiB. Any thread may call it.
SharedTable keptTable(int number);

/// Returns the table that keptTable() would, at once; null where it would read the file first. Any
/// thread may call it.
SharedTable tableAtHand(int number);

/// Returns a number that grows whenever readTable() read a file, so that tables may have changed.
unsigned keptTablesVersion();

} // namespace patina
