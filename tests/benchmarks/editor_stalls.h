// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/program.h"

namespace patina::benchmarks {

/// Runs a program that takes an EditorCourse, and reports how long its event loop was blocked in
/// each step, as the median of the runs. Returns false where that is above the target of 100 ms.
bool reportStalls(const char* program, const tests::Start& start, int runs);

} // namespace patina::benchmarks
