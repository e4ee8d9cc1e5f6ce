// SPDX-License-Identifier: GPL-3.0-or-later
#include "lobe/painted_plot.h"

#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include "text/png.h"
#include "text/svg.h"

namespace patina {
namespace {

constexpr int paintedFileScale = 2;
constexpr QSize minPaintedSize{180, 120};
constexpr QSize usualPaintedSize{480, 260};

} // namespace

PaintedPlot::PaintedPlot(QWidget* parent) : PlotWidget(parent) {
    setMouseTracking(true);
    setMinimumSize(minPaintedSize);
}

QSize PaintedPlot::fileSize() const {
    return {960, 600};
}

QByteArray PaintedPlot::png() const {
    QImage image(fileSize() * paintedFileScale, QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(paintedFileScale);
    image.fill(palette().color(QPalette::Base));
    QPainter painter(&image);
    painter.setFont(font());
    paint(painter, fileSize());
    painter.end();
    return asPng(image);
}

QByteArray PaintedPlot::svg() const {
    return asSvg(fileSize(), accessibleName(), {}, [this](QPaintDevice& device) {
        QPainter painter(&device);
        painter.setFont(font());
        painter.fillRect(QRect(QPoint(), fileSize()), palette().color(QPalette::Base));
        paint(painter, fileSize());
    });
}

QSize PaintedPlot::sizeHint() const {
    return usualPaintedSize;
}

void PaintedPlot::draw() {
    update();
}

void PaintedPlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    paint(painter, size());
}

void PaintedPlot::mouseMoveEvent(QMouseEvent* event) {
    QToolTip::showText(event->globalPosition().toPoint(), readingAt(event->position()), this);
}

} // namespace patina
