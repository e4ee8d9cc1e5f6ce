// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/program_worker.h"

#include <algorithm>
#include <utility>

#include "background/free_memory.h"
#include "gl/headless_context.h"
#include "render/frame/frame_job.h"
#include "render/gpu/fallback_size.h"

namespace patina {
namespace {

/// The longer side of the picture that nothing is drawn into.
constexpr int side = 16;

/// A fallback with the same box: programs do not depend on triangles, but what is left out of them
/// does on where things are.
Mesh fallbackFor(const Bounds& bounds, int triangles) {
    Mesh mesh;
    mesh.bounds = bounds;
    mesh.vertices.resize(3);
    mesh.vertices[0].position = bounds.lower;
    mesh.vertices[1].position = bounds.upper;
    mesh.vertices[2].position = bounds.center();
    for (int i = 0; i < triangles; ++i) {
        mesh.indices.insert(mesh.indices.end(), {0, 1, 2});
    }
    return mesh;
}

/// In the proportions of the view.
glm::ivec2 smallSizeFor(const ProgramWorker::Frame& frame) {
    const glm::ivec2 size = frame.view.size;
    const double shrinking = double(side) / std::max(size.x, size.y);
    return fallbackSize(size, glm::ivec2(glm::dvec2(size) * shrinking),
                        frame.scene.accuracy.scale());
}

/// What there is more triangles than pixels of is drawn into another kind of buffer, for which
/// drivers compile anew.
int trianglesFor(const ProgramWorker::Frame& frame, glm::ivec2 small) {
    const glm::ivec2 size = frame.view.size;
    return frame.triangles > std::int64_t(size.x) * size.y ? small.x * small.y + 1 : 1;
}

/// Images that are there need not be sent to the device for this.
TextureLookup placeholder(const TextureUse&, TextureDecoding) {
    return {nullptr, true};
}

/// A context with a renderer in it.
class Workshop {
  public:
    static std::unique_ptr<Workshop> open(const std::filesystem::path& programCache) {
        auto context = gl::HeadlessContext::create();
        if (!context) {
            return nullptr;
        }
        auto renderer = Renderer::create({programCache});
        if (!renderer) {
            return nullptr;
        }
        auto shop = std::make_unique<Workshop>();
        shop->context_ = std::move(*context);
        shop->renderer_ = std::move(*renderer);
        shop->renderer_->setTextures(placeholder);
        return shop;
    }

    void make(const ProgramWorker::Frame& frame) {
        renderer_->setCatalog(frame.catalog);
        View view = frame.view;
        view.size = smallSizeFor(frame);
        const int triangles = trianglesFor(frame, view.size);
        std::vector<Mesh> meshes;
        for (const Bounds& bounds : frame.meshes) {
            meshes.push_back(bounds.empty() ? Mesh() : fallbackFor(bounds, triangles));
        }
        view.effects = frame.effects ? &*frame.effects : nullptr;
        const Object* const first = frame.scene.objects.data();
        const MeshSource source = [&](const Object& object) {
            return meshes[static_cast<std::size_t>(&object - first)].view();
        };
        renderer_->begin(frame.scene, view, source, FramePurpose::Prewarm).step(FrameJob::never);
    }

  private:
    std::unique_ptr<gl::HeadlessContext> context_;
    std::unique_ptr<Renderer> renderer_;
};

} // namespace

ProgramWorker::ProgramWorker(std::filesystem::path programCache, QObject* parent)
    : QObject(parent), programCache_(std::move(programCache)) {
    connect(&worker_, &BackgroundJob::finished, this, &ProgramWorker::wake);
}

ProgramWorker::~ProgramWorker() {
    const std::lock_guard lock(mutex_);
    jobs_.clear();
}

quint64 ProgramWorker::ask(Frame frame) {
    {
        const std::lock_guard lock(mutex_);
        jobs_.push_back({++asked_, std::move(frame)});
    }
    wake();
    return asked_;
}

void ProgramWorker::wake() {
    const std::lock_guard lock(mutex_);
    if (!jobs_.empty()) {
        worker_.start([this](BackgroundJob::Control&) {
            work();
            return endOf(true, {});
        });
    }
}

/// The next frame, if there is one.
std::optional<ProgramWorker::Job> ProgramWorker::next() {
    const std::lock_guard lock(mutex_);
    if (jobs_.empty()) {
        return std::nullopt;
    }
    Job job = std::move(jobs_.front());
    jobs_.pop_front();
    return job;
}

void ProgramWorker::work() {
    while (const std::optional<Job> job = next()) {
        if (const auto shop = Workshop::open(programCache_)) {
            shop->make(job->frame);
        } // what the driver has made is on the disk when its context is gone
        Q_EMIT finished(job->number);
    }
    returnFreeMemory();
}

} // namespace patina
