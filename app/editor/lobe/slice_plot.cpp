// SPDX-License-Identifier: GPL-3.0-or-later
#include "lobe/slice_plot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QFontMetricsF>
#include <QPainter>

#include "lobe/lobe_subjects.h"
#include "text/as_text.h"
#include "text/display_number.h"
#include "text/mixed_color.h"

namespace patina {
namespace {

constexpr double degreesOfRadian = 180.0 / std::numbers::pi;
constexpr double gap = 14.0; ///< pixels between squares

double whiteOf(const std::vector<NamedSlice>& slices) {
    std::vector<const HalfDifferenceSlice*> all;
    for (const NamedSlice& each : slices) {
        all.push_back(&each.slice);
    }
    return patina::whiteOf(all);
}

QImage pictureOf(const HalfDifferenceSlice& slice, LobeScale scale, double white) {
    QImage picture(slice.size, slice.size, QImage::Format_RGB32);
    const auto level = [](double shown) { return static_cast<int>(std::lround(255.0 * shown)); };
    for (int row = 0; row < slice.size; ++row) {
        for (int column = 0; column < slice.size; ++column) {
            const glm::dvec3 color = shownColor(slice.at(column, row), scale, white);
            picture.setPixel(column, slice.size - 1 - row,
                             qRgb(level(color.x), level(color.y), level(color.z)));
        }
    }
    return picture;
}

} // namespace

SlicePlot::SlicePlot(QWidget* parent) : PaintedPlot(parent) {
    setObjectName("slicePlot");
    setAccessibleName(tr("Reflectance over half and difference angle"));
}

void SlicePlot::setScale(LobeScale scale) {
    scale_ = scale;
    draw();
}

void SlicePlot::setSlices(std::vector<NamedSlice> slices) {
    slices_ = std::move(slices);
    draw();
}

QRectF SlicePlot::squareOf(std::size_t material, const QSizeF& size) const {
    const QFontMetricsF text(font());
    const auto count = static_cast<double>(std::max<std::size_t>(slices_.size(), 1));
    const double left = text.horizontalAdvance(QStringLiteral("90°")) + 10.0;
    const double top = text.height() + 6.0;
    const double bottom = 2.0 * text.height() + 8.0;
    const double edge = std::max(
        std::min((size.width() - left - gap * count) / count, size.height() - top - bottom), 1.0);
    return {left + static_cast<double>(material) * (edge + gap), top, edge, edge};
}

void SlicePlot::paint(QPainter& painter, const QSizeF& size) const {
    const QColor base = palette().color(QPalette::Base);
    const QColor ink = mixed(base, palette().color(QPalette::Text), 0.8);
    const double line = QFontMetricsF(font()).height();
    const double white = whiteOf(slices_);
    if (std::ranges::all_of(slices_, [](const NamedSlice& each) { return each.slice.size == 0; })) {
        return;
    }
    for (std::size_t i = 0; i < slices_.size(); ++i) {
        const QRectF square = squareOf(i, size);
        if (slices_[i].slice.size > 0) {
            painter.drawImage(square, pictureOf(slices_[i].slice, scale_, white));
        }
        painter.setPen(mixed(base, palette().color(QPalette::Text), 0.4));
        painter.drawRect(square);
        painter.setPen(slices_.size() > 1 ? lobeColor(i, palette()) : ink);
        painter.drawText(QRectF(square.left(), 0.0, square.width(), square.top()),
                         Qt::AlignLeft | Qt::AlignVCenter, asText(slices_[i].name));
        painter.setPen(ink);
        for (int degrees = i == 0 ? 0 : 30; degrees <= 90; degrees += 30) { // 0 would lie on 90
            const double along = square.width() * degrees / 90.0;
            const QString text = QStringLiteral("%1°").arg(degrees);
            const QRectF below(square.left() + along - 20.0, square.bottom() + 2.0, 40.0, line);
            painter.drawText(below, Qt::AlignCenter, text);
            if (i == 0) {
                const QRectF beside(0.0, square.bottom() - along - 0.5 * line, square.left() - 6.0,
                                    line);
                painter.drawText(beside, Qt::AlignRight | Qt::AlignVCenter, text);
            }
        }
    }
    const QRectF first = squareOf(0, size);
    const QString what = tr("right: half vector from the normal · up: light from the half "
                            "vector · white: %1 1/sr or more")
                             .arg(roundText(white));
    painter.drawText(
        QRectF(first.left(), first.bottom() + line + 4.0, size.width() - first.left(), line + 2.0),
        Qt::AlignLeft | Qt::AlignVCenter, what);
}

QSize SlicePlot::fileSize() const {
    const QSize largest = PaintedPlot::fileSize();
    const double textBelow = 2.0 * QFontMetricsF(font()).height() + 12.0;
    const double height = squareOf(0, largest).bottom() + textBelow;
    return {largest.width(), std::min(static_cast<int>(std::ceil(height)), largest.height())};
}

QString SlicePlot::readingAt(const QPointF& place) const {
    for (std::size_t i = 0; i < slices_.size(); ++i) {
        const QRectF square = squareOf(i);
        if (!square.contains(place)) {
            continue;
        }
        if (slices_[i].slice.size == 0) {
            return {};
        }
        const int cells = slices_[i].slice.size;
        const auto cell = [cells](double share) {
            return std::clamp(static_cast<int>(share * cells), 0, cells - 1);
        };
        const int half = cell((place.x() - square.left()) / square.width());
        const int difference = cell((square.bottom() - place.y()) / square.height());
        QStringList lines{
            tr("half vector %1° from the normal, light %2° from the half vector")
                .arg(roundText(slices_[i].slice.angleOf(half) * degreesOfRadian),
                     roundText(slices_[i].slice.angleOf(difference) * degreesOfRadian))};
        for (const NamedSlice& each : slices_) {
            if (each.slice.size != cells) {
                continue;
            }
            lines << tr("%1: %2 1/sr")
                         .arg(asText(each.name), valueText(each.slice.at(half, difference)));
        }
        return lines.join('\n');
    }
    return {};
}

} // namespace patina
