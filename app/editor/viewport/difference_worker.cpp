// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/difference_worker.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "measure/time/choice_cost.h"
#include "measure/time/timed_frames.h"
#include "render/frame/frame_job.h"
#include "scene/environment.h"
#include "text/as_text.h"

namespace patina {
namespace {

/// The context is kept for so long for the next frames.
constexpr std::chrono::seconds patience{3};

/// A frame works for so long before it checks whether it was cancelled.
constexpr std::chrono::milliseconds slice{20};

/// Counts the environment directions per side, where both sides would take equally many.
constexpr int sampledDirections = 64;

constexpr int timedEdge = 640; ///< pixels; limits the longer edge of a frame that is timed
constexpr double timedMilliseconds = 60.0; ///< a frame that takes longer is made smaller
constexpr std::chrono::milliseconds timedFor{1000};
constexpr CostPairs::Options timedPairs{.width = 0.02, .min = 7, .max = 40};

/// Returns how many directions of an environment's light a side's own view takes; 0 without an
/// environment.
int ownDirections(const Scene& scene, const Catalog& catalog) {
    const Block* block = blockOf(scene.parts, kinds::environment, catalog);
    return block != nullptr ? directionsOf(*scene.part(kinds::environment), *block) : 0;
}

} // namespace

/// Holds a renderer and the blocks that it was given last.
class DifferenceWorker::Workshop {
  public:
    explicit Workshop(std::unique_ptr<Renderer> renderer) : renderer_(std::move(renderer)) {}

    Result<DrawnPair> draw(const Request& request, const Worker::Control& control) {
        if (catalog_ != request.catalog) {
            catalog_ = request.catalog;
            renderer_->setCatalog(catalog_);
        }
        renderer_->setTextures(request.textures);
        const int ofA = ownDirections(request.a.scene, *request.catalog);
        const int ofB = ownDirections(request.b.scene, *request.catalog);
        auto a = picture(request.a, request, ofA == ofB ? sampledDirections : ofA, control);
        if (!a) {
            return tl::unexpected(a.error());
        }
        auto b = picture(request.b, request, ofA == ofB ? sampledDirections : ofB, control);
        if (!b) {
            return tl::unexpected(b.error());
        }
        FrameDifference difference = differenceOf(a->linear, b->linear);
        return DrawnPair{
            std::make_shared<const ComparedFrames>(
                ComparedFrames{std::move(a->linear), std::move(b->linear), std::move(difference)}),
            std::make_shared<const ShownPair>(ShownPair{std::move(a->shown), std::move(b->shown)})};
    }

  private:
    struct Picture {
        Image linear;
        Image shown;
    };

    /// Draws a side in 32-bit floats, or in half floats where the sides differ in their number
    /// format.
    Result<Picture> picture(const Side& side, const Request& request, int directions,
                            const Worker::Control& control) {
        const bool sameNumbers = request.a.scene.accuracy.hasWholeNumbers() ==
                                 request.b.scene.accuracy.hasWholeNumbers();
        View view = request.view;
        view.numbers = sameNumbers ? HdrNumbers::Full : HdrNumbers::Half;
        view.effects = side.effects ? &*side.effects : nullptr;
        view.environmentImage = side.environment;
        for (int drawn = 0; drawn < directions || drawn == 0;) {
            view.isContinued = drawn > 0;
            view.environmentSamples = directions - drawn;
            if (auto begun = drawFrame(side.scene, view, request.meshes, control); !begun) {
                return tl::unexpected(begun.error());
            }
            const int before = std::exchange(drawn, renderer_->job().environmentSamples());
            const bool isEnough = drawn >= sampledDirections && control.isSuperseded();
            if (drawn <= before || isEnough) { // there is no environment, or no more of it
                break;
            }
        }
        auto linear = renderer_->job().read(false);
        auto shown = renderer_->job().read(true);
        return linear && shown ? Result<Picture>(Picture{std::move(*linear), std::move(*shown)})
                               : tl::unexpected(linear ? shown.error() : linear.error());
    }

    Result<void> drawFrame(const Scene& scene, const View& view, const MeshSource& meshes,
                           const Worker::Control& control) {
        FrameJob& job = renderer_->begin(scene, view, meshes, FramePurpose::Capture);
        while (job.step(slice) == FrameJob::Progress::More) {
            if (control.isCancelled()) {
                return failure("the window has gone");
            }
        }
        return job.failure() ? tl::unexpected(*job.failure()) : Result<void>();
    }

