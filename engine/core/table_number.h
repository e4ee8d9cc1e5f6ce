// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace patina {

/// Says which of its tables of a measured file is meant.
enum class TableForm {
    WithoutGrain, ///< has three angles; of a surface with a grain it is the mean over its turns
    WithGrain     ///< has the azimuth of the half vector as fourth angle
};

/// Returns the number that stands for a table of a file as long as the program runs, by
/// numberOfText() of its path; 0 for the empty path. Any thread may call it.
int tableNumber(std::string_view file, TableForm form);

/// Returns the path of the file whose table has this number; empty where there is none.
std::string fileOfTable(int number);

/// Returns which of the tables has this number.
TableForm formOfTable(int number);

} // namespace patina
