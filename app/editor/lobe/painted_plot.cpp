// SPDX-License-Identifier: GPL-3.0-or-later
#include "lobe/painted_plot.h"

#include <QBuffer>
#include <QMouseEvent>
#include <QPainter>
#include <QSvgGenerator>
#include <QToolTip>

#include "text/png.h"

namespace patina {
namespace {

constexpr QSize plotFileSize{960, 600};
constexpr int plotFileScale = 2;
constexpr QSize minPlotSize{180, 120};
constexpr QSize usualPlotSize{480, 260};

} // namespace

PaintedPlot::PaintedPlot(QWidget* parent) : PlotWidget(parent) {
    setMouseTracking(true);
    setMinimumSize(minPlotSize);
}

QByteArray PaintedPlot::png() const {
    QImage image(plotFileSize * plotFileScale, QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(plotFileScale);
    image.fill(palette().color(QPalette::Base));
    QPainter painter(&image);
    painter.setFont(font());
    paint(painter, plotFileSize);
    painter.end();
    return asPng(image);
}

QByteArray PaintedPlot::svg() const {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setSize(plotFileSize);
    generator.setViewBox(QRect(QPoint(), plotFileSize));
    generator.setTitle(accessibleName());
    QPainter painter(&generator);
    painter.setFont(font());
    painter.fillRect(QRect(QPoint(), plotFileSize), palette().color(QPalette::Base));
    paint(painter, plotFileSize);
    painter.end();
    return bytes;
}

QSize PaintedPlot::sizeHint() const {
    return usualPlotSize;
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
