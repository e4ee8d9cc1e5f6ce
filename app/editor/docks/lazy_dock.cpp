// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/lazy_dock.h"

#include <utility>

namespace patina {

LazyDock::LazyDock(DockEntry entry, const DockContext& context, QWidget* parent)
    : QDockWidget(entry.title, parent), entry_(std::move(entry)), context_(context) {
    setObjectName(entry_.name);
    setWidget(new QWidget(this));
}

void LazyDock::build() {
    if (entry_.make) {
        QWidget* placeholder = widget();
        setWidget(std::exchange(entry_.make, nullptr)(context_));
        delete placeholder;
    }
}

void LazyDock::showEvent(QShowEvent* event) {
    build();
    QDockWidget::showEvent(event);
}

} // namespace patina
