// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/difference_worker.h"

#include <chrono>
#include <functional>
#include <utility>

#include "background/free_memory.h"
#include "gl/headless_context.h"
#include "render/frame/frame_job.h"
#include "scene/environment.h"

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

/// What a worker wants of the work.
struct Course {
    std::function<bool()> goesOn;
    std::function<bool()> isHurried;
};

} // namespace

/// A context with a renderer in it.
class DifferenceWorker::Workshop {
  public:
    static Result<std::unique_ptr<Workshop>> open(const std::filesystem::path& programCache) {
        auto context = gl::HeadlessContext::create();
        if (!context) {
            return tl::unexpected(context.error());
        }
        auto renderer = Renderer::create({programCache});
        if (!renderer) {
            return tl::unexpected(renderer.error());
        }
        auto shop = std::make_unique<Workshop>();
        shop->context_ = std::move(*context);
        shop->renderer_ = std::move(*renderer);
        return shop;
    }

    Result<FrameDifference> draw(const Request& request, const Course& course) {
        if (catalog_ != request.catalog) {
            catalog_ = request.catalog;
            renderer_->setCatalog(catalog_);
        }
        renderer_->setTextures(request.textures);
        const int ofA = ownDirections(request.a.scene, *request.catalog);
        const int ofB = ownDirections(request.b.scene, *request.catalog);
        auto a = picture(request.a, request, ofA == ofB ? sampledDirections : ofA, course);
        if (!a) {
            return tl::unexpected(a.error());
        }
        auto b = picture(request.b, request, ofA == ofB ? sampledDirections : ofB, course);
        return b ? Result<FrameDifference>(differenceOf(*a, *b)) : tl::unexpected(b.error());
    }

  private:
    /// In whole floats, where the sides do not differ in their numbers.
    Result<Image> picture(const Side& side, const Request& request, int directions,
                          const Course& course) {
        const bool sameNumbers = request.a.scene.accuracy.hasWholeNumbers() ==
                                 request.b.scene.accuracy.hasWholeNumbers();
        View view = request.view;
        view.numbers = sameNumbers ? HdrNumbers::Full : HdrNumbers::Half;
        view.effects = side.effects ? &*side.effects : nullptr;
        for (int drawn = 0; drawn < directions || drawn == 0;) {
            view.isContinued = drawn > 0;
            view.environmentSamples = directions - drawn;
            if (auto begun = drawFrame(side.scene, view, request.meshes, course); !begun) {
                return tl::unexpected(begun.error());
            }
            const int before = std::exchange(drawn, renderer_->job().environmentSamples());
            const bool isEnough = drawn >= sampledDirections && course.isHurried();
            if (drawn <= before || isEnough) { // no environment, or no more of it
                break;
            }
        }
        return renderer_->job().read(false);
    }

    Result<void> drawFrame(const Scene& scene, const View& view, const MeshSource& meshes,
                           const Course& course) {
        FrameJob& job = renderer_->begin(scene, view, meshes, FramePurpose::Capture);
        while (job.step(slice) == FrameJob::Progress::More) {
            if (!course.goesOn()) {
                return failure("the window has gone");
            }
        }
        return job.failure() ? tl::unexpected(*job.failure()) : Result<void>();
    }

    std::unique_ptr<gl::HeadlessContext> context_;
    std::unique_ptr<Renderer> renderer_;
    std::shared_ptr<const Catalog> catalog_;
};

DifferenceWorker::DifferenceWorker(std::filesystem::path programCache, QObject* parent)
    : QObject(parent), programCache_(std::move(programCache)) {
    worker_.setPriority(QThread::LowPriority); // the views come first
    connect(&worker_, &BackgroundJob::finished, this, &DifferenceWorker::wake);
}

DifferenceWorker::~DifferenceWorker() {
    {
        const std::lock_guard lock(mutex_);
        isEnding_ = true;
    }
    news_.notify_all();
}

void DifferenceWorker::ask(Request request) {
    {
        const std::lock_guard lock(mutex_);
        job_ = Job{++asked_, std::move(request)};
    }
    news_.notify_all();
    wake();
}

void DifferenceWorker::wake() {
    const std::lock_guard lock(mutex_);
    if (job_) {
        worker_.start([this](BackgroundJob::Control&) {
            work();
            return endOf(true, {});
        });
    }
}

void DifferenceWorker::hurry() {
    const std::lock_guard lock(mutex_);
    isHurried_ = true;
}

/// The next frames; nothing when there were none for a while.
std::optional<DifferenceWorker::Job> DifferenceWorker::next() {
    std::unique_lock lock(mutex_);
    news_.wait_for(lock, patience, [this] { return isEnding_ || job_; });
    if (isEnding_ || !job_) {
        return std::nullopt;
    }
    isHurried_ = false;
    return std::exchange(job_, std::nullopt);
}

void DifferenceWorker::work() {
    auto shop = Workshop::open(programCache_);
    const Course course{[this] {
                            const std::lock_guard lock(mutex_);
                            return !isEnding_;
                        },
                        [this] {
                            const std::lock_guard lock(mutex_);
                            return isHurried_;
                        }};
    while (const std::optional<Job> job = next()) {
        answer(job->number,
               shop ? (*shop)->draw(job->request, course) : tl::unexpected(shop.error()));
    }
    if (shop) {
        shop->reset();
    }
    returnFreeMemory();
}

void DifferenceWorker::answer(quint64 number, const Result<FrameDifference>& difference) {
    auto shared = difference ? std::make_shared<const FrameDifference>(*difference) : nullptr;
    const QString problem =
        difference ? QString() : QString::fromStdString(difference.error().text());
    QMetaObject::invokeMethod(this, [this, number, shared, problem] {
        answered_ = number;
        Q_EMIT finished(shared, problem);
    });
}

} // namespace patina
