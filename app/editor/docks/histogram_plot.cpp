// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/histogram_plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include "text/display_number.h"
#include "text/mixed_color.h"

namespace patina {
namespace {

using H = PictureHistogram;

constexpr double clipBar = 4.0;        ///< pixels, width of the bar of what is clipped
constexpr double clipShareSeen = 5e-4; ///< is the smallest clipped share that has a bar

struct LineColor {
    H::Channel channel;
    QColor color;
};

const std::array<LineColor, 3> lineColors{{{H::Red, QColor(214, 69, 65)},
                                           {H::Green, QColor(60, 160, 80)},
                                           {H::Blue, QColor(70, 120, 220)}}};

/// Limits the share at the top, in those of a bin where all have as many pixels.
constexpr double maxEvenShares = 4.0;

/// Is a mark below the plot: its bin and what is written there.
struct Mark {
    double bin;
    QString text;
};

std::vector<Mark> marksOf(HistogramPlot::Scale scale) {
    std::vector<Mark> marks;
    if (scale == HistogramPlot::Scale::Levels) {
        for (const int level : {0, 64, 128, 192, 255}) {
            marks.push_back({level + 0.5, QString::number(level)});
        }
        return marks;
    }
    for (int stop = minStop; stop <= maxStop; stop += 2) {
        marks.push_back({double(stop - minStop) * binsPerStop,
                         stop > 0 ? QString("+%1").arg(stop) : QString::number(stop)});
    }
    return marks;
}

} // namespace

HistogramPlot::HistogramPlot(QWidget* parent) : QWidget(parent) {
    setObjectName("histogram");
    setAccessibleName(tr("Histogram"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void HistogramPlot::setHistogram(Scale scale, std::optional<PictureHistogram> histogram) {
    scale_ = scale;
    histogram_ = std::move(histogram);
    findHighest();
    update();
}

/// Leaves the two ends out, which have all that lies outside of the range, and lets an even
/// background go through the top.
void HistogramPlot::findHighest() {
    highest_ = 0.0;
    if (histogram_) {
        for (const H::Channel channel : {H::Red, H::Green, H::Blue, H::Luminance}) {
            for (std::size_t bin = 1; bin + 1 < histogram_->counts[channel].size(); ++bin) {
                highest_ = std::max(highest_, histogram_->share(channel, bin));
            }
        }
    }
    const double even = histogram_ ? 1.0 / double(histogram_->counts[H::Luminance].size()) : 1.0;
    highest_ = highest_ > 0.0 ? std::min(highest_, maxEvenShares * even) : 1.0;
}

QSize HistogramPlot::sizeHint() const {
    return {320, 140};
}

QSize HistogramPlot::minimumSizeHint() const {
    return {120, 60};
}

QRectF HistogramPlot::area() const {
    const int below = fontMetrics().lineSpacing() + 2;
    const int beside = fontMetrics().horizontalAdvance("+6") / 2 + 2;
    return QRectF(rect()).adjusted(beside, 2, -beside - 1, -below);
}

double HistogramPlot::place(double bin) const {
    const auto bins = static_cast<double>(histogram_->counts[H::Luminance].size());
    return area().left() + area().width() * bin / bins;
}

QPolygonF HistogramPlot::outline(H::Channel channel) const {
    const QRectF within = area();
    QPolygonF line;
    line << QPointF(within.left(), within.bottom());
    for (std::size_t bin = 0; bin < histogram_->counts[channel].size(); ++bin) {
        const double share = std::min(histogram_->share(channel, bin) / highest_, 1.0);
        line << QPointF(place(static_cast<double>(bin) + 0.5),
                        within.bottom() - std::sqrt(share) * within.height());
    }
    line << QPointF(within.right(), within.bottom());
    return line;
}

void HistogramPlot::paintGrid(QPainter& painter) const {
    const QColor base = palette().color(QPalette::Base);
    const QColor ink = palette().color(QPalette::Text);
    const QRectF within = area();
    for (const Mark& mark : marksOf(scale_)) {
        const double x = place(mark.bin);
        painter.setPen(mixed(base, ink, 0.15));
        painter.drawLine(QPointF(x, within.top()), QPointF(x, within.bottom()));
        painter.setPen(mixed(base, ink, 0.7));
        painter.drawText(QRectF(x - 30.0, within.bottom() + 1.0, 60.0, height() - within.bottom()),
                         Qt::AlignHCenter | Qt::AlignTop, mark.text);
    }
    if (scale_ == Scale::Stops) {
        const double white = place(double(-minStop) * binsPerStop);
        painter.setPen(QPen(ink, 1.0, Qt::DashLine));
        painter.drawLine(QPointF(white, within.top()), QPointF(white, within.bottom()));
    }
}

/// A bar for each channel that is clipped stands at the right end, in its colour.
void HistogramPlot::paintClipping(QPainter& painter) const {
    const QRectF within = area();
    const double height = within.height() / static_cast<double>(lineColors.size());
    for (std::size_t i = 0; i < lineColors.size(); ++i) {
        if (histogram_->clipped[lineColors[i].channel] > clipShareSeen) {
            painter.fillRect(QRectF(within.right() - clipBar,
                                    within.top() + static_cast<double>(i) * height, clipBar,
                                    height),
                             lineColors[i].color);
        }
    }
}

void HistogramPlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QColor base = palette().color(QPalette::Base);
    const QColor ink = palette().color(QPalette::Text);
    painter.fillRect(area(), base);
    if (!histogram_) {
        return;
    }
    paintGrid(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(mixed(base, ink, 0.3));
    painter.drawPolygon(outline(H::Luminance));
    painter.setBrush(Qt::NoBrush);
    for (const LineColor& line : lineColors) {
        painter.setPen(QPen(line.color, 1.2));
        painter.drawPolyline(outline(line.channel));
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
    paintClipping(painter);
}

QString HistogramPlot::textAt(const QPoint& place) const {
    const QRectF within = area();
    if (!histogram_ || !within.contains(place)) {
        return {};
    }
    const std::size_t bins = histogram_->counts[H::Luminance].size();
    const double share = (place.x() - within.left()) / within.width();
    const std::size_t bin =
        std::min(static_cast<std::size_t>(share * static_cast<double>(bins)), bins - 1);
    const QString part = shareText(histogram_->share(H::Luminance, bin));
    if (scale_ == Scale::Levels) {
        return tr("Level %1: %2 of the pixels").arg(bin).arg(part);
    }
    const double stop = minStop + (static_cast<double>(bin) + 0.5) / binsPerStop;
    return tr("%1 stops from white: %2 of the pixels")
        .arg(numberLocale().toString(stop, 'f', 2), part);
}

bool HistogramPlot::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        QToolTip::showText(help->globalPos(), textAt(help->pos()), this);
        return true;
    }
    return QWidget::event(event);
}

} // namespace patina
