// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace patina {

/// True for a path that a file may name without asking the user: relative, with forward slashes,
/// and not leading out of the file's own folder.
bool staysInFolder(std::string_view path);

} // namespace patina
