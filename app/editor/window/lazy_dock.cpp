// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/lazy_dock.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QAction>
#include <QMainWindow>

namespace patina {
namespace {

/// Limits the height of a dock below the views, as a share of their height and its own together.
constexpr double maxShare = 0.45;

} // namespace

LazyDock::LazyDock(DockEntry entry, const DockContext& context, QWidget* parent)
    : QDockWidget(entry.title, parent), entry_(std::move(entry)), context_(context) {
    setObjectName(entry_.name);
    setWidget(new QWidget(this));
    toggleViewAction()->setWhatsThis(entry_.contents);
}

void LazyDock::build() {
    if (entry_.make) {
        QWidget* placeholder = widget();
        setWidget(std::exchange(entry_.make, nullptr)(context_));
        delete placeholder;
        if (isNew_) {
            QMetaObject::invokeMethod(this, &LazyDock::growToHint, Qt::QueuedConnection);
        }
    }
}

/// Gives a dock below the views the height of its size hint, of which the views keep their share.
void LazyDock::growToHint() {
    auto* window = qobject_cast<QMainWindow*>(parentWidget());
    const bool isBelow =
        window && !isFloating() && window->dockWidgetArea(this) == Qt::BottomDockWidgetArea;
    if (!isBelow) {
        return;
    }
    const int room = height() + window->centralWidget()->height();
    const int wished =
        std::min(sizeHint().height(), static_cast<int>(std::lround(maxShare * room)));
    if (height() < wished) {
        window->resizeDocks({this}, {wished}, Qt::Vertical);
    }
}

void LazyDock::showEvent(QShowEvent* event) {
    build();
    QDockWidget::showEvent(event);
}

} // namespace patina
