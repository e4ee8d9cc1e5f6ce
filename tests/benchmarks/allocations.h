// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina::benchmarks {

/// Returns how often this thread called operator new so far.
long allocations();

} // namespace patina::benchmarks
