// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/comparison_meter.h"

#include <algorithm>
#include <utility>

#include "document/scene_edits.h"
#include "resources/mesh_snapshot.h"
#include "resources/texture_library.h"

namespace patina {
namespace {

constexpr int gatherMs = 60;
constexpr int restMs = 400;
constexpr int longestEdge = 1024; ///< pixels; a larger picture is stretched

} // namespace

ComparisonMeter::ComparisonMeter(const ViewSources& sources, const Viewport& first, QObject* parent)
    : QObject(parent), document_(sources.document), first_(first), meshes_(sources.meshes),
      textures_(sources.textures), environments_(sources.environments), switches_(sources.switches),
      worker_(sources.context.programCache()) {
    settle_.setSingleShot(true);
    settle_.setInterval(gatherMs);
    rest_.setSingleShot(true);
    rest_.setInterval(restMs);
    connect(&settle_, &QTimer::timeout, this, &ComparisonMeter::askFrames);
    connect(&rest_, &QTimer::timeout, this, &ComparisonMeter::rest);
    connect(&worker_, &DifferenceWorker::finished, this, &ComparisonMeter::take);
    const auto changed = [this] { followChange(); };
    onChange(document_, DocumentChange::Drawn | DocumentChange::Current, this, changed);
    connect(&sources.effects, &ProgramEffects::changed, this, changed);
    connect(&textures_, &TextureLibrary::arrived, this, changed);
    connect(&switches_, &EffectSwitches::changed, this, changed);
    connect(&meshes_, &MeshLibrary::loaded, this, changed);
    connect(&meshes_, &MeshLibrary::opennessFound, this, changed);
    connect(&environments_, &EnvironmentLibrary::loaded, this, changed);
    connect(&environments_, &EnvironmentLibrary::failed, this, changed);
    connect(&first, &Viewport::resized, this, changed);
    followChange();
}

void ComparisonMeter::setPictureSize(const QSize& pixels) {
    if (pixels != std::exchange(pictureSize_, pixels)) {
        followChange();
    }
}

/// A drag calls this again and again: a running timer is not restarted, so that the picture
/// follows.
void ComparisonMeter::followChange() {
    giveUp();
    areStale_ = true;
    if (std::exchange(numbers_, {}).distance) {
        Q_EMIT numbersChanged();
    }
    if (!document_.isComparing()) {
        settle_.stop();
        rest_.stop();
        return;
    }
    rest_.start();
    if (!pictureSize_.isEmpty() && !settle_.isActive()) {
        settle_.start();
    }
}

Side ComparisonMeter::other() const {
    return document_.selection().side() == Side::A ? Side::B : document_.selection().side();
}

void ComparisonMeter::giveUp() {
    shown_.reset();
    if (measuring_) {
        measuring_->cancelled = true;
        measuring_.reset();
    }
}

DifferenceWorker::Side ComparisonMeter::sideOf(Side side) {
    const Scene* effects = switches_.effects(side);
    return {switches_.scene(side), effects != nullptr ? std::optional(*effects) : std::nullopt,
            environments_.image(environmentPicture(document_, side))};
}

DifferenceWorker::Request ComparisonMeter::request() {
    const QSizeF pixels = pictureSize_.isEmpty()
                              ? QSizeF(first_.size()) * first_.devicePixelRatioF()
                              : QSizeF(pictureSize_);
    const double shrink =
        std::min(1.0, longestEdge / std::max({pixels.width(), pixels.height(), 1.0}));
    View view;
    view.size = {std::max(1, static_cast<int>(shrink * pixels.width())),
                 std::max(1, static_cast<int>(shrink * pixels.height()))};
    view.camera = first_.camera();
    view.pixelRatio = shrink * first_.devicePixelRatioF();
    return {sideOf(Side::A),
            sideOf(other()),
            view,
            meshSnapshot(document_.scene(), meshes_),
            textures_.snapshot(),
            document_.sharedCatalog()};
}

void ComparisonMeter::askFrames() {
    if (document_.isComparing()) {
        areFramesAsked_ = true;
        areStale_ = false;
        const auto asked = worker_.ask(request());
        if (pictureSize_.isEmpty()) {
            measuring_ = asked; // nobody looks at the frames, so a change may cancel them
        }
    }
}

void ComparisonMeter::take(const DrawnPair& drawn, const QString& problem, bool isLast) {
    areFramesAsked_ = !isLast;
    if (pictureSize_.isEmpty() && (areStale_ || !drawn.frames)) {
        return;
    }
    frames_ = drawn.frames;
    shown_ = drawn.shown;
    problem_ = problem;
    Q_EMIT framesChanged();
    if (!rest_.isActive()) {
        rest();
    }
}

/// Draws stale frames first, then measures the distance, and last the times, which take longest.
void ComparisonMeter::rest() {
    if (areStale_ && !settle_.isActive()) {
        askFrames();
        return;
    }
    if (areFramesAsked_ || !shown_ || !frames_) {
        return;
    }
    const auto timed = [this](const std::optional<TimeRatio>& ratio) {
        if (ratio && numbers_.distance) { // otherwise the frames have changed since
            numbers_.time = ratio;
            Q_EMIT numbersChanged();
        }
    };
    measuring_ = worker_.askDistance(frames_, std::exchange(shown_, nullptr),
                                     [this, timed](const std::optional<PictureDistance>& distance) {
                                         if (distance && !areStale_) {
                                             numbers_ = {other(), distance, std::nullopt};
                                             Q_EMIT numbersChanged();
                                             measuring_ = worker_.askTime(request(), timed);
                                         }
                                     });
}

} // namespace patina
