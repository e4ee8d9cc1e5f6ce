// SPDX-License-Identifier: GPL-3.0-or-later
// QCustomPlot, whose header needs the lower-case words that the editor is compiled without.
#pragma once

#define signals Q_SIGNALS
#define slots Q_SLOTS
#define foreach Q_FOREACH
#include <qcustomplot.h>
#undef signals
#undef slots
#undef foreach
