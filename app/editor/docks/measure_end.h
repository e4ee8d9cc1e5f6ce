// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/error.h"

namespace patina {

/// How a measurement ended: true where it came to its end, false where it was stopped, or what
/// went wrong.
using MeasureEnd = Checked<bool>;

MeasureEnd endOf(bool finished, const Errors& problems);

/// Returns why it ended before its time; else empty.
QString problemText(const MeasureEnd& end);

} // namespace patina
