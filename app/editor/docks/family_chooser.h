// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>

#include "predict/gpu_family.h"

namespace patina {

/// Chooses for which family of graphics cards costs are shown that are predicted: RDNA 2 at first.
class FamilyChooser : public QComboBox {
    Q_OBJECT

  public:
    explicit FamilyChooser(QWidget* parent = nullptr);

    const GpuFamily& family() const;
};

} // namespace patina
