// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina {

/// Makes the C library map each buffer of 128 KiB and more by itself, so that freeing one returns
/// its pages at once. By default the first large buffer that is freed raises that limit, and later
/// ones stay in the heap, held by what is behind them. Must be called before any thread starts.
void keepBuffersApart();

/// Returns memory that the heap holds but nobody uses to the system. Compiling shaders and reading
/// files leave tens of megabytes of it. Takes some milliseconds, so call it when nothing else is
/// due.
void returnFreeMemory();

} // namespace patina
