// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina {

/// Gives memory that the heap holds but nobody uses back to the system. Compiling shaders and
/// reading files leave tens of megabytes of it. Takes some milliseconds: for moments of rest.
void returnFreeMemory();

} // namespace patina
