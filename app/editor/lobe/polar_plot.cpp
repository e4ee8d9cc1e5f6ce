// SPDX-License-Identifier: GPL-3.0-or-later
#include "lobe/polar_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <QKeyEvent>
#include <QMouseEvent>

#include "accuracy/plot_colors.h"
#include "accuracy/plot_library.h"
#include "text/display_number.h"
#include "text/mixed_color.h"

namespace patina {
namespace {

constexpr double reach = 1.12; ///< radii from the middle to where the disc's labels end
constexpr double below = 0.16; ///< radii below the middle, for labels
constexpr int discSteps = 60;
constexpr int roomyHeight = 260; ///< pixels; below it every second ring has its number

QPointF discPlace(double degrees, double length) {
    const double angle = degrees * std::numbers::pi / 180.0;
    return {length * std::sin(angle), length * std::cos(angle)};
}

/// Returns where a ray has its name: above its end, but not beyond the plot.
QPointF namePlace(double degrees) {
    const double slope = std::abs(std::sin(degrees * std::numbers::pi / 180.0));
    return discPlace(degrees, 1.06) + QPointF(0.0, 0.04 * slope);
}

} // namespace

PolarPlot::PolarPlot(QWidget* parent) : LobePlotWidget(LobePlot::Polar, parent) {
    setObjectName("polarPlot");
    setAccessibleName(tr("Reflectance in the plane of incidence"));
    setFocusPolicy(Qt::StrongFocus);
    for (QCPAxis* axis : {plot().xAxis, plot().yAxis}) {
        axis->setVisible(false);
        axis->grid()->setVisible(false);
    }
    plot().axisRect()->setAutoMargins(QCP::msNone);
    plot().axisRect()->setMargins({0, 0, 0, 0});
    plot().setCursor(Qt::CrossCursor);
    draw();
}

void PolarPlot::setScale(LobeScale scale) {
    scale_ = scale;
    draw();
}

void PolarPlot::setLight(double degrees) {
    light_ = std::clamp(degrees, 0.0, 90.0);
    draw();
}

void PolarPlot::setViewer(std::optional<double> degrees) {
    viewer_ = degrees;
    draw();
}

QString PolarPlot::unit() const {
    return QStringLiteral("1/sr");
}

/// Gives the disc all the room there is, without stretching it.
void PolarPlot::fitRanges() {
    const double width = std::max(plot().viewport().width(), 1);
    const double height = std::max(plot().viewport().height(), 1);
    const double pixels = std::min(width / (2.0 * reach), height / (reach + below));
    plot().xAxis->setRange(-0.5 * width / pixels, 0.5 * width / pixels);
    plot().yAxis->setRange(-below, height / pixels - below);
}

void PolarPlot::addDisc(double largest) {
    const QColor base = palette().color(QPalette::Base);
    const QColor text = palette().color(QPalette::Text);
    const QPen grid(mixed(base, text, 0.14));
    const auto addText = [&](const QPointF& at, const QString& words, Qt::Alignment alignment) {
        auto* item = new QCPItemText(&plot());
        item->position->setCoords(at);
        item->setPositionAlignment(alignment);
        item->setText(words);
        item->setFont(plot().font());
        item->setColor(mixed(base, text, 0.7));
    };
    for (const double length : {0.25, 0.5, 0.75, 1.0}) {
        auto* ring = new QCPCurve(plot().xAxis, plot().yAxis);
        ring->setPen(grid);
        for (int i = 0; i <= discSteps; ++i) {
            const QPointF at = discPlace(180.0 * i / discSteps - 90.0, length);
            ring->addData(i, at.x(), at.y());
        }
        const bool hasRoom = length == 1.0 || length == 0.5 || plot().height() > roomyHeight;
        if (largest > 0.0 && hasRoom) {
            addText(discPlace(90.0, length) + QPointF(0.0, -0.02),
                    roundText(valueAtLength(scale_, length, largest)),
                    Qt::AlignTop | Qt::AlignHCenter);
        }
    }
    for (int degrees = -90; degrees <= 90; degrees += 30) {
        auto* spoke = new QCPCurve(plot().xAxis, plot().yAxis);
        spoke->setPen(grid);
        const QPointF end = discPlace(degrees, 1.0);
        spoke->addData(0.0, 0.0, 0.0);
        spoke->addData(1.0, end.x(), end.y());
        constexpr double labelWidth = 14.0; // degrees that the light's or the viewer's label takes
        const bool isFree = std::abs(degrees + light_) > labelWidth &&
                            (!viewer_ || std::abs(degrees - *viewer_) > labelWidth);
        if (std::abs(degrees) < 90 && isFree) {
            addText(discPlace(degrees, 1.06), QStringLiteral("%1°").arg(std::abs(degrees)),
                    Qt::AlignCenter);
        }
    }
    const QPointF from = discPlace(-light_, 1.0);
    auto* ray = new QCPItemLine(&plot());
    ray->start->setCoords(from);
    ray->end->setCoords(0.0, 0.0);
    ray->setHead(QCPLineEnding::esSpikeArrow);
    ray->setPen(QPen(mixed(base, text, 0.6), 1.2, Qt::DashLine));
    addText(namePlace(-light_), tr("light %1°").arg(roundText(light_)), Qt::AlignCenter);
}

void PolarPlot::addViewer() {
    if (!viewer_) {
        return;
    }
    const QColor color =
        mixed(palette().color(QPalette::Base), palette().color(QPalette::Text), 0.7);
    auto* ray = new QCPItemLine(&plot());
    ray->start->setCoords(0.0, 0.0);
    ray->end->setCoords(discPlace(*viewer_, 1.0));
    ray->setPen(QPen(color, 1.2, Qt::DotLine));
    auto* label = new QCPItemText(&plot());
    label->position->setCoords(namePlace(*viewer_));
    label->setText(tr("viewer"));
    label->setFont(plot().font());
    label->setColor(color);
}

void PolarPlot::draw() {
    plot().clearPlottables();
    plot().clearItems();
    colourPlot(plot(), palette(), false);
    const std::vector<Stroke> lines = strokes();
    double largest = 0.0;
    for (const Stroke& line : lines) {
        for (const double value : line.values) {
            largest = std::max(largest, value);
        }
    }
    addDisc(largest);
    addViewer();
    for (const Stroke& line : lines) {
        auto* curve = new QCPCurve(plot().xAxis, plot().yAxis);
        QVector<QCPCurveData> points;
        points.reserve(static_cast<qsizetype>(line.values.size()));
        for (std::size_t i = 0; i < line.values.size(); ++i) {
            const QPointF at = discPlace(line.at[i], lobeLength(scale_, line.values[i], largest));
            points.push_back({double(i), at.x(), at.y()});
        }
        curve->data()->set(points, true);
        curve->setPen(line.pen);
    }
    addLegend();
    setAccessibleDescription(tr("Light at %1 degrees from the normal").arg(roundText(light_)));
    plot().replot(QCustomPlot::rpQueuedReplot);
}

double PolarPlot::abscissaAt(const QPointF& place) const {
    const QPointF inPlot = plot().mapFrom(this, place);
    const double x = plot().xAxis->pixelToCoord(inPlot.x());
    const double y = plot().yAxis->pixelToCoord(inPlot.y());
    if (y < 0.0 || std::hypot(x, y) > reach) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    return std::atan2(x, y) * 180.0 / std::numbers::pi;
}

QPointF PolarPlot::edgeAt(double degrees) const {
    const QPointF at = discPlace(degrees, 1.0);
    return plot().mapTo(
        this, QPointF(plot().xAxis->coordToPixel(at.x()), plot().yAxis->coordToPixel(at.y())));
}

void PolarPlot::turnTo(double degrees) {
    setLight(degrees);
    Q_EMIT lightTurned(light_);
}

bool PolarPlot::eventFilter(QObject* watched, QEvent* event) {
    const bool isMove = event->type() == QEvent::MouseMove;
    if (watched == &plot() && (isMove || event->type() == QEvent::MouseButtonPress)) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        const bool isDrag =
            isMove ? mouse->buttons().testFlag(Qt::LeftButton) : mouse->button() == Qt::LeftButton;
        const double degrees = abscissaAt(plot().mapTo(this, mouse->position()));
        if (isDrag && std::isfinite(degrees)) {
            setFocus(Qt::MouseFocusReason);
            turnTo(std::round(2.0 * std::abs(degrees)) / 2.0);
        }
    }
    return LobePlotWidget::eventFilter(watched, event);
}

void PolarPlot::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Left:
        return turnTo(light_ + 1.0);
    case Qt::Key_Right:
        return turnTo(light_ - 1.0);
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace patina
