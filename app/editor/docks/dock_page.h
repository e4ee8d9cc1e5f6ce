// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace patina {

/// Names a tab of a dock, or a titled section of one without tabs, and says what it shows.
struct DockPage {
    QString title;
    QString what;
};

} // namespace patina
