// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

namespace patina {

/// Answers a CompileRequest, line by line, and returns the exit status of the program: 1 where the
/// request is none or the driver cannot answer it.
int serveCompilation(const std::string& request,
                     const std::function<void(const std::string&)>& report);

} // namespace patina
