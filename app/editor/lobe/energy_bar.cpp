// SPDX-License-Identifier: GPL-3.0-or-later
#include "lobe/energy_bar.h"

#include <algorithm>

#include <QPainter>

#include "core/color.h"
#include "measure/lobe/lobe_lines.h"
#include "text/display_number.h"
#include "text/mixed_color.h"

namespace patina {
namespace {

constexpr int barHeight = 14;

double strongest(const glm::dvec3& v) {
    return std::max({v.x, v.y, v.z});
}

double weakest(const glm::dvec3& v) {
    return std::min({v.x, v.y, v.z});
}

} // namespace

EnergyBar::EnergyBar(QWidget* parent) : QWidget(parent) {
    setObjectName("energyBar");
    setAccessibleName(tr("Energy"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void EnergyBar::setRange(const EnergyRange& range, const std::optional<EnergyRange>& luminance) {
    range_ = range;
    luminance_ = luminance;
    why_.clear();
    refresh();
}

void EnergyBar::setNothing(const QString& why) {
    range_.reset();
    why_ = why;
    refresh();
}

void EnergyBar::setName(const QString& name) {
    name_ = name;
    refresh();
}

void EnergyBar::refresh() {
    setToolTip(text());
    setAccessibleDescription(text());
    update();
}

QString EnergyBar::text() const {
    const auto named = [this](const QString& words) {
        return name_.isEmpty() || words.isEmpty() ? words : tr("%1: %2").arg(name_, words);
    };
    if (!range_) {
        return named(why_);
    }
    return named(isAboveOne() ? tr("%1: more than arrives").arg(rangeText()) : rangeText());
}

/// Says of what the numbers are where channels differ: of which one, or of the luminance.
QString EnergyBar::rangeText() const {
    const EnergyRange& range = shown();
    const auto text = [](const glm::dvec3& v, double number) {
        const bool isGrey = strongest(v) - weakest(v) < albedoNoise;
        const QString channels[] = {tr("red"), tr("green"), tr("blue")};
        const int channel = number == v.x ? 0 : number == v.y ? 1 : 2;
        return isGrey ? shareText(number) : tr("%1 (%2)").arg(shareText(number), channels[channel]);
    };
    const QString numbers =
        tr("Reflects %1 at least, %2 of an even sky, %3 at most")
            .arg(text(range.min, weakest(range.min)), shareText(luminance(range.mean)),
                 text(range.max, strongest(range.max)));
    if (!luminance_) {
        return numbers;
    }
    const QString inLuminance = tr("%1, in luminance").arg(numbers);
    const bool isHidden = isAboveOne() && strongest(range.max) <= 1.0 + albedoNoise;
    return isHidden ? tr("%1; %2").arg(inLuminance, text(range_->max, strongest(range_->max)))
                    : inLuminance;
}

bool EnergyBar::isAboveOne() const {
    return range_ && strongest(range_->max) > 1.0 + albedoNoise;
}

QSize EnergyBar::sizeHint() const {
    return {200, barHeight + fontMetrics().lineSpacing() + 4};
}

void EnergyBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QColor base = palette().color(QPalette::Base);
    const QColor ink = palette().color(QPalette::Text);
    const QRectF bar(0.0, 1.0, width() - 1.0, barHeight - 2.0);
    painter.fillRect(bar, mixed(base, ink, 0.12));
    if (range_) {
        paintRange(painter, bar);
    }
    painter.setPen(ink);
    painter.drawText(QRect(0, barHeight, width(), height() - barHeight),
                     Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(text(), Qt::ElideRight, width()));
}

void EnergyBar::paintRange(QPainter& painter, const QRectF& bar) const {
    const EnergyRange& range = shown();
    const double end = std::max(1.0, strongest(range_->max));
    const auto place = [&](double share) { return bar.left() + bar.width() * share / end; };
    const auto fill = [&](double from, double to, const QColor& color) {
        painter.fillRect(QRectF(place(from), bar.top(), place(to) - place(from), bar.height()),
                         color);
    };
    fill(weakest(range.min), std::min(strongest(range.max), 1.0),
         palette().color(QPalette::Highlight));
    if (isAboveOne()) {
        fill(1.0, strongest(range_->max), QColor(220, 70, 60));
    }
    painter.setPen(QPen(palette().color(QPalette::Text), 2.0));
    const double mean = place(luminance(range.mean));
    painter.drawLine(QPointF(mean, bar.top()), QPointF(mean, bar.bottom()));
}

} // namespace patina
