// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/lazy_dock.h"

#include <utility>

#include <QMainWindow>

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
        QMetaObject::invokeMethod(this, &LazyDock::growToHint, Qt::QueuedConnection);
    }
}

/// A dock below the views begins with the height it wishes for, where most stays for the views.
void LazyDock::growToHint() {
    auto* window = qobject_cast<QMainWindow*>(parentWidget());
    const int wished = sizeHint().height();
    const bool isBelow =
        window && !isFloating() && window->dockWidgetArea(this) == Qt::BottomDockWidgetArea;
    if (isBelow && height() < wished && window->centralWidget()->height() > 2 * wished) {
        window->resizeDocks({this}, {wished}, Qt::Vertical);
    }
}

void LazyDock::showEvent(QShowEvent* event) {
    build();
    QDockWidget::showEvent(event);
}

} // namespace patina
