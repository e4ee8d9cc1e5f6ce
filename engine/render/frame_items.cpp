// SPDX-License-Identifier: GPL-3.0-or-later
// The part of FrameDrawer that draws the objects, in steps where they take long.
#include <algorithm>
#include <array>
#include <span>

#include <epoxy/gl.h>

#include "render/binding.h"
#include "render/frame_drawer.h"
#include "shading/texture_choice.h"

namespace patina {
namespace {

using Clock = std::chrono::steady_clock;

/// Triangles that a software driver does in a few milliseconds.
constexpr int drawnAtOnce = 16384;

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

/// Of few triangles it is the pixels that take long: all solid objects, band by band. What blends
/// comes at once behind them: a software driver covers the rows where bands meet twice.
bool FrameDrawer::drawBands(const Scene& scene, Deadline deadline) {
    if (isLarge() || deadline == never) {
        return drawItems(scene, deadline);
    }
    bands_.passed(Clock::now()); // one that the last step did not wait for
    while (!bands_.isDone()) {
        report_.drawnObjects = 0;
        bands_.enter(Clock::now());
        drawOpaque(scene);
        FrameBands::leave();
        fence_ = gl::Fence::afterCommandsSoFar();
        if (!deviceIsDone(deadline)) {
            return false;
        }
        bands_.passed(Clock::now());
        if (Clock::now() >= deadline) {
            break;
        }
    }
    return bands_.isDone() && drawItems(scene, never);
}

bool FrameDrawer::hasDrawnItems() const {
    return cursor_.item == items_.size() && (cursor_.hasGround || !ground_.isSeen);
}

void FrameDrawer::drawOpaque(const Scene& scene) {
    prepareToDraw();
    for (cursor_.item = 0; cursor_.item < opaqueItems_; ++cursor_.item) {
        drawItem(scene, items_[cursor_.item], never);
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
    shadows_.bind();
}

bool FrameDrawer::drawItems(const Scene& scene, Deadline deadline) {
    if (hasDrawnItems()) {
        return true;
    }
    prepareToDraw();
    while (cursor_.item < items_.size()) {
        if (isTransparent(effects_->objects[items_[cursor_.item].index].material)) {
            drawGround(scene); // behind what shines through
        }
        if (!drawItem(scene, items_[cursor_.item], deadline)) {
            break;
        }
        ++cursor_.item;
    }
    if (cursor_.item == items_.size()) {
        drawGround(scene);
    }
    setPass(Pass::opaque);
    if (deadline != never) {
        fence_ = gl::Fence::afterCommandsSoFar();
    }
    return cursor_.item == items_.size();
}

/// Of a transparent object only the nearest layer is blended, so that the order of its triangles
/// does not show: depths first, then colours where the depth is the same.
bool FrameDrawer::drawItem(const Scene& scene, const Item& item, Deadline deadline) {
    if (!slots_[item.index].pipeline) {
        return true;
    }
    feed(scene, item);
    const bool transparent = isTransparent(effects_->objects[item.index].material);
    const std::span<const Pass> passes =
        transparent ? std::span<const Pass>(transparentPasses) : opaquePasses;
    for (; cursor_.pass < std::ssize(passes); ++cursor_.pass) {
        setPass(passes[static_cast<std::size_t>(cursor_.pass)]);
        if (!drawTriangles(*item.mesh, deadline)) {
            return false;
        }
    }
    cursor_.pass = 0;
    ++report_.drawnObjects;
    return true;
}

bool FrameDrawer::drawTriangles(const GpuMesh& mesh, Deadline deadline) {
    const int slice = deadline == never ? mesh.triangles() : drawnAtOnce;
    while (cursor_.triangle < mesh.triangles()) {
        const int count = std::min(slice, mesh.triangles() - cursor_.triangle);
        mesh.draw(cursor_.triangle, count);
        cursor_.triangle += count;
        if (cursor_.triangle < mesh.triangles() && mustStop(deadline)) {
            return false;
        }
    }
    cursor_.triangle = 0;
    return true;
}

/// A device that is the CPU itself works in the background, and what the window draws has to wait
/// behind that: it gets the next slice when it has done the last one.
bool FrameDrawer::mustStop(Deadline deadline) {
    if (isSoftware_ && deadline != never) {
        fence_ = gl::Fence::afterCommandsSoFar();
    }
    return !deviceIsDone(deadline) || Clock::now() >= deadline;
}

} // namespace patina
