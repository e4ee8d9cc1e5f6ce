// SPDX-License-Identifier: GPL-3.0-or-later
#include "lobe/share_plot.h"

#include <algorithm>
#include <limits>

#include "accuracy/plot_colors.h"
#include "accuracy/plot_library.h"
#include "text/as_text.h"
#include "text/mixed_color.h"

namespace patina {
namespace {

constexpr double headroom = 1.05;

} // namespace

SharePlot::SharePlot(LobePlot kind, QWidget* parent) : LobePlotWidget(parent), kind_(kind) {
    plot().xAxis->setRange(0.0, 90.0);
    plot().xAxis->setLabel(tr("degrees from the normal"));
    QSharedPointer<QCPAxisTickerFixed> ticks(new QCPAxisTickerFixed);
    ticks->setTickStep(15.0);
    plot().xAxis->setTicker(ticks);
    switch (kind) {
    case LobePlot::Fresnel:
        setObjectName("fresnelPlot");
        setAccessibleName(tr("Fresnel reflectance over the angle"));
        plot().yAxis->setLabel(tr("reflected R"));
        plot().yAxis2->setVisible(true);
        plot().yAxis2->setRangeReversed(true);
        plot().yAxis2->setLabel(tr("transmitted T"));
        break;
    case LobePlot::Float32:
        setObjectName("float32Plot");
        setAccessibleName(tr("Error of single precision over the viewer's angle"));
        plot().yAxis->setLabel(tr("units in the last place"));
        plot().xAxis->setRange(-90.0, 90.0);
        break;
    default:
        setObjectName("albedoPlot");
        setAccessibleName(tr("Albedo over the angle of the light"));
        plot().yAxis->setLabel(tr("albedo"));
    }
    draw();
}

QString SharePlot::unit() const {
    return kind_ == LobePlot::Float32 ? tr("ulp") : QString();
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
    if (top > headroom && kind_ != LobePlot::Float32) {
        addLine({0.0, 1.0}, {90.0, 1.0}, QPen(QColor(220, 70, 60), 1.0));
    }
    double height = 0.9 * top; // below the line of 1, which marks would lie on
    for (const LobeSubject& subject : subjects()) {
        for (const LobeMark& mark : subject.lines.marks) {
            addLine({mark.degrees, 0.0}, {mark.degrees, top},
                    QPen(mixed(base, text, 0.35), 1.0, Qt::DashLine));
            auto* label = new QCPItemText(&plot());
            label->position->setCoords(mark.degrees, height);
            label->setPositionAlignment(Qt::AlignTop | Qt::AlignLeft);
            label->setText(
                QStringLiteral(" %1 %2°").arg(asText(mark.name)).arg(mark.degrees, 0, 'f', 2));
            label->setFont(plot().font());
            label->setColor(mixed(base, text, 0.7));
            height -= 0.08 * top;
        }
    }
}

void SharePlot::draw() {
    plot().clearGraphs();
    plot().clearItems();
    colourPlot(plot(), palette(), false);
    const QColor text = palette().color(QPalette::Text);
    plot().yAxis2->setBasePen(plot().yAxis->basePen());
    plot().yAxis2->setTickPen(plot().yAxis->tickPen());
    plot().yAxis2->setSubTickPen(plot().yAxis->tickPen());
    plot().yAxis2->setTickLabelColor(mixed(palette().color(QPalette::Base), text, 0.8));
    plot().yAxis2->setTickLabelFont(plot().font());
    plot().yAxis2->setLabelFont(plot().font());
    plot().yAxis2->setLabelColor(plot().yAxis->labelColor());
    double largest = 1.0;
    for (const Stroke& line : strokes()) {
        QCPGraph* graph = plot().addGraph();
        graph->setPen(line.pen);
        graph->setData(QVector<double>(line.degrees.begin(), line.degrees.end()),
                       QVector<double>(line.values.begin(), line.values.end()), true);
        for (const double value : line.values) {
            largest = std::max(largest, value);
        }
    }
    const double top = headroom * largest;
    addMarks(top);
    addLegend();
    plot().yAxis->setRange(0.0, top);
    plot().yAxis2->setRange(1.0 - top, 1.0);
    plot().replot(QCustomPlot::rpQueuedReplot);
}

double SharePlot::degreesAt(const QPointF& place) const {
    const QPointF inPlot = plot().mapFrom(this, place);
    return plot().axisRect()->rect().contains(inPlot.toPoint())
               ? std::clamp(plot().xAxis->pixelToCoord(inPlot.x()), plot().xAxis->range().lower,
                            90.0)
               : std::numeric_limits<double>::quiet_NaN();
}

} // namespace patina
