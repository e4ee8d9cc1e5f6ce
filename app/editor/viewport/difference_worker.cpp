// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/difference_worker.h"

#include <chrono>
#include <functional>
#include <utility>

#include "free_memory.h"
#include "gl/headless_context.h"

namespace patina {
namespace {

/// How long the context is kept for the next frames.
constexpr std::chrono::seconds patience{3};

/// Work between two looks at whether the window goes.
constexpr std::chrono::milliseconds slice{20};

constexpr int sampledDirections = 64; ///< of an environment's light, the same on both sides

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

    Result<FrameDifference> draw(const Request& request, const std::function<bool()>& goesOn) {
        if (catalog_ != request.catalog) {
            catalog_ = request.catalog;
            renderer_->setCatalog(catalog_);
        }
        renderer_->setTextures(request.textures);
        auto a = picture(request.a, request, goesOn);
        if (!a) {
            return tl::unexpected(a.error());
        }
        auto b = picture(request.b, request, goesOn);
        return b ? Result<FrameDifference>(differenceOf(*a, *b)) : tl::unexpected(b.error());
    }

  private:
    Result<Image> picture(const Side& side, const Request& request,
                          const std::function<bool()>& goesOn) {
        View view = request.view;
        view.numbers = HdrNumbers::Full;
        view.environmentSamples = sampledDirections;
        view.effects = side.effects ? &*side.effects : nullptr;
        if (auto begun = renderer_->beginCapture(side.scene, view, request.meshes); !begun) {
            return tl::unexpected(begun.error());
        }
        while (!renderer_->proceed(slice)) {
            if (!goesOn()) {
                return failure("the window has gone");
            }
        }
        return renderer_->captured(false);
    }

    std::unique_ptr<gl::HeadlessContext> context_;
    std::unique_ptr<Renderer> renderer_;
    std::shared_ptr<const Catalog> catalog_;
};

DifferenceWorker::DifferenceWorker(std::filesystem::path programCache, QObject* parent)
    : QObject(parent), programCache_(std::move(programCache)) {
    thread_.setMaxThreadCount(1);
    thread_.setExpiryTimeout(100);
    thread_.setThreadPriority(QThread::LowPriority); // the views come first
}

DifferenceWorker::~DifferenceWorker() {
    {
        const std::lock_guard lock(mutex_);
        isEnding_ = true;
    }
    news_.notify_all();
    thread_.waitForDone();
}

void DifferenceWorker::ask(Request request) {
    const std::lock_guard lock(mutex_);
    job_ = Job{++asked_, std::move(request)};
    if (!std::exchange(isWorking_, true)) {
        thread_.start([this] { work(); });
    }
    news_.notify_all();
}

/// The next frames; nothing when there were none for a while.
std::optional<DifferenceWorker::Job> DifferenceWorker::next() {
    std::unique_lock lock(mutex_);
    news_.wait_for(lock, patience, [this] { return isEnding_ || job_; });
    if (isEnding_ || !job_) {
        isWorking_ = false;
        return std::nullopt;
    }
    return std::exchange(job_, std::nullopt);
}

void DifferenceWorker::work() {
    auto shop = Workshop::open(programCache_);
    const auto goesOn = [this] {
        const std::lock_guard lock(mutex_);
        return !isEnding_;
    };
    while (const std::optional<Job> job = next()) {
        answer(job->number, shop ? (*shop)->draw(job->request, goesOn)
                                 : tl::unexpected(shop.error()));
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
