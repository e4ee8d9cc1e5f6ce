// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "parameters/number_box.h"

namespace patina {

/// A field for what a way to compute something may take or err, as parameters' fields are.
class BoundBox : public NumberBox {
    Q_OBJECT

  public:
    enum class Of {
        Milliseconds,
        Share ///< typed and shown as "1/255", "0.4 %"
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
