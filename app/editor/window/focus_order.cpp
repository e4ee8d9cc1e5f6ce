// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/focus_order.h"

#include <algorithm>
#include <tuple>

#include <QMainWindow>
#include <QScrollArea>

namespace patina {
namespace {

struct Stop {
    QWidget* widget;
    QPoint panel; ///< is the top left corner of its panel, in the window
    QRect place;  ///< is its rectangle in the window
};

/// Returns the window's own child that a widget lies in: a dock, a tool bar, the views.
QWidget* panelOf(QWidget* widget, const QWidget& window) {
    while (widget->parentWidget() && widget->parentWidget() != &window) {
        widget = widget->parentWidget();
    }
    return widget;
}

bool takesTab(const QWidget& widget, const QWidget& window) {
    return (widget.focusPolicy() & Qt::TabFocus) != 0 && !widget.focusProxy() &&
           widget.window() == &window && widget.isVisible() && widget.isEnabled();
}

bool isBefore(const Stop& a, const Stop& b) {
    const auto key = [](const Stop& stop) {
        return std::make_tuple(stop.panel.x(), stop.panel.y(), stop.place.top());
    };
    return key(a) < key(b);
}

/// Sorts each row, whose members need not begin at the same height, from the left.
void sortRows(std::vector<Stop>& stops) {
    for (auto first = stops.begin(); first != stops.end();) {
        const auto last = std::find_if(first, stops.end(), [&](const Stop& stop) {
            return stop.panel != first->panel || stop.place.center().y() > first->place.bottom();
        });
        std::sort(first, last,
                  [](const Stop& a, const Stop& b) { return a.place.left() < b.place.left(); });
        first = last;
    }
}

void scrollTo(QWidget* widget) {
    for (QWidget* parent = widget->parentWidget(); parent; parent = parent->parentWidget()) {
        if (auto* area = qobject_cast<QScrollArea*>(parent)) {
            area->ensureWidgetVisible(widget);
        }
    }
}

} // namespace

std::vector<QWidget*> focusOrder(const QMainWindow& window) {
    std::vector<Stop> stops;
    for (QWidget* widget : window.findChildren<QWidget*>()) {
        if (!takesTab(*widget, window)) {
            continue;
        }
        const QWidget* panel = panelOf(widget, window);
        // A dock behind another's tab is visible to Qt, but lies outside the window.
        if (window.rect().intersects(panel->geometry())) {
            stops.push_back(
                {widget, panel->pos(), {widget->mapTo(&window, QPoint()), widget->size()}});
        }
    }
    std::stable_sort(stops.begin(), stops.end(), isBefore);
    sortRows(stops);
    std::vector<QWidget*> order;
    for (const Stop& stop : stops) {
        order.push_back(stop.widget);
    }
    return order;
}

bool moveFocus(const QMainWindow& window, bool forwards) {
    const std::vector<QWidget*> order = focusOrder(window);
    if (order.empty()) {
        return false;
    }
    const auto now = std::find(order.begin(), order.end(), window.focusWidget());
    const std::size_t count = order.size();
    const std::size_t at = std::size_t(now - order.begin()); // count: nowhere yet
    const std::size_t next = forwards ? (now == order.end() ? 0 : at + 1) : at + count - 1;
    QWidget* wanted = order[next % count];
    wanted->setFocus(forwards ? Qt::TabFocusReason : Qt::BacktabFocusReason);
    scrollTo(wanted);
    return true;
}

} // namespace patina
