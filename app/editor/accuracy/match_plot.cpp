// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/match_plot.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QMouseEvent>
#include <QToolTip>
#include <QVBoxLayout>

#include "accuracy/axis_ticks.h"
#include "accuracy/plot_colors.h"
#include "accuracy/plot_library.h"
#include "text/as_text.h"
#include "text/display_number.h"
#include "text/mixed_color.h"

namespace patina {
namespace {

constexpr double minMatchPercent = 1e-3; ///< a smaller error is none on the log axis
constexpr double minMatchTime = 1e-3;    ///< nanoseconds
constexpr double edgeRatio = 1.5;        ///< by which an axis goes beyond its numbers
constexpr double dotSize = 8.0;
constexpr int nearDot = 9; ///< pixels from a point that the pointer may be away
constexpr QSize minMatchPlot{160, 110};
constexpr QSize usualMatchPlot{420, 180};

QPointF numbersOf(const ModelMatch& match) {
    return {std::max(match.nanoseconds.value_or(0.0), minMatchTime),
            std::max(100.0 * match.relative, minMatchPercent)};
}

} // namespace

MatchPlot::MatchPlot(std::function<void(int match)> pick, QWidget* parent)
    : PlotWidget(parent), pick_(std::move(pick)), plot_(new QCustomPlot(this)),
      front_(plot_->addGraph()), beaten_(plot_->addGraph()), limit_(plot_->addGraph()) {
    setObjectName("matchPlot");
    setAccessibleName(tr("Time against relative error of the fitted models"));
    plot_->setFocusPolicy(Qt::NoFocus);
    plot_->setMouseTracking(true);
    plot_->setMinimumSize(minMatchPlot);
    plot_->installEventFilter(this);
    beaten_->setLineStyle(QCPGraph::lsNone);
    for (QCPAxis* each : {plot_->xAxis, plot_->yAxis}) {
        each->setScaleType(QCPAxis::stLogarithmic);
        each->setSubTicks(false);
        each->setTicker(QSharedPointer<QCPAxisTicker>(new AxisTicks(*each, roundText)));
    }
    plot_->xAxis->setLabel(tr("ns/pixel"));
    plot_->yAxis->setLabel(tr("relative error in %"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(plot_);
    draw();
}

void MatchPlot::setMatches(const ModelMatches& matches, double within, bool stale) {
    matches_ = matches;
    within_ = within;
    stale_ = stale;
    draw();
}

void MatchPlot::fitAxes() {
    double shortest = HUGE_VAL;
    double longest = 0.0;
    double min = 100.0 * std::max(within_, 1e-6);
    double max = min;
    for (const ModelMatch& match : matches_.rows) {
        if (match.nanoseconds) {
            const QPointF at = numbersOf(match);
            shortest = std::min(shortest, at.x());
            longest = std::max(longest, at.x());
            min = std::min(min, at.y());
            max = std::max(max, at.y());
        }
    }
    const bool isEmpty = !(longest > 0.0);
    plot_->xAxis->setRange(isEmpty ? 1.0 : shortest / edgeRatio,
                           isEmpty ? 100.0 : longest * edgeRatio);
    plot_->yAxis->setRange(min / edgeRatio, max * edgeRatio);
}

void MatchPlot::draw() {
    for (QCPGraph* graph : {front_, beaten_, limit_}) {
        graph->data()->clear();
    }
    for (const ModelMatch& match : matches_.rows) {
        if (match.nanoseconds) {
            const QPointF at = numbersOf(match);
            (match.isOnFront ? front_ : beaten_)->addData(at.x(), at.y());
        }
    }
    fitAxes();
    for (const double end : {plot_->xAxis->range().lower, plot_->xAxis->range().upper}) {
        limit_->addData(end, 100.0 * std::max(within_, 1e-6));
    }
    const QPalette& look = palette();
    colourPlot(*plot_, look, stale_);
    const QColor base = look.color(QPalette::Base);
    const QColor accent = stale_ ? look.color(QPalette::PlaceholderText)
                                 : look.color(QPalette::Highlight).lighter(115);
    const QColor faint = mixed(base, look.color(QPalette::Text), 0.5);
    front_->setPen(QPen(mixed(base, accent, 0.7), 1.5));
    front_->setScatterStyle({QCPScatterStyle::ssCircle, QPen(accent, 1.3), accent, dotSize});
    beaten_->setScatterStyle({QCPScatterStyle::ssCircle, QPen(faint, 1.3), base, dotSize});
    limit_->setPen(QPen(faint, 1.0, Qt::DashLine));
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

QPoint MatchPlot::placeOf(std::size_t match) const {
    const QPointF at = numbersOf(matches_.rows[match]);
    return plot_
        ->mapTo(this,
                QPointF(plot_->xAxis->coordToPixel(at.x()), plot_->yAxis->coordToPixel(at.y())))
        .toPoint();
}

int MatchPlot::matchAt(const QPoint& place) const {
    int nearest = -1;
    int distance = nearDot;
    for (std::size_t i = 0; i < matches_.rows.size(); ++i) {
        const int away = (placeOf(i) - place).manhattanLength();
        if (matches_.rows[i].nanoseconds && away < distance) {
            nearest = static_cast<int>(i);
            distance = away;
        }
    }
    return nearest;
}

QString MatchPlot::readingAt(const QPoint& place) const {
    const int match = matchAt(place);
    if (match < 0) {
        return {};
    }
    const ModelMatch& read = matches_.rows[static_cast<std::size_t>(match)];
    return tr("%1: %2 %, %3 ns/pixel")
        .arg(asText(read.label), roundText(100.0 * read.relative), roundText(*read.nanoseconds));
}

bool MatchPlot::eventFilter(QObject* watched, QEvent* event) {
    if (watched == plot_ &&
        (event->type() == QEvent::MouseMove || event->type() == QEvent::MouseButtonPress)) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        const QPoint place = plot_->mapTo(this, mouse->position()).toPoint();
        const int match = matchAt(place);
        if (event->type() == QEvent::MouseMove) {
            QToolTip::showText(mouse->globalPosition().toPoint(), readingAt(place), this);
        } else if (match >= 0) {
            pick_(match);
        }
    }
    return false;
}

QSize MatchPlot::sizeHint() const {
    return usualMatchPlot;
}

} // namespace patina
