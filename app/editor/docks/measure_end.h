// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/error.h"

namespace patina {

/// Is the end of a measurement: true if it finished, false if it was cancelled, else its errors.
using MeasureEnd = Checked<bool>;

MeasureEnd endOf(bool finished, const Errors& problems);

/// Says why a measurement failed; empty if it finished or was cancelled.
QString problemText(const MeasureEnd& end);

} // namespace patina
