// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/cost_plot.h"

#include <algorithm>
#include <cmath>

#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QToolTip>
#include <QVBoxLayout>

#include "accuracy/cost_text.h"
#include "accuracy/plot_library.h"

namespace patina {
namespace {

constexpr double reach = 11.0; ///< pixels from a point within which the pointer hits it
constexpr QSize usualPlotSize{380, 240};
constexpr QSize minSize{240, 130};

} // namespace

CostPlot::CostPlot(QWidget* parent)
    : PlotWidget(parent), plot_(new QCustomPlot(this)),
      marks_(std::make_unique<PlotMarks>(*plot_)) {
    setObjectName("costPlot");
    setAccessibleName(tr("Chart of time against error"));
    setToolTip(tr("Click on a point to compute it that way. An arrow: it takes no longer than "
                  "that, which is too little to tell"));
    setFocusPolicy(Qt::StrongFocus);
    plot_->setFocusPolicy(Qt::NoFocus);
    plot_->setMouseTracking(true);
    plot_->setMinimumSize(0, 0);
    plot_->installEventFilter(this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(1, 1, 1, 1); // leaves room for the focus frame
    layout->addWidget(plot_);
    draw();
}

CostPlot::~CostPlot() = default;

void CostPlot::setChart(const CostChart& chart, const ChosenLevels& current, bool stale) {
    chart_ = chart;
    current_ = current;
    stale_ = stale;
    if (selected_ >= static_cast<int>(chart_.points.size())) {
        selected_ = -1;
    }
    draw();
}

void CostPlot::select(int point) {
    const bool isThere = point >= 0 && point < static_cast<int>(chart_.points.size());
    selected_ = isThere ? point : -1;
    setAccessibleDescription(isThere ? textOf(point) : QString());
    draw();
}

/// Describes a point; of a stale one only the name, since its numbers are old.
QString CostPlot::textOf(int point) const {
    const auto number = static_cast<std::size_t>(point);
    return stale_ ? settingName(chart_.points[number], chart_) + '\n' + staleText()
                  : pointText(number, chart_);
}

/// Returns the point with the levels chosen now; -1 if it was not measured.
int CostPlot::currentPoint() const {
    const CostPoint* current = chart_.find(current_);
    return current != nullptr ? static_cast<int>(current - chart_.points.data()) : -1;
}

void CostPlot::draw() {
    marks_->draw({chart_, currentPoint(), selected_, stale_}, palette());
    if (!chart_.predictedFor.empty()) { // the card's name stands above and has no room here
        plot_->xAxis->setLabel(tr("ns per pixel, predicted"));
        plot_->replot();
    }
}

QPoint CostPlot::placeOf(int point) const {
    const QPointF place =
        marks_->placeOf(chart_.points.at(static_cast<std::size_t>(point)), chart_);
    return plot_->mapTo(this, place.toPoint());
}

/// Returns the nearest point within reach; -1 if there is none.
int CostPlot::pointAt(QPoint place) const {
    int best = -1;
    double nearest = reach;
    for (std::size_t i = 0; i < chart_.points.size(); ++i) {
        const QPointF way = marks_->placeOf(chart_.points[i], chart_) - QPointF(place);
        const double distance = std::hypot(way.x(), way.y());
        if (distance < nearest) {
            nearest = distance;
            best = static_cast<int>(i);
        }
    }
    return best;
}

bool CostPlot::eventFilter(QObject* watched, QEvent* event) {
    if (watched != plot_) {
        return false;
    }
    if (event->type() == QEvent::MouseMove) {
        const auto* move = static_cast<QMouseEvent*>(event);
        hover(move->position().toPoint(), move->globalPosition().toPoint());
    } else if (event->type() == QEvent::ToolTip) {
        return pointAt(static_cast<QHelpEvent*>(event)->pos()) >= 0; // hover() shows the tip
    } else if (event->type() == QEvent::MouseButtonPress) {
        setFocus(Qt::MouseFocusReason);
    } else if (event->type() == QEvent::MouseButtonRelease) {
        const auto* release = static_cast<QMouseEvent*>(event);
        const int point = pointAt(release->position().toPoint());
        if (release->button() == Qt::LeftButton && point >= 0) {
            select(point);
            Q_EMIT selectionMoved(point);
            Q_EMIT picked(point);
        }
    }
    return false;
}

void CostPlot::hover(QPoint place, QPoint global) {
    const int point = pointAt(place);
    plot_->setCursor(point >= 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
    if (point >= 0) {
        QToolTip::showText(global, textOf(point), plot_);
    } else {
        QToolTip::hideText();
    }
}

void CostPlot::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Left:
        return moveSelection(-1);
    case Qt::Key_Right:
        return moveSelection(1);
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (selected_ >= 0) {
            Q_EMIT picked(selected_);
        }
        return;
    default:
        QWidget::keyPressEvent(event);
    }
}

/// Selects the next point in order of time; the fastest one if none is selected.
void CostPlot::moveSelection(int steps) {
    std::vector<int> order(chart_.points.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = static_cast<int>(i);
    }
    std::ranges::stable_sort(order, {}, [this](int i) {
        return chart_.points[static_cast<std::size_t>(i)].cost.nanosecondsPerPixel;
    });
    if (order.empty()) {
        return;
    }
    const auto now = std::ranges::find(order, selected_);
    const int last = static_cast<int>(order.size()) - 1;
    const int next =
        now == order.end() ? 0 : std::clamp(static_cast<int>(now - order.begin()) + steps, 0, last);
    select(order[static_cast<std::size_t>(next)]);
    Q_EMIT selectionMoved(selected_);
}

void CostPlot::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    update();
}

void CostPlot::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    update();
}

void CostPlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(hasFocus() ? QPalette::Highlight : QPalette::Base));
}

QByteArray CostPlot::png(const ChartHeading& heading) const {
    return chartPng({chart_, currentPoint(), -1, stale_}, heading, palette());
}

QByteArray CostPlot::svg(const ChartHeading& heading) const {
    return chartSvg({chart_, currentPoint(), -1, stale_}, heading, palette());
}

QSize CostPlot::sizeHint() const {
    return usualPlotSize;
}

QSize CostPlot::minimumSizeHint() const {
    return minSize;
}

} // namespace patina
