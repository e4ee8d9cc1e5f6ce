// SPDX-License-Identifier: GPL-3.0-or-later
// Includes QCustomPlot, whose header needs Qt's lower-case keywords. The editor is compiled without
// them.
#pragma once

#define signals Q_SIGNALS
#define slots Q_SLOTS
#define foreach Q_FOREACH
#include <qcustomplot.h>
#undef signals
#undef slots
#undef foreach
