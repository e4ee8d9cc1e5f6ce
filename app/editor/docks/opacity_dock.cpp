// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/opacity_dock.h"

#include <QLabel>

#include "parameters/document_form.h"
#include "docks/panel.h"

namespace patina {

OpacityDock::OpacityDock(const DockContext& context) {
    QLabel* hint = hintLabel(this);
    hint->setText(tr("What lies over the whole surface, whatever its model. Below an opacity of 1 "
                     "the object is drawn after the opaque ones, farthest first."));
    fillPanel(this, {hint}, new DocumentForm(context.document, BlockPath::Part::Material));
}

} // namespace patina
