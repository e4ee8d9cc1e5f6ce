// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace patina::benchmarks {

/// Returns today's date in UTC, as "2026-11-22".
std::string today();

/// Returns the processor, its cores and the driver of the context that is current.
std::string machineText();

/// Counts the processes that wanted to run in the last minute, in the mean; 0 where nobody knows.
double load();

/// Writes a file of docs/ and reports whether that went well.
bool writeDocument(const std::string& name, const std::string& text);

} // namespace patina::benchmarks
