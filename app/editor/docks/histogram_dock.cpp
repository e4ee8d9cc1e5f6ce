// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/histogram_dock.h"

#include <utility>

#include <QComboBox>
#include <QLabel>
#include <QVBoxLayout>

#include "docks/histogram_plot.h"
#include "docks/panel.h"
#include "document/document.h"
#include "text/display_number.h"
#include "viewport/compare_area.h"

namespace patina {
namespace {

using H = PictureHistogram;

constexpr int pictureRestMs = 150; ///< is how long the picture rests before it is read

QString stopsText(double stops) {
    const QString number = numberLocale().toString(stops, 'f', 1);
    return stops > 0.0 ? "+" + number : number;
}

} // namespace

HistogramDock::HistogramDock(const DockContext& context)
    : document_(context.document), views_(context.views), scale_(new QComboBox(this)),
      plot_(new HistogramPlot(this)), text_(new QLabel(this)) {
    scale_->addItem(tr("As the screen shows it"));
    scale_->addItem(tr("Light, in stops from white"));
    scale_->setToolTip(tr("Count levels from 0 to 255, after the tone curve and picture passes; or "
                          "light after the exposure and before them"));
    text_->setObjectName("histogramText");
    text_->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(labelled(tr("Brightness"), scale_));
    layout->addWidget(plot_, 1);
    layout->addWidget(text_);
    rest_.setSingleShot(true);
    connect(&rest_, &QTimer::timeout, this, &HistogramDock::read);
    connect(scale_, &QComboBox::currentIndexChanged, this, [this] {
        asks_ = true;
        read();
    });
    connect(&views_, &CompareArea::viewAdded, this, &HistogramDock::follow);
    for (SideView* view : views_.views()) {
        follow(view);
    }
    onChange(document_, DocumentChange::Current, this, &HistogramDock::readSoon);
}

/// Further samples of a picture that rests do not put its reading off. One that was to be read
/// while the next sample was drawn is read behind that, before another begins.
void HistogramDock::follow(SideView* view) {
    const FrameLoop& frames = view->viewport().frames();
    connect(&frames, &FrameLoop::frameDrawn, this, [this, view, &frames] {
        const bool isFurther = frames.samples() > 1 && rest_.isActive();
        if (view == &views_.active() && !isFurther) {
            readSoon();
            if (std::exchange(isOwed_, false) && frames.samples() > 1) {
                rest_.start(0);
            }
        }
    });
}

void HistogramDock::showEvent(QShowEvent* event) {
    asks_ = true;
    readSoon();
    QWidget::showEvent(event);
}

void HistogramDock::readSoon() {
    if (isVisible()) {
        rest_.start(pictureRestMs);
    }
}

void HistogramDock::read() {
    if (!isVisible()) {
        return;
    }
    FrameLoop& frames = views_.active().viewport().frames();
    const bool isOfLevels = scale_->currentIndex() == 0;
    const Image picture = frames.shownPicture(isOfLevels);
    if (picture.pixels.empty()) {
        isOwed_ = frames.isDrawing();
        if (asks_ && !isOwed_) {
            asks_ = false;
            frames.refresh(); // the next frame is read
        } else if (!isOwed_) {
            text_->setText(tr("Only the shaded picture is counted."));
        }
        return;
    }
    asks_ = false;
    if (isOfLevels) {
        showLevels(picture);
    } else {
        showStops(picture);
    }
    plot_->setAccessibleDescription(text_->text());
}

void HistogramDock::showLevels(const Image& display) {
    const H histogram = levelHistogram(display);
    const QString clipped =
        histogram.clippedAny == 0.0
            ? tr("No pixel is clipped.")
            : tr("%1 of the pixels are clipped (red %2, green %3, blue %4).")
                  .arg(shareText(histogram.clippedAny), shareText(histogram.clipped[H::Red]),
                       shareText(histogram.clipped[H::Green]),
                       shareText(histogram.clipped[H::Blue]));
    const QString black = histogram.black == 0.0
                              ? QString()
                              : ' ' + tr("%1 are black.").arg(shareText(histogram.black));
    text_->setText(clipped + black);
    plot_->setHistogram(HistogramPlot::Scale::Levels, histogram);
}

void HistogramDock::showStops(const Image& linear) {
    const H histogram = stopHistogram(linear);
    const BrightnessRange range = brightnessOf(histogram);
    text_->setText(
        tr("Half of the pixels are above %1 stops, the brightest at %2; %3 have more "
           "light than white in a channel.")
            .arg(stopsText(range.median), stopsText(range.max), shareText(histogram.clippedAny)));
    plot_->setHistogram(HistogramPlot::Scale::Stops, histogram);
}

} // namespace patina
