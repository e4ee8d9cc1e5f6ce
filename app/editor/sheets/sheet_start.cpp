// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheets/sheet_start.h"

#include <algorithm>
#include <utility>

namespace patina {
namespace {

constexpr std::size_t maxTaken = 64; ///< is how many scenes are kept

std::vector<SheetAxis> axesOf(const Sheet& sheet) {
    std::vector<SheetAxis> axes{{sheet.x.kind, sheet.x.value, {}, {}}};
    if (sheet.y) {
        axes.push_back({sheet.y->kind, sheet.y->value, {}, {}});
    }
    return axes;
}

} // namespace

void SheetStart::follow(const Scene& shown, const Subject& subject, const Sheet& sheet) {
    std::vector<SheetAxis> axes = axesOf(sheet);
    if (!scene_ || subject != subject_ || axes != axes_ || !holds(shown)) {
        const bool isSame = scene_ && *scene_ == shown;
        scene_ = isSame ? scene_ : std::make_shared<const Scene>(shown);
        taken_.clear();
    } else if (scene_->camera != shown.camera) {
        Scene moved = *scene_;
        moved.camera = shown.camera;
        scene_ = std::make_shared<const Scene>(std::move(moved));
    }
    subject_ = subject;
    axes_ = std::move(axes);
}

void SheetStart::noteTaken(const Scene& shown) {
    if (holds(shown)) {
        return;
    }
    if (taken_.size() == maxTaken) {
        taken_.erase(taken_.begin());
    }
    taken_.push_back(shown);
}

bool SheetStart::holds(const Scene& shown) const {
    Scene probe = shown;
    const auto isShown = [&probe](const Scene& held) {
        probe.camera = held.camera;
        return probe == held;
    };
    return scene_ && (isShown(*scene_) || std::ranges::any_of(taken_, isShown));
}

Scene drawnScene(Scene scene) {
    scene.name.clear();
    scene.bookmarks.clear();
    scene.extras = nlohmann::json::object();
    scene.unknown = nlohmann::json::object();
    return scene;
}

} // namespace patina
