// SPDX-License-Identifier: GPL-3.0-or-later
#include "lobe/lobe_plot_widget.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QMouseEvent>
#include <QToolTip>
#include <QVBoxLayout>

#include "accuracy/plot_library.h"
#include "accuracy/plot_svg.h"
#include "lobe/lobe_subjects.h"
#include "text/as_text.h"
#include "text/display_number.h"
#include "text/png.h"

namespace patina {
namespace {

constexpr QSize plotFileSize{960, 600};
constexpr double plotFileScale = 2.0;
constexpr QSize minPlotSize{180, 120};
constexpr QSize usualLobeSize{480, 260};
constexpr double legendGap = 8.0; ///< pixels between the legend and the plot's edges
constexpr double lineWidth = 1.6;

QPen penOf(const LobeLine& line, const QColor& color) {
    QColor own = color;
    if (line.isFromInside) {
        own.setAlphaF(0.6);
    }
    const bool isThin = line.stroke != LobeStroke::Main && line.stroke != LobeStroke::Extinction;
    QPen pen(own, isThin ? 1.0 : lineWidth);
    if (line.stroke != LobeStroke::Main) {
        pen.setStyle(line.stroke == LobeStroke::Along ? Qt::DotLine : Qt::DashLine);
    }
    return pen;
}

/// Adds the places between two points, a few pixels apart.
void addPlaces(std::vector<QPointF>& all, const QPointF& from, const QPointF& to) {
    constexpr double apart = 4.0;
    constexpr double longest = 1e4; ///< pixels; a line may lead far out of the plot
    const QPointF way = to - from;
    const double length = std::hypot(way.x(), way.y());
    if (!(length < longest)) {
        return;
    }
    const int steps = std::max(static_cast<int>(length / apart), 1);
    for (int i = 0; i <= steps; ++i) {
        all.push_back(from + way * (static_cast<double>(i) / steps));
    }
}

/// Returns the area of a text in pixels.
QRectF areaOf(const QCPItemText& text) {
    const QSizeF size = QFontMetricsF(text.font()).size(0, text.text());
    const Qt::Alignment alignment = text.positionAlignment();
    const QPointF at = text.position->pixelPosition();
    const double left = alignment.testFlag(Qt::AlignRight)  ? size.width()
                        : alignment.testFlag(Qt::AlignLeft) ? 0.0
                                                            : 0.5 * size.width();
    const double above = alignment.testFlag(Qt::AlignBottom) ? size.height()
                         : alignment.testFlag(Qt::AlignTop)  ? 0.0
                                                             : 0.5 * size.height();
    return {at - QPointF(left, above), size};
}

/// Returns places on the lines and the texts of a plot, in pixels, without those of its legend.
std::vector<QPointF> inkedPlaces(QCustomPlot& plot, const std::vector<QCPItemText*>& legend) {
    std::vector<QPointF> all;
    for (int i = 0; i < plot.plottableCount(); ++i) {
        auto* drawn = qobject_cast<QCPAbstractPlottable*>(plot.plottable(i));
        const auto* data = drawn->interface1D();
        for (int point = 1; data != nullptr && point < data->dataCount(); ++point) {
            addPlaces(all, data->dataPixelPosition(point - 1), data->dataPixelPosition(point));
        }
    }
    for (int i = 0; i < plot.itemCount(); ++i) {
        auto* text = qobject_cast<QCPItemText*>(plot.item(i));
        if (text != nullptr && text->visible() && std::ranges::find(legend, text) == legend.end()) {
            const QRectF area = areaOf(*text);
            for (const double share : {0.1, 0.5, 0.9}) { // a text counts as lines close together
                const double y = area.top() + share * area.height();
                addPlaces(all, {area.left(), y}, {area.right(), y});
            }
        }
    }
    return all;
}

} // namespace

LobePlotWidget::LobePlotWidget(LobePlot kind, QWidget* parent)
    : PlotWidget(parent), kind_(kind), plot_(new QCustomPlot(this)) {
    plot_->setFocusPolicy(Qt::NoFocus);
    plot_->setMouseTracking(true);
    plot_->setMinimumSize(minPlotSize);
    plot_->installEventFilter(this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(1, 1, 1, 1); // leaves room for the focus frame
    layout->addWidget(plot_);
    connect(plot_, &QCustomPlot::afterLayout, this, [this] {
        fitRanges();
        placeLegend();
    });
}

void LobePlotWidget::setSubjects(std::vector<LobeSubject> subjects) {
    subjects_ = std::move(subjects);
    draw();
}

void LobePlotWidget::setDetails(QStringList details) {
    details_ = std::move(details);
    draw();
}

std::vector<LobePlotWidget::Stroke> LobePlotWidget::strokes() const {
    std::vector<Stroke> all;
    const bool isAlone = subjects_.size() == 1;
    for (std::size_t i = 0; i < subjects_.size(); ++i) {
        for (const LobeLine& line : subjects_[i].lines.lines) {
            const bool hasChannels = isAlone && !isGrey(line);
            for (int channel = 0; channel < (hasChannels ? 3 : 1); ++channel) {
                const QColor color =
                    hasChannels ? channelColor(channel, palette()) : lobeColor(i, palette());
                Stroke stroke{line.at, {}, penOf(line, color), line.isShare, line.isSampled};
                stroke.values.reserve(line.values.size());
                for (const glm::dvec3& v : line.values) {
                    stroke.values.push_back(hasChannels ? v[channel] : overlaidValue(kind_, v));
                }
                all.push_back(std::move(stroke));
            }
        }
    }
    return all;
}

QString LobePlotWidget::abscissaText(double at) const {
    return tr("%1° from the normal").arg(roundText(std::abs(at)));
}

QString LobePlotWidget::axisText(const QString& what) const {
    const std::string_view word = overlaidWord(kind_, subjects_);
    return word.empty() ? what : tr("%1, %2").arg(what, asText(word));
}

QString LobePlotWidget::numberText(const LobeLine& line, double at) const {
    const glm::dvec3 v = valueAt(line, at);
    if (isGrey(line)) {
        return line.digits > 0 ? numberLocale().toString(v.x, 'g', line.digits) : roundText(v.x);
    }
    const QString channels =
        QStringLiteral("%1, %2, %3").arg(roundText(v.x), roundText(v.y), roundText(v.z));
    return subjects_.size() < 2 ? channels
                                : tr("%1 %2 (%3)")
                                      .arg(asText(overlaidWord(kind_, subjects_)),
                                           roundText(overlaidValue(kind_, v)), channels);
}

QString LobePlotWidget::readingAt(const QPointF& place) const {
    const double at = abscissaAt(place);
    if (!std::isfinite(at)) {
        return {};
    }
    QStringList lines{abscissaText(at)};
    lines += marksAt(at);
    const auto isPolarised = [](const LobeLine& line) {
        return line.stroke == LobeStroke::Across || line.stroke == LobeStroke::Along;
    };
    for (const LobeSubject& subject : subjects_) {
        for (const LobeLine& line : subject.lines.lines) {
            // The polarised lines of several materials would hide the plot.
            if (line.values.empty() || (subjects_.size() > 1 && isPolarised(line))) {
                continue;
            }
            QString reading = tr("%1, %2: %3 %4")
                                  .arg(asText(subject.name), asText(line.name),
                                       numberText(line, at), line.isShare ? QString() : unit())
                                  .trimmed();
            if (const auto passed = transmittedLine(line)) {
                const QString name = asText(passed->name).section(' ', -1);
                reading += tr(", %1: %2").arg(name, numberText(*passed, at));
            }
            lines << reading;
        }
    }
    return lines.size() > 1 ? lines.join('\n') : QString();
}

QSize LobePlotWidget::sizeHint() const {
    return usualLobeSize;
}

void LobePlotWidget::addLegend() {
    legend_.clear(); // its items went with the plot's others
    const bool isWanted = subjects_.size() > 1 || !details_.isEmpty();
    for (std::size_t i = 0; i < subjects_.size() && isWanted; ++i) {
        const QString detail = details_.value(static_cast<qsizetype>(i));
        auto* name = new QCPItemText(plot_);
        name->position->setType(QCPItemPosition::ptAbsolute);
        name->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
        name->setText(asText(subjects_[i].name) +
                      (subjects_[i].lines.lines.empty() ? tr(": no line") : QString()) +
                      (detail.isEmpty() ? QString() : QStringLiteral(", ") + detail));
        name->setTextAlignment(Qt::AlignLeft);
        name->setFont(plot_->font());
        name->setColor(lobeColor(i, palette()));
        legend_.push_back(name);
    }
    makeRoomForLegend();
}

void LobePlotWidget::setLegendBeside() {
    beside_ = new QCPLayoutElement(plot_);
    plot_->plotLayout()->addElement(0, 1, beside_);
    makeRoomForLegend();
}

/// Gives the legend a column of the layout, where the plot has at least as much left of it.
void LobePlotWidget::makeRoomForLegend() {
    if (beside_ == nullptr) {
        return;
    }
    const int wanted = static_cast<int>(std::ceil(legendSize().width()));
    const int width = 2 * wanted > plot_->width() ? 0 : wanted;
    beside_->setMinimumSize(width, 0);
    beside_->setMaximumSize(width, QWIDGETSIZE_MAX);
}

QSizeF LobePlotWidget::legendSize() const {
    const QFontMetricsF metrics(plot_->font());
    double width = 0.0;
    for (const QCPItemText* name : legend_) {
        width = std::max(width, metrics.horizontalAdvance(name->text()) + 2.0);
    }
    return {width, metrics.lineSpacing() * static_cast<double>(legend_.size())};
}

/// Moves the legend beside the plot, or else to where it lies on as little as may be: a corner, or
/// between two.
void LobePlotWidget::placeLegend() {
    if (legend_.empty()) {
        return;
    }
    const bool isBeside = beside_ != nullptr && beside_->rect().width() > 0;
    QPointF place = isBeside ? QPointF(beside_->rect().topLeft()) : emptyPlace();
    for (QCPItemText* name : legend_) {
        name->position->setCoords(place);
        name->setClipToAxisRect(!isBeside);
        place.ry() += QFontMetricsF(plot_->font()).lineSpacing();
    }
}

QPointF LobePlotWidget::emptyPlace() const {
    const QSizeF size = legendSize();
    const QRectF room =
        QRectF(plot_->axisRect()->rect()).adjusted(legendGap, legendGap, -legendGap, -legendGap);
    const std::vector<QPointF> inked = inkedPlaces(*plot_, legend_);
    QPointF place = room.topLeft();
    auto minCovered = std::numeric_limits<std::ptrdiff_t>::max();
    for (const QPointF share :
         {QPointF(0, 0), QPointF(1, 0), QPointF(0, 1), QPointF(1, 1), QPointF(0.5, 0),
          QPointF(0, 0.5), QPointF(1, 0.5), QPointF(0.5, 1), QPointF(0.5, 0.5)}) {
        const QRectF tried(
            QPointF(room.left() + share.x() * std::max(room.width() - size.width(), 0.0),
                    room.top() + share.y() * std::max(room.height() - size.height(), 0.0)),
            size);
        const auto covered = std::ranges::count_if(
            inked, [&tried](const QPointF& each) { return tried.contains(each); });
        if (covered < minCovered) {
            minCovered = covered;
            place = tried.topLeft();
        }
    }
    return place;
}

bool LobePlotWidget::eventFilter(QObject* watched, QEvent* event) {
    if (watched == plot_ && event->type() == QEvent::Resize) {
        makeRoomForLegend();
    }
    if (watched == plot_ && event->type() == QEvent::MouseMove) {
        const auto* move = static_cast<QMouseEvent*>(event);
        const QPointF place = plot_->mapTo(this, move->position());
        QToolTip::showText(move->globalPosition().toPoint(), readingAt(place), this);
    }
    return false;
}

QByteArray LobePlotWidget::png() const {
    const QPixmap drawn =
        plot_->toPixmap(plotFileSize.width(), plotFileSize.height(), plotFileScale);
    plot_->replot(); // lays the widget out again
    return asPng(drawn.toImage());
}

QByteArray LobePlotWidget::svg() const {
    QByteArray drawn = plotSvg(*plot_, plotFileSize);
    plot_->replot(); // lays the widget out again
    return drawn;
}

} // namespace patina
