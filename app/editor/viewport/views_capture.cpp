// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/views_capture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QPainter>

#include "viewport/composed_view.h"
#include "viewport/difference_view.h"

namespace patina {
namespace {

constexpr int channels = 3;
constexpr double titleLines = 2.0; ///< lines of text that a title is high

float* pixelOf(Image& image, int x, int y) {
    return image.pixels.data() + channels * (std::size_t(y) * std::size_t(image.width) + x);
}

/// Copies a picture onto another one. An alpha channel is left out, as views show none.
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

/// Returns the picture of a side below its letter and caption, which have the size that they have
/// on the view's screen.
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

Image inAColumn(const std::vector<Image>& pictures) {
    int width = 0;
    int height = 0;
    for (const Image& picture : pictures) {
        width = std::max(width, picture.width);
        height += picture.height;
    }
    Image column = blank(width, height);
    int top = 0;
    for (const Image& picture : pictures) {
        paste(picture, column, {0, top});
        top += picture.height;
    }
    return column;
}

ViewsCapture::ViewsCapture(CompareArea& views) : QObject(&views), views_(views) {}

void ViewsCapture::start(bool display, PictureCapture::Taken taken,
                         const PictureCapture::SceneChange& change) {
    const CompareMode mode = views_.look().mode;
    const bool isOne = mode == CompareMode::Wipe || mode == CompareMode::Onion;
    if (!change && display && isOne && views_.composed() && !views_.composed()->isHidden()) {
        taken(asImage(views_.composed()->grab().toImage()));
        return;
    }
    startEach(
        display,
        [this, display, taken = std::move(taken),
         isShown = !change](std::vector<SidePictureTaken> pictures) {
            if (pictures.empty()) {
                taken({});
            } else if (pictures.size() == 1) {
                taken(std::move(pictures.front().picture));
            } else {
                taken(asTheyStand(std::move(pictures), display, isShown));
            }
        },
        change);
}

void ViewsCapture::startEach(bool display, const EachTaken& taken,
                             const PictureCapture::SceneChange& change) {
    std::vector<SideView*> shown;
    for (SideView* view : views_.views()) {
        if (!view->isHidden()) {
            shown.push_back(view);
        }
    }
    if (shown.empty()) {
        shown.push_back(&views_.first()); // only the difference is shown
    }
    goOn(std::move(shown), {}, display, taken, change);
}

void ViewsCapture::goOn(std::vector<SideView*> rest, std::vector<SidePictureTaken> done,
                        bool display, const EachTaken& taken,
                        const PictureCapture::SceneChange& change) {
    if (rest.empty()) {
        taken(std::move(done));
        return;
    }
    SideView* next = rest.front();
    rest.erase(rest.begin());
    next->viewport().capture().start(
        display,
        [this, next, rest = std::move(rest), done = std::move(done), display, taken,
         change](Image picture) mutable {
            if (picture.pixels.empty()) {
                taken({});
                return;
            }
            done.push_back({next->side(), next->caption(), std::move(picture)});
            goOn(std::move(rest), std::move(done), display, taken, change);
        },
        change);
}

void ViewsCapture::cancel() {
    for (SideView* view : views_.views()) {
        view->viewport().capture().cancel();
    }
}

Image ViewsCapture::asTheyStand(std::vector<SidePictureTaken> pictures, bool display,
                                bool hasDifference) const {
    const int height = pictures.front().picture.height;
    std::vector<Image> upper;
    std::vector<Image> lower;
    const ViewArrangement arrangement = views_.look().arrangement;
    for (SidePictureTaken& each : pictures) {
        const bool isBelow = arrangement == ViewArrangement::Grid && each.side > Side::B;
        (isBelow ? lower : upper)
            .push_back(display ? titled(each.picture, letterOf(each.side), each.caption,
                                        colourOf(each.side), views_)
                               : std::move(each.picture));
    }
    const DifferenceView* difference = views_.difference();
    if (hasDifference && display && difference && !difference->isHidden() &&
        !difference->picture().isNull()) {
        const QImage shown = difference->picture().scaledToHeight(height, Qt::SmoothTransformation);
        upper.push_back(titled(asImage(shown), QStringLiteral("\u0394"), difference->caption(),
                               QColor(0x90, 0x90, 0x90), *difference));
    }
    if (arrangement == ViewArrangement::Column) {
        return inAColumn(upper);
    }
    return lower.empty() ? inARow(upper) : inAColumn({inARow(upper), inARow(lower)});
}

} // namespace patina
