// SPDX-License-Identifier: GPL-3.0-or-later
// The part of FrameDrawer that draws the objects, in steps where they take long.
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include <epoxy/gl.h>

#include "render/frame/frame_drawer.h"
#include "render/gpu/binding.h"

namespace patina {
namespace {

using Clock = std::chrono::steady_clock;

enum class Pass { opaque, depths, blended };
constexpr std::array opaquePasses{Pass::opaque};
constexpr std::array transparentPasses{Pass::depths, Pass::blended};

void setPass(Pass pass) {
    const GLboolean colours = pass == Pass::depths ? GL_FALSE : GL_TRUE;
    glColorMask(colours, colours, colours, colours);
    glDepthFunc(pass == Pass::blended ? GL_LEQUAL : GL_LESS);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    (pass == Pass::blended ? glEnable : glDisable)(GL_BLEND);
}

} // namespace

/// Draws all solid objects tile by tile, since it is the pixels of few triangles that take long.
/// What blends comes behind them, some triangles at a time: a software driver covers the rows where
/// tiles meet twice.
bool FrameDrawer::drawTiles(const Scene& scene, Deadline deadline) {
    if (isLarge() || deadline == never) {
        return drawItems(scene, deadline);
    }
    tiles_.passed(Clock::now()); // one that the last step did not wait for
    while (!tiles_.isDone()) {
        report_.drawnObjects = 0;
        report_.drawCalls = 0;
        tiles_.enter(Clock::now());
        drawOpaque(scene);
        RowTiles::leave();
        fence_ = gl::Fence::afterCommandsSoFar();
        if (!deviceIsDone(deadline)) {
            return false;
        }
        tiles_.passed(Clock::now());
        if (Clock::now() >= deadline) {
            break;
        }
    }
    return tiles_.isDone() && drawItems(scene, deadline);
}

bool FrameDrawer::hasDrawnItems() const {
    return cursor_.batch == list_.batches().size() && (cursor_.hasGround || !ground_.isSeen) &&
           (cursor_.hasLayers || !transparency_.isIn()) && cursor_.hasOutlines;
}

void FrameDrawer::drawOpaque(const Scene& scene) {
    prepareToDraw();
    for (cursor_.batch = 0; cursor_.batch < list_.opaqueBatches(); ++cursor_.batch) {
        drawBatch(scene, list_.batches()[cursor_.batch], never);
    }
}

void FrameDrawer::prepareToDraw() {
    target_.bind();
    viewData_.bind(binding::view);
    environment_.bind();
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DITHER);
    std::fill(fedScenes_.begin(), fedScenes_.end(), nullptr);
    fedMaterial_.reset();
    shadows_.bind();
}

bool FrameDrawer::drawItems(const Scene& scene, Deadline deadline) {
    if (hasDrawnItems()) {
        return true;
    }
    prepareToDraw();
    while (cursor_.batch < list_.batches().size()) {
        if (cursor_.batch >= list_.opaqueBatches()) {
            drawGround(scene); // behind what shines through
            if (!drawOutlines(scene, deadline)) {
                break;
            }
        }
        const DrawBatch& batch = list_.batches()[cursor_.batch];
        if (!isLayered(materials_[batch.material]) && !drawBatch(scene, batch, deadline)) {
            break;
        }
        if (++cursor_.batch < list_.batches().size() && isDue(deadline)) {
            break;
        }
    }
    bool isDone = cursor_.batch == list_.batches().size();
    if (isDone) {
        drawGround(scene);
        isDone = drawOutlines(scene, deadline) && drawLayers(scene, deadline);
    }
    setPass(Pass::opaque);
    if (deadline != never) {
        fence_ = gl::Fence::afterCommandsSoFar();
    }
    return isDone;
}

/// What lies in front of an object that something shines through is blended over its lines.
bool FrameDrawer::drawBatch(const Scene& scene, const DrawBatch& batch, Deadline deadline) {
    if (!cursor_.hasSurface && !drawSurface(scene, batch, deadline)) {
        return false;
    }
    cursor_.hasSurface = true;
    if (materials_[batch.material].isTransparent && !drawOutline(scene, batch, deadline)) {
        return false;
    }
    cursor_.hasSurface = false;
    return true;
}

/// Blends only the nearest layer of a transparent object, so that the order of its triangles does
/// not show: depths first, then colours where the depth is the same.
bool FrameDrawer::drawSurface(const Scene& scene, const DrawBatch& batch, Deadline deadline) {
    if (refracts(materials_[batch.material])) {
        setPass(Pass::opaque);
        return drawRefracting(scene, batch, deadline);
    }
    feed(scene, batch);
    const std::span<const Pass> passes = materials_[batch.material].isTransparent
                                             ? std::span<const Pass>(transparentPasses)
                                             : opaquePasses;
    for (; cursor_.pass < std::ssize(passes); ++cursor_.pass) {
        setPass(passes[static_cast<std::size_t>(cursor_.pass)]);
        if (!drawTriangles(batch, deadline)) {
            return false;
        }
    }
    cursor_.pass = 0;
    report_.drawnObjects += static_cast<int>(batch.count);
    return true;
}

bool FrameDrawer::drawTriangles(const DrawBatch& batch, Deadline deadline) {
    return drawSlices(batch, batch.mesh->triangles(), deadline, [&](const DrawRange& range) {
        batch.mesh->draw(instances_, range);
    });
}

/// Draws `triangles` of each of the batch's objects, or as many edges, slice by slice.
bool FrameDrawer::drawSlices(const DrawBatch& batch, int triangles, Deadline deadline,
                             const std::function<void(const DrawRange&)>& draw) {
    while (!cursor_.slices.isDone(batch.count)) {
        const std::int64_t most =
            deadline == never ? std::numeric_limits<std::int64_t>::max() : pace_.most();
        const DrawRange range = cursor_.slices.next(triangles, batch.first, batch.count, most);
        draw(range);
        ++report_.drawCalls;
        if (deadline != never) {
            pace_.add(range.total(), Clock::now());
        }
        if (!cursor_.slices.isDone(batch.count) && isDue(deadline)) {
            return false;
        }
    }
    cursor_.slices = DrawSlices();
    return true;
}

/// Whether so much was drawn that it is time to look at the clock, and that says so.
bool FrameDrawer::isDue(Deadline deadline) {
    return deadline != never && pace_.isDue() && mustStop(deadline);
}

/// A device that is the CPU itself works in the background, and what the window draws has to wait
/// behind that: it gets the next slice when it has done the last one.
bool FrameDrawer::mustStop(Deadline deadline) {
    if (isSoftware_ && deadline != never) {
        fence_ = gl::Fence::afterCommandsSoFar();
    }
    if (!deviceIsDone(deadline)) {
        return true;
    }
    pace_.passed(Clock::now());
    return Clock::now() >= deadline;
}

} // namespace patina
