// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/family_chooser.h"

#include "text/as_text.h"

namespace patina {

FamilyChooser::FamilyChooser(QWidget* parent) : QComboBox(parent) {
    for (const GpuFamily& family : gpuFamilies()) {
        addItem(tr("Predicted for %1").arg(asText(family.label)), asText(family.id));
    }
    setCurrentIndex(findData("rdna2"));
    setAccessibleName(tr("Graphics cards"));
    setToolTip(tr("For which graphics cards costs are predicted: none of them need be here"));
}

const GpuFamily& FamilyChooser::family() const {
    return gpuFamilies()[static_cast<std::size_t>(currentIndex())];
}

} // namespace patina
