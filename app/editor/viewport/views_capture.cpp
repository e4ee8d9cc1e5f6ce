// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/views_capture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QPainter>

#include "viewport/difference_view.h"

namespace patina {
namespace {

constexpr int channels = 3;
constexpr double titleLines = 2.0; ///< of text, as high as a title is

float* pixelOf(Image& image, int x, int y) {
    return image.pixels.data() + channels * (std::size_t(y) * std::size_t(image.width) + x);
}

/// Lays a picture onto another one. An alpha is left out: views show none.
void paste(const Image& picture, Image& onto, glm::ivec2 corner) {
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const std::size_t place = std::size_t(y) * std::size_t(picture.width) + x;
            const float* from = picture.pixels.data() + place * std::size_t(picture.channels);
            std::copy_n(from, channels, pixelOf(onto, corner.x + x, corner.y + y));
        }
    }
}

Image blank(int width, int height) {
    const std::size_t count = std::size_t(width) * std::size_t(height) * channels;
    return {width, height, channels, std::vector<float>(count, 0.0f)};
}

/// The picture of a side below its letter and caption, as large as they are on a screen of so many
/// pixels to a point.
Image titled(const Image& picture, const QString& letter, const QString& caption,
             const QColor& colour, const QWidget& view) {
    const double scale = view.devicePixelRatioF();
    const QFontMetricsF metrics(view.font());
    const double height = titleLines * metrics.height();
    QImage title(picture.width, static_cast<int>(std::ceil(height * scale)), QImage::Format_RGB888);
    title.fill(colour.darker(260));
    title.setDevicePixelRatio(scale);
    QPainter painter(&title);
    QFont bold = view.font();
    bold.setBold(true);
    painter.setPen(QColor(0xf0, 0xf0, 0xf0));
    painter.setFont(bold);
    const double margin = 0.5 * metrics.height();
    painter.drawText(QRectF(margin, 0, height, height), Qt::AlignVCenter, letter);
    painter.setFont(view.font());
    const double left = margin + height;
    const double room = picture.width / scale - left - margin;
    painter.drawText(QRectF(left, 0, room, height), Qt::AlignVCenter,
                     metrics.elidedText(caption, Qt::ElideRight, room));
    painter.end();
    Image both = blank(picture.width, title.height() + picture.height);
    paste(asImage(title), both, {0, 0});
    paste(picture, both, {0, title.height()});
    return both;
}

} // namespace

Image asImage(const QImage& picture) {
    const QImage plain = picture.convertToFormat(QImage::Format_RGB888);
    Image image = blank(plain.width(), plain.height());
    for (int y = 0; y < plain.height(); ++y) {
        const uchar* line = plain.constScanLine(y);
        std::transform(line, line + std::ptrdiff_t(channels) * plain.width(), pixelOf(image, 0, y),
                       [](uchar value) { return float(value) / 255.0f; });
    }
    return image;
}

Image inARow(const std::vector<Image>& pictures) {
    int width = 0;
    int height = 0;
    for (const Image& picture : pictures) {
        width += picture.width;
        height = std::max(height, picture.height);
    }
    Image row = blank(width, height);
    int left = 0;
    for (const Image& picture : pictures) {
        paste(picture, row, {left, 0});
        left += picture.width;
    }
    return row;
}

ViewsCapture::ViewsCapture(CompareArea& views) : QObject(&views), views_(views) {}

void ViewsCapture::start(bool display, PictureCapture::Taken taken) {
    SideView* second = views_.second();
    PictureCapture& ofFirst = views_.first().viewport().capture();
    if (!second || second->isHidden()) {
        ofFirst.start(display, std::move(taken));
        return;
    }
    ofFirst.start(display, [this, second, display, taken = std::move(taken)](Image first) {
        if (first.pixels.empty()) {
            taken({});
            return;
        }
        second->viewport().capture().start(
            display, [this, display, taken, first = std::move(first)](Image other) mutable {
                taken(other.pixels.empty()
                          ? Image()
                          : besideEachOther(std::move(first), std::move(other), display));
            });
    });
}

void ViewsCapture::cancel() {
    views_.first().viewport().capture().cancel();
    if (views_.second()) {
        views_.second()->viewport().capture().cancel();
    }
}

Image ViewsCapture::besideEachOther(Image first, Image second, bool display) const {
    if (!display) {
        return inARow({std::move(first), std::move(second)});
    }
    const int height = first.height;
    const auto titledSide = [](const Image& picture, SideView& view) {
        return titled(picture, letterOf(view.side()), view.caption(), colourOf(view.side()), view);
    };
    std::vector<Image> pictures{titledSide(first, views_.first()),
                                titledSide(second, *views_.second())};
    const DifferenceView* difference = views_.difference();
    if (difference && !difference->isHidden() && !difference->picture().isNull()) {
        const QImage shown = difference->picture().scaledToHeight(height, Qt::SmoothTransformation);
        pictures.push_back(titled(asImage(shown), QStringLiteral("C"), difference->caption(),
                                  QColor(0x90, 0x90, 0x90), *difference));
    }
    return inARow(pictures);
}

} // namespace patina
