// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/difference_worker.h"

#include <chrono>
#include <utility>

#include "render/frame/frame_job.h"
#include "scene/environment.h"
#include "text/as_text.h"

namespace patina {
namespace {

/// How long the context is kept for the next frames.
constexpr std::chrono::seconds patience{3};

/// Work between two looks at whether the window goes.
constexpr std::chrono::milliseconds slice{20};

constexpr int sampledDirections = 64; ///< of an environment's light, the same on both sides

/// How many directions of an environment's light a side's own view has; 0: there is none.
int ownDirections(const Scene& scene, const Catalog& catalog) {
    const Block* block = blockOf(scene.parts, kinds::environment, catalog);
    return block != nullptr ? directionsOf(*scene.part(kinds::environment), *block) : 0;
}

} // namespace

/// A renderer, and the blocks that it knows.
class DifferenceWorker::Workshop {
  public:
    explicit Workshop(std::unique_ptr<Renderer> renderer) : renderer_(std::move(renderer)) {}

    Result<FrameDifference> draw(const Request& request, const Worker::Control& control) {
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
        return b ? Result<FrameDifference>(differenceOf(*a, *b)) : tl::unexpected(b.error());
    }

  private:
    /// In whole floats, where the sides do not differ in their numbers.
    Result<Image> picture(const Side& side, const Request& request, int directions,
                          const Worker::Control& control) {
        const bool sameNumbers = request.a.scene.accuracy.hasWholeNumbers() ==
                                 request.b.scene.accuracy.hasWholeNumbers();
        View view = request.view;
        view.numbers = sameNumbers ? HdrNumbers::Full : HdrNumbers::Half;
        view.effects = side.effects ? &*side.effects : nullptr;
        for (int drawn = 0; drawn < directions || drawn == 0;) {
            view.isContinued = drawn > 0;
            view.environmentSamples = directions - drawn;
            if (auto begun = drawFrame(side.scene, view, request.meshes, control); !begun) {
                return tl::unexpected(begun.error());
            }
            const int before = std::exchange(drawn, renderer_->job().environmentSamples());
            const bool isEnough = drawn >= sampledDirections && control.isSuperseded();
            if (drawn <= before || isEnough) { // no environment, or no more of it
                break;
            }
        }
        return renderer_->job().read(false);
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
      worker_({.priority = QThread::LowPriority, // the views come first
               .patience = patience,
               .atRest = [this] { workshop_.reset(); }}) {}

DifferenceWorker::~DifferenceWorker() = default;

void DifferenceWorker::ask(Request request) {
    worker_.ask([this, request = std::move(request)](
                    const Worker::Control& control) { return draw(request, control); },
                [this](const Answer& answer) {
                    Q_EMIT finished(answer.value_or(nullptr),
                                    answer ? QString() : asText(answer.error().text()));
                },
                QStringLiteral("frames"));
}

/// In the worker's thread.
DifferenceWorker::Answer DifferenceWorker::draw(const Request& request,
                                                const Worker::Control& control) {
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
    return workshop_->draw(request, control).map([](FrameDifference difference) {
        return std::make_shared<const FrameDifference>(std::move(difference));
    });
}

} // namespace patina