    std::unique_ptr<Renderer> renderer_;
    std::shared_ptr<const Catalog> catalog_;
};

DifferenceWorker::DifferenceWorker(std::filesystem::path programCache, QObject* parent)
    : QObject(parent), programCache_(std::move(programCache)),
      worker_({.name = tr("Comparing the views"),
               .priority = QThread::LowPriority, // the views come first
               .patience = patience,
               .atRest = [this] { workshop_.reset(); }}) {}

DifferenceWorker::~DifferenceWorker() = default;

std::shared_ptr<Progress> DifferenceWorker::ask(Request request) {
    return worker_.ask([this, request = std::move(request)](
                           const Worker::Control& control) { return draw(request, control); },
                       [this, number = ++asked_](const Result<DrawnPair>& answer) {
                           Q_EMIT finished(answer.value_or(DrawnPair()),
                                           answer ? QString() : asText(answer.error().text()),
                                           number == asked_);
                       },
                       QStringLiteral("frames"));
}

std::shared_ptr<Progress>
DifferenceWorker::askDistance(std::shared_ptr<const ComparedFrames> frames,
                              std::shared_ptr<const ShownPair> shown,
                              std::function<void(const std::optional<PictureDistance>&)> done) {
    return worker_.ask(
        [frames = std::move(frames), shown = std::move(shown)](const Worker::Control& control) {
            return pictureDistance(frames->difference.relative, shown->a, shown->b,
                                   [&control] { return control.isCancelled(); });
        },
        [done = std::move(done)](const Result<std::optional<PictureDistance>>& answer) {
            done(answer.value_or(std::nullopt));
        },
        QStringLiteral("distance"));
}

std::shared_ptr<Progress>
DifferenceWorker::askTime(Request request,
                          std::function<void(const std::optional<TimeRatio>&)> done) {
    return worker_.ask([this, request = std::move(request)](
                           const Worker::Control& control) { return time(request, control); },
                       [done = std::move(done)](const Result<std::optional<TimeRatio>>& answer) {
                           done(answer.value_or(std::nullopt));
                       },
                       QStringLiteral("time"));
}

/// Runs in the worker's thread.
Result<DrawnPair> DifferenceWorker::draw(const Request& request, const Worker::Control& control) {
    if (!workshop_) {
        if (const auto opened = control.openContext(); !opened) {
            return tl::unexpected(opened.error());
        }
        auto renderer = Renderer::create({programCache_});
        if (!renderer) {
            return tl::unexpected(renderer.error());
        }
        workshop_ = std::make_unique<Workshop>(std::move(*renderer));
    }
    return workshop_->draw(request, control);
}

/// Runs in the worker's thread.
std::optional<TimeRatio> DifferenceWorker::time(const Request& request,
                                                const Worker::Control& control) {
    if (!control.openContext()) {
        return std::nullopt;
    }
    const glm::ivec2 whole = request.view.size;
    const double share = std::min(1.0, double(timedEdge) / std::max(whole.x, whole.y));
    const auto sized = [&](double factor) {
        return glm::max(glm::ivec2(glm::dvec2(whole) * factor), glm::ivec2(1));
    };
    auto frames = TimedFrames::create({request.catalog, request.meshes, request.textures},
                                      sized(share), programCache_);
    if (!frames) {
        return std::nullopt;
    }
    const auto timeOf = [&](const Side& side) {
        View view = request.view;
        view.effects = side.effects ? &*side.effects : nullptr;
        view.environmentImage = side.environment;
        return (*frames)->timeOf(side.scene, view);
    };
    timeOf(request.a); // loads meshes and makes programs, so that timing does not include them
    timeOf(request.b);
    const double longest = std::max(timeOf(request.a), timeOf(request.b));
    if (longest > timedMilliseconds) {
        (*frames)->resize(sized(share * std::sqrt(timedMilliseconds / longest)));
    }
    CostPairs pairs(timedPairs, {});
    const auto end = std::chrono::steady_clock::now() + timedFor;
    const auto isEnough = [&] {
        return pairs.finished() ||
               (pairs.runs() >= timedPairs.min && std::chrono::steady_clock::now() > end);
    };
    while (!isEnough()) {
        if (control.isCancelled()) {
            return std::nullopt;
        }
        const double first = timeOf(request.a);
        pairs.add(first, timeOf(request.b));
    }
    return TimeRatio{pairs.cost().ratio, pairs.runs()};
}

} // namespace patina
