// SPDX-License-Identifier: GPL-3.0-or-later
#include "lobe/share_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <QFontMetricsF>

#include "accuracy/plot_colors.h"
#include "accuracy/plot_library.h"
#include "lobe/lobe_subjects.h"
#include "text/as_text.h"
#include "text/display_number.h"
#include "text/mixed_color.h"

namespace patina {
namespace {

constexpr double headroom = 1.05;
constexpr double sampleSize = 7.0; ///< pixels
constexpr double firstUlps = 0.1;  ///< is where a logarithmic axis of errors begins

/// Is the range of wavelengths that a spectrum shows at least, in nanometres.
constexpr double usualFirst = 380.0;
constexpr double usualLast = 780.0;

} // namespace

SharePlot::SharePlot(LobePlot kind, QWidget* parent) : LobePlotWidget(kind, parent) {
    setLegendBeside();
    plot().xAxis->setRange(0.0, 90.0);
    plot().xAxis->setLabel(tr("degrees from the normal"));
    QSharedPointer<QCPAxisTickerFixed> ticks(new QCPAxisTickerFixed);
    ticks->setTickStep(15.0);
    plot().xAxis->setTicker(ticks);
    switch (kind) {
    case LobePlot::Fresnel:
        setObjectName("fresnelPlot");
        setAccessibleName(tr("Fresnel reflectance over the angle"));
        quantity_ = tr("reflected R");
        plot().yAxis2->setVisible(true);
        plot().yAxis2->setRangeReversed(true);
        plot().yAxis2->setLabel(tr("transmitted T"));
        break;
    case LobePlot::Spectrum:
        setObjectName("spectrumPlot");
        setAccessibleName(tr("Index of refraction over the wavelength"));
        plot().xAxis->setLabel(tr("wavelength in nm"));
        plot().xAxis->setTicker(QSharedPointer<QCPAxisTicker>(new QCPAxisTicker));
        quantity_ = tr("index n, extinction k (dashed)");
        plot().yAxis2->setVisible(true);
        plot().yAxis2->setLabel(tr("R facing the surface (dotted)"));
        break;
    case LobePlot::Float32:
        setObjectName("float32Plot");
        setAccessibleName(tr("Error of single precision over the viewer's angle"));
        quantity_ = tr("units in the last place");
        plot().xAxis->setRange(-90.0, 90.0);
        break;
    case LobePlot::Float16:
        setObjectName("float16Plot");
        setAccessibleName(tr("Error of 16 bits over the viewer's angle"));
        quantity_ = tr("units in the last place");
        plot().xAxis->setRange(-90.0, 90.0);
        break;
    default:
        setObjectName("albedoPlot");
        setAccessibleName(tr("Albedo over the angle of the light"));
        quantity_ = tr("albedo");
    }
    draw();
}

QString SharePlot::abscissaText(double at) const {
    return kind() == LobePlot::Spectrum ? tr("%1 nm").arg(roundText(at))
                                        : LobePlotWidget::abscissaText(at);
}

QString SharePlot::unit() const {
    return isOfErrors() ? tr("ulp") : QString();
}

void SharePlot::addMarks(double top) {
    const QColor base = palette().color(QPalette::Base);
    const QColor text = palette().color(QPalette::Text);
    const auto addLine = [this](const QPointF& from, const QPointF& to, const QPen& pen) {
        auto* line = new QCPItemLine(&plot());
        line->start->setCoords(from);
        line->end->setCoords(to);
        line->setPen(pen);
    };
    if (kind() == LobePlot::Albedo) { // red where a material makes light, also beyond the axis' end
        constexpr double rounding = 1e-3;
        const std::vector<Stroke> lines = strokes();
        const bool isAbove = std::ranges::any_of(lines, [](const Stroke& line) {
            return std::ranges::any_of(line.values,
                                       [](double value) { return value > 1.0 + rounding; });
        });
        addLine({0.0, 1.0}, {90.0, 1.0},
                QPen(isAbove ? QColor(220, 70, 60) : mixed(base, text, 0.35), 1.0));
    }
    const double bottom = plot().yAxis->range().lower;
    markNames_.clear();
    std::set<QString> named; // several materials may have the same
    for (std::size_t i = 0; i < subjects().size(); ++i) {
        for (const LobeMark& mark : subjects()[i].lines.marks) {
            if (!named.insert(markText(mark)).second) {
                continue;
            }
            const QColor own = subjects().size() > 1 ? lobeColor(i, palette()) : text;
            addLine({mark.at, bottom}, {mark.at, top},
                    QPen(mixed(base, own, 0.35), 1.0, Qt::DashLine));
            auto* label = new QCPItemText(&plot());
            label->position->setTypeX(QCPItemPosition::ptPlotCoords);
            label->position->setTypeY(QCPItemPosition::ptAbsolute);
            label->position->setCoords(mark.at, 0.0);
            label->setText(markText(mark));
            label->setFont(plot().font());
            label->setColor(mixed(base, own, 0.7));
            label->setBrush(QColor(base.red(), base.green(), base.blue(), 200)); // lines run below
            markNames_.push_back(label);
        }
    }
}

void SharePlot::placeMarkNames() {
    constexpr double gap = 3.0; ///< pixels between names
    const QFontMetricsF metrics(plot().font());
    const QRectF room = plot().axisRect()->rect();
    const double first = room.top() + 0.1 * room.height(); // below the line of 1
    std::vector<QRectF> taken;
    const auto isFree = [&taken](const QRectF& area) {
        return std::ranges::none_of(
            taken, [&area](const QRectF& other) { return other.intersects(area); });
    };
    for (QCPItemText* name : markNames_) {
        const double at = plot().xAxis->coordToPixel(name->position->key());
        const double width = metrics.horizontalAdvance(name->text()) + gap;
        const bool isRight = at + width <= room.right() || at - width < room.left();
        QRectF area(isRight ? at : at - width, first, width, metrics.lineSpacing());
        while (!isFree(area) && area.bottom() + area.height() <= room.bottom()) {
            area.translate(0.0, area.height());
        }
        name->setVisible(isFree(area));
        if (name->visible()) {
            taken.push_back(area);
        }
        name->setPositionAlignment(Qt::AlignTop | (isRight ? Qt::AlignLeft : Qt::AlignRight));
        name->position->setCoords(name->position->key(), area.top());
    }
}

QStringList SharePlot::marksAt(double at) const {
    constexpr double near = 5.0; ///< pixels
    const double reach = near * plot().xAxis->range().size() / plot().axisRect()->width();
    QStringList names;
    for (const LobeSubject& subject : subjects()) {
        for (const LobeMark& mark : subject.lines.marks) {
            const QString text = markText(mark).trimmed();
            if (std::abs(mark.at - at) <= reach) {
                names << (subjects().size() > 1 ? tr("%1: %2").arg(asText(subject.name), text)
                                                : text);
            }
        }
    }
    return names;
}

QString SharePlot::markText(const LobeMark& mark) const {
    return kind() == LobePlot::Spectrum
               ? QStringLiteral(" %1 %2 nm").arg(asText(mark.name), roundText(mark.at))
               : QStringLiteral(" %1 %2°").arg(asText(mark.name)).arg(mark.at, 0, 'f', 2);
}

double SharePlot::fitAxes() {
    double largest = 1.0;
    for (const Stroke& line : strokes()) {
        for (std::size_t i = 0; i < line.values.size(); ++i) {
            const bool isCounted = isOfErrors() || line.at[i] <= roomyDegrees;
            largest = isCounted ? std::max(largest, line.values[i]) : largest;
        }
    }
    const double top = headroom * largest;
    plot().yAxis->setRange(hasLogarithm() ? firstUlps : 0.0, top);
    plot().yAxis2->setRange(1.0 - top, 1.0);
    return top;
}

bool SharePlot::isOfErrors() const {
    return kind() == LobePlot::Float32 || kind() == LobePlot::Float16;
}

/// Tells whether one line's errors would leave another one flat on a linear axis.
bool SharePlot::hasLogarithm() const {
    constexpr double flattened = 20.0;
    double smallest = std::numeric_limits<double>::infinity();
    double largest = 0.0;
    for (const Stroke& line : strokes()) {
        if (!line.values.empty()) {
            const double peak = std::ranges::max(line.values);
            smallest = std::min(smallest, std::max(peak, 1.0));
            largest = std::max(largest, peak);
        }
    }
    return isOfErrors() && largest > flattened * smallest;
}

/// An index that hardly bends is to be seen to bend, so its axis need not begin at 0. Above the
/// lines is room for the names of the marks.
double SharePlot::fitSpectrum() {
    double smallest = std::numeric_limits<double>::infinity();
    double largest = 0.0;
    double largestShare = 0.0;
    double first = usualFirst;
    double last = usualLast;
    for (const Stroke& line : strokes()) {
        const auto [low, high] = std::ranges::minmax(line.values);
        if (line.isShare) {
            largestShare = std::max(largestShare, high);
        } else {
            smallest = std::min(smallest, low);
            largest = std::max(largest, high);
        }
        first = std::min(first, line.at.front());
        last = std::max(last, line.at.back());
    }
    plot().xAxis->setRange(first, last);
    plot().yAxis2->setRange(0.0, largestShare > 0.0 ? 1.6 * largestShare : headroom);
    if (smallest > largest) { // there are no lines
        plot().yAxis->setRange(0.0, headroom);
        return headroom;
    }
    const double spread = std::max(largest - smallest, 0.02);
    const double top = largest + 0.6 * spread;
    plot().yAxis->setRange(std::max(smallest - 0.25 * spread, 0.0), top);
    return top;
}

void SharePlot::draw() {
    plot().clearGraphs();
    plot().clearItems();
    const QString label = axisText(quantity_);
    plot().yAxis->setLabel(isOfErrors() ? QString(label).replace(", ", ",\n")
                                        : label); // it is long
    colourPlot(plot(), palette(), false);
    const QColor text = palette().color(QPalette::Text);
    plot().yAxis2->setBasePen(plot().yAxis->basePen());
    plot().yAxis2->setTickPen(plot().yAxis->tickPen());
    plot().yAxis2->setSubTickPen(plot().yAxis->tickPen());
    plot().yAxis2->setTickLabelColor(mixed(palette().color(QPalette::Base), text, 0.8));
    plot().yAxis2->setTickLabelFont(plot().font());
    plot().yAxis2->setLabelFont(plot().font());
    plot().yAxis2->setLabelColor(plot().yAxis->labelColor());
    const bool isSpectrum = kind() == LobePlot::Spectrum;
    const bool isLogarithmic = hasLogarithm();
    if (isOfErrors()) {
        plot().yAxis->setScaleType(isLogarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
        plot().yAxis->setTicker(isLogarithmic ? QSharedPointer<QCPAxisTicker>(new QCPAxisTickerLog)
                                              : QSharedPointer<QCPAxisTicker>(new QCPAxisTicker));
    }
    for (Stroke& line : strokes()) {
        for (double& value : line.values) {
            value = isLogarithmic ? std::max(value, firstUlps) : value;
        }
        const bool isRight = isSpectrum && line.isShare;
        QCPGraph* graph = plot().addGraph(plot().xAxis, isRight ? plot().yAxis2 : plot().yAxis);
        QPen pen = line.pen;
        if (isRight) {
            pen = QPen(pen.color(), 1.0, Qt::DotLine);
        }
        graph->setPen(pen);
        if (line.isSampled) {
            graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, sampleSize));
        }
        graph->setData(QVector<double>(line.at.begin(), line.at.end()),
                       QVector<double>(line.values.begin(), line.values.end()), true);
    }
    addMarks(isSpectrum ? fitSpectrum() : fitAxes());
    addLegend();
    plot().replot(QCustomPlot::rpQueuedReplot);
}

double SharePlot::abscissaAt(const QPointF& place) const {
    const QPointF inPlot = plot().mapFrom(this, place);
    return plot().axisRect()->rect().contains(inPlot.toPoint())
               ? std::clamp(plot().xAxis->pixelToCoord(inPlot.x()), plot().xAxis->range().lower,
                            plot().xAxis->range().upper)
               : std::numeric_limits<double>::quiet_NaN();
}

} // namespace patina
