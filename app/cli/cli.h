// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace patina {

/// Tells whether the first argument of the program asks for the command line instead of the editor:
/// a command (or a word that can only be a misspelt one), --help or --version.
bool isCommand(std::string_view firstArgument);

/// Runs `patina <command> ...` and returns the exit status: 0 for success, 130 where Ctrl-C ended a
/// long task, else 1. Results go to standard output, messages to standard error. It needs no
/// display and no Qt.
int runCommand(int argc, char** argv);

} // namespace patina
