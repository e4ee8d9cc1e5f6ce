// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/program_worker.h"

#include <algorithm>
#include <utility>

#include "render/frame/frame_job.h"
#include "render/gpu/fallback_size.h"

namespace patina {
namespace {

/// Pixels; the longer edge of the small target that frames are drawn into
constexpr int side = 16;

/// Returns a mesh with the same box: programs do not depend on the triangles, but what is left out
/// of them depends on where things are.
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

/// Returns the size of the small target, in the proportions of the view.
glm::ivec2 smallSizeFor(const ProgramWorker::Frame& frame) {
    const glm::ivec2 size = frame.view.size;
    const double shrinking = double(side) / std::max(size.x, size.y);
    return fallbackSize(size, glm::ivec2(glm::dvec2(size) * shrinking),
                        frame.scene.accuracy.scale());
}

/// Returns how many triangles a fallback mesh needs to get the same kind of buffer as in the view:
/// one with more triangles than the view has pixels is drawn into another kind, for which drivers
/// compile anew.
int trianglesFor(const ProgramWorker::Frame& frame, glm::ivec2 small) {
    const glm::ivec2 size = frame.view.size;
    return frame.triangles > std::int64_t(size.x) * size.y ? small.x * small.y + 1 : 1;
}

/// Says that an image is there, without any pixels, as programs do not depend on them.
TextureLookup placeholder(const TextureUse&, TextureDecoding) {
    return {nullptr, true};
}

/// Draws the frame into a small target that is never shown, one program after the other until it
/// is cancelled. The context has to be current.
void makePrograms(const ProgramWorker::Frame& frame, Renderer& renderer,
                  const Worker::Control& control) {
    renderer.setTextures(placeholder);
    renderer.setCatalog(frame.catalog);
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
    FrameJob& job = renderer.begin(frame.scene, view, source, FramePurpose::Prewarm);
    while (!control.isCancelled() &&
           job.step(std::chrono::milliseconds(0)) == FrameJob::Progress::More) {
    }
}

} // namespace

ProgramWorker::ProgramWorker(std::filesystem::path programCache, QObject* parent)
    : QObject(parent), programCache_(std::move(programCache)),
      worker_({.name = tr("Preparing shaders"), .canCancel = true}) {}

quint64 ProgramWorker::ask(Frame frame) {
    const auto make = [this, frame = std::move(frame)](const Worker::Control& control) {
        if (!control.isCancelled() && control.openContext()) {
            if (const auto renderer = Renderer::create({programCache_})) {
                makePrograms(frame, **renderer, control);
            }
        }
        control.closeContext(); // the driver has written its cache when the context is gone
        return control.isCancelled();
    };
    worker_.ask(make, [this, number = ++asked_](const Result<bool>& isCancelled) {
        if (isCancelled && *isCancelled) {
            Q_EMIT givenUp(number);
        } else {
            Q_EMIT finished(number);
        }
    });
    return asked_;
}

} // namespace patina
