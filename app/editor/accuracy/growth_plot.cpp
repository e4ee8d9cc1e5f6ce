// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/growth_plot.h"

#include <algorithm>
#include <cmath>

#include <QLabel>
#include <QVBoxLayout>

#include "accuracy/axis_ticks.h"
#include "accuracy/plot_colors.h"
#include "accuracy/plot_library.h"
#include "text/display_number.h"
#include "text/mixed_color.h"

namespace patina {
namespace {

constexpr double pointSize = 7.0;
constexpr double margin = 1.3; ///< ratio by which an axis goes beyond its numbers
constexpr int lawSteps = 48;   ///< segments of the law's line, which is curved on log axes
constexpr QSize minGrowthSize{140, 110};

/// Returns whether the bars are intervals of 95 %.
bool isSure(const ScalingCurve& curve) {
    return std::ranges::all_of(curve.samples, &GrowthSample::isSure);
}

/// Writes a number in the artist's locale, in the form that lawText() asks for.
std::string localNumber(double number, char format, int digits) {
    const QString text =
        format == 'g' ? roundText(number) : numberLocale().toString(number, format, digits);
    return text.toStdString();
}

} // namespace

GrowthPlot::GrowthPlot(ScalingCurve::Axis axis, QWidget* parent)
    : PlotWidget(parent), curve_{axis, {}, {}}, plot_(new QCustomPlot(this)),
      line_(plot_->addGraph()), points_(plot_->addGraph()),
      intervals_(new QCPErrorBars(plot_->xAxis, plot_->yAxis)), law_(new QLabel(this)) {
    setAccessibleName(tr("Time against %1").arg(nameOf(axis)));
    plot_->setFocusPolicy(Qt::NoFocus);
    plot_->setMinimumSize(minGrowthSize);
    points_->setLineStyle(QCPGraph::lsNone);
    line_->setAdaptiveSampling(false);
    intervals_->setErrorType(QCPErrorBars::etValueError);
    intervals_->setDataPlottable(points_);
    intervals_->setSymbolGap(pointSize);
    for (QCPAxis* each : {plot_->xAxis, plot_->yAxis}) {
        each->setScaleType(QCPAxis::stLogarithmic);
        each->setSubTicks(false);
    }
    plot_->xAxis->setTicker(QSharedPointer<QCPAxisTicker>(new AxisTicks(*plot_->xAxis, shortText)));
    plot_->yAxis->setTicker(QSharedPointer<QCPAxisTicker>(new AxisTicks(*plot_->yAxis, roundText)));
    plot_->xAxis->setLabel(nameOf(axis));
    plot_->yAxis->setLabel(tr("ms"));
    law_->setWordWrap(true);
    law_->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
    law_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    law_->setMinimumHeight(2 * fontMetrics().lineSpacing());
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(plot_, 1);
    layout->addWidget(law_);
    draw();
}

void GrowthPlot::setCurve(const std::optional<ScalingCurve>& curve, bool stale) {
    curve_ = curve.value_or(ScalingCurve{curve_.axis, {}, {}});
    stale_ = stale;
    draw();
}

QString GrowthPlot::nameOf(ScalingCurve::Axis axis) {
    switch (axis) {
    case ScalingCurve::Axis::Pixels:
        return tr("pixels");
    case ScalingCurve::Axis::Lights:
        return tr("lights");
    default:
        return tr("objects");
    }
}

QString GrowthPlot::law() const {
    return law_->text();
}

void GrowthPlot::draw() {
    points_->data()->clear();
    QVector<double> below;
    QVector<double> above;
    for (const GrowthSample& sample : curve_.samples) {
        const MedianInterval& time = sample.milliseconds;
        points_->addData(sample.count, time.median);
        below << time.median - time.lower;
        above << time.upper - time.median;
    }
    intervals_->setData(below, above);
    drawLaw();
    scaleAxes();
    colour();
    law_->setText(curve_.samples.empty() ? QString()
                                         : QString::fromStdString(lawText(curve_, localNumber)));
    plot_->setToolTip(isSure(curve_) ? QString()
                                     : tr("Hollow points: too few rounds to say how sure they are. "
                                          "Their bars go from the least to the greatest."));
    law_->setEnabled(!stale_);
    setAccessibleDescription(law_->text());
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void GrowthPlot::drawLaw() {
    line_->data()->clear();
    if (!curve_.law || curve_.samples.empty()) {
        return;
    }
    const double from = std::log(curve_.samples.front().count);
    const double to = std::log(curve_.samples.back().count);
    for (int i = 0; i <= lawSteps; ++i) {
        const double count = std::exp(from + (to - from) * i / lawSteps);
        const double time = curve_.law->at(count);
        if (time > 0.0) {
            line_->addData(count, time);
        }
    }
}

void GrowthPlot::scaleAxes() {
    double shortest = HUGE_VAL;
    double longest = 0.0;
    for (const GrowthSample& sample : curve_.samples) {
        shortest = std::min(shortest, std::max(sample.milliseconds.lower, 1e-4));
        longest = std::max(longest, sample.milliseconds.upper);
    }
    const bool isEmpty = !(longest > 0.0);
    const double left = isEmpty ? 1.0 : curve_.samples.front().count / margin;
    const double right = isEmpty ? 100.0 : curve_.samples.back().count * margin;
    const double bottom = isEmpty ? 1.0 : shortest / margin;
    const double top = isEmpty ? 100.0 : longest * margin;
    for (QCPAxis* each : {plot_->xAxis, plot_->yAxis}) {
        each->setTickLabels(!isEmpty);
    }
    plot_->xAxis->setRange(left, right);
    plot_->yAxis->setRange(bottom, top);
}

void GrowthPlot::colour() {
    const QPalette& look = palette();
    colourPlot(*plot_, look, stale_);
    const QColor accent = stale_ ? look.color(QPalette::PlaceholderText)
                                 : look.color(QPalette::Highlight).lighter(115);
    intervals_->setPen(QPen(mixed(look.color(QPalette::Base), look.color(QPalette::Text), 0.45)));
    line_->setPen(QPen(mixed(look.color(QPalette::Base), accent, 0.7), 1.5));
    const QBrush inside(isSure(curve_) ? accent : look.color(QPalette::Base));
    points_->setScatterStyle({QCPScatterStyle::ssCircle, QPen(accent, 1.3), inside, pointSize});
}

} // namespace patina
