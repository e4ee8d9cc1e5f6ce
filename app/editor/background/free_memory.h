// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina {

/// Has buffers of 128 KiB and more mapped each by itself, so that freeing one gives its pages back
/// at once. By default the first large buffer that is freed teaches the C library to keep such
/// buffers in the heap, where what lies behind holds them. Call it before any thread starts.
void keepBuffersApart();

/// Gives memory that the heap holds but nobody uses back to the system. Compiling shaders and
/// reading files leave tens of megabytes of it. Takes some milliseconds: for moments of rest.
void returnFreeMemory();

} // namespace patina
