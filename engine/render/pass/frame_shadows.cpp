// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/frame_shadows.h"

#include <utility>

namespace patina {

void FrameShadows::setCatalog(std::shared_ptr<const Catalog> catalog) {
    catalog_ = std::move(catalog);
    casters_.setCatalog(catalog_);
}

void FrameShadows::begin() {
    giveBack();
    casters_.clear();
    views_.clear();
    pool_.beginFrame();
}

Result<void> FrameShadows::plan(const Scene& scene, const Scene& effects,
                                const glm::dmat4& cameraToWorld, ProgramCache& programs,
                                const GpuTextureStore& textures) {
    hasNewImages_ = false;
    views_.place({scene, effects, *catalog_, cameraToWorld, casters_.boxes()}, pool_.limits());
    if (views_.layers() == 0) {
        maps_.reset();
        return {};
    }
    if (auto prepared = casters_.prepare(programs, textures); !prepared) {
        views_.clear();
        return prepared;
    }
    const Result<bool> borrowed = borrow(false, programs);
    return borrowed ? Result<void>() : tl::unexpected(borrowed.error());
}

Result<bool> FrameShadows::borrow(bool mustHave, ProgramCache& programs) {
    auto lent = pool_.lend({casters_, views_, *catalog_, programs}, maps_, mustHave);
    if (!lent) {
        views_.clear();
        return tl::unexpected(lent.error());
    }
    isBorrowing_ = lent->maps != nullptr;
    hasNewImages_ = lent->areNew;
    if (isBorrowing_) {
        maps_ = std::move(lent->maps);
    }
    return isBorrowing_;
}

void FrameShadows::noteStep() {
    if (isBorrowing_) {
        pool_.noteUse(*maps_);
    }
}

Result<bool> FrameShadows::hold(bool mustHave, ProgramCache& programs) {
    if (views_.layers() == 0) {
        return true;
    }
    if (isBorrowing_ && !maps_->areReleased()) {
        return true;
    }
    giveBack();
    return borrow(mustHave, programs);
}

void FrameShadows::giveBack() {
    if (std::exchange(isBorrowing_, false)) {
        pool_.giveBack(*maps_);
    }
}

int FrameShadows::pending() const {
    return isBorrowing_ && !maps_->areReleased() ? maps_->pending() : views_.layers();
}

void FrameShadows::drawSome(int triangles, FrameTextures& textures) {
    maps_->drawSome(triangles, casters_, textures);
}

void FrameShadows::bind() const {
    if (maps_ != nullptr) {
        maps_->bind();
    }
}

} // namespace patina
