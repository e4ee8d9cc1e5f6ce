// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "parameters/number_box.h"

namespace patina {

/// Edits an upper bound of time or error in a field like a parameter's. Keeps it in
/// 1e-6 .. 1e7 ms, or in 1e-7 .. 10 as a share.
class BoundBox : public NumberBox {
    Q_OBJECT

  public:
    enum class Of {
        Milliseconds,
        Share ///< is typed and shown as "1/255" or "0.4 %"
    };
    BoundBox(Of of, double usual, QWidget* parent = nullptr);

  Q_SIGNALS:
    void valueChanged();

  protected:
    QString textOf(double value) const override;

  private:
    void take(double wanted);

    Of of_;
};

} // namespace patina
