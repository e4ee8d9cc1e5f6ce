// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace patina {

/// Is called now and then with how far a task is, 0 .. 1.
using ReportProgress = std::function<void(double done)>;

} // namespace patina
