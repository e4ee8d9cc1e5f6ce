// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/accuracy_dock.h"

#include "accuracy/accuracy_page.h"
#include "accuracy/models_page.h"
#include "accuracy/scaling_page.h"

namespace patina {

AccuracyDock::AccuracyDock(const DockContext& context) {
    setDocumentMode(true);
    addTab(new AccuracyPage(context), tr("This Material"));
    addTab(new ModelsPage(context), tr("All Models"));
    addTab(new ScalingPage(context), tr("Scaling"));
    setTabToolTip(0, tr("Every way to compute the material: time against error"));
    setTabToolTip(1, tr("Every model on this scene: time, instructions, lost light"));
    setTabToolTip(2, tr("Time against pixels, lights and objects"));
}

} // namespace patina
