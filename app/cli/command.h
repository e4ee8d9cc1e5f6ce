// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/error.h"

namespace CLI {
class App;
}

namespace patina {

/// Adds one command to the program's parser. Its callback does the work and sets `status` to 1
/// when it failed; what it prints follows cli.h.
using AddCommand = void (*)(CLI::App& program, int& status);

// Each command has a file of its own name.
void addApproximate(CLI::App& program, int& status);
void addCompletions(CLI::App& program, int& status);
void addCheck(CLI::App& program, int& status);
void addCompare(CLI::App& program, int& status);
void addCost(CLI::App& program, int& status);
void addEffects(CLI::App& program, int& status);
void addEval(CLI::App& program, int& status);
void addExport(CLI::App& program, int& status);
void addImport(CLI::App& program, int& status);
void addLobe(CLI::App& program, int& status);
void addMatch(CLI::App& program, int& status);
void addMerge(CLI::App& program, int& status);
void addModels(CLI::App& program, int& status);
void addRender(CLI::App& program, int& status);
void addSheet(CLI::App& program, int& status);
void addTable(CLI::App& program, int& status);
void addValidate(CLI::App& program, int& status);

/// Writes messages to standard error, one per line.
void report(const Errors& messages);

} // namespace patina
