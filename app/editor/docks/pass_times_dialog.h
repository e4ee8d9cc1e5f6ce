// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "measure/cost/effect_cost.h"

namespace patina {

/// Lists what each pass of the measured frames takes.
class PassTimesDialog : public QDialog {
    Q_OBJECT

  public:
    PassTimesDialog(const EffectCosts& costs, QWidget* parent);
};

} // namespace patina
