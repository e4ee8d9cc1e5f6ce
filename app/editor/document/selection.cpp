// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/selection.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace patina {

Selection::Selection(const DocumentState& state,
                     std::function<void(const DocumentChange& change)> announce)
    : state_(state), announce_(std::move(announce)) {}

void Selection::setObject(int index) {
    const int inside = std::min(index, static_cast<int>(state_.scene.objects.size()) - 1);
    if (inside != object_) {
        object_ = inside;
        if (!std::ranges::binary_search(objects_, inside)) {
            objects_.clear();
        }
        DocumentChange change{DocumentChange::Current};
        const bool isComparing = state_.second.has_value();
        change.aspects.setFlag(DocumentChange::Material, isComparing); // B moved to this object
        announce_(change);
    }
}

void Selection::setLight(int index) {
    const int inside = std::min(index, static_cast<int>(state_.scene.lights.size()) - 1);
    if (inside != light_) {
        light_ = inside;
        announce_({DocumentChange::Current});
    }
}

void Selection::setSide(Side side) {
    const Side possible = indexOf(side) < shownSides(state_) ? side : Side::A;
    if (possible != side_) {
        side_ = possible;
        announce_({DocumentChange::Current});
    }
}

void Selection::setObjects(std::vector<int> objects) {
    const auto count = static_cast<int>(state_.scene.objects.size());
    std::erase_if(objects, [count](int object) { return object < 0 || object >= count; });
    const int current = objects.empty() ? object_ : objects.back();
    std::ranges::sort(objects);
    objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
    if (objects != objects_) {
        objects_ = std::move(objects);
        if (current == object_) {
            announce_({DocumentChange::Current});
        }
    }
    setObject(current);
}

std::vector<int> Selection::editedObjects() const {
    if (std::ranges::binary_search(objects_, object_)) {
        return objects_;
    }
    return object_ < 0 ? std::vector<int>() : std::vector<int>{object_};
}

BlockPath Selection::currentPath(std::string_view kind) const {
    BlockPath path = pathOf(kind);
    if (path.owner == BlockOwner::Scene) {
        return path.isAt(kinds::environment) ? environmentPath(state_, side_) : path;
    }
    path.index = path.owner == BlockOwner::Light ? light_ : object_;
    path.side = path.owner == BlockOwner::Material ? side_ : Side::A;
    return path;
}

std::vector<BlockPath> Selection::editedPaths(const BlockPath& path) const {
    std::vector<BlockPath> paths{path};
    const bool isOfObject = path.owner == BlockOwner::Object || path.owner == BlockOwner::Material;
    if (!isOfObject || path.side != Side::A || path.index != object_) {
        return paths;
    }
    for (const int object : editedObjects()) {
        if (object != path.index) {
            paths.push_back(path);
            paths.back().index = object;
        }
    }
    return paths;
}

void Selection::start(int object) {
    object_ = state_.scene.objects.empty() ? -1 : object;
    objects_.clear();
    light_ = state_.scene.lights.empty() ? -1 : 0;
    side_ = Side::A;
}

void Selection::keepInside() {
    std::erase_if(objects_,
                  [count = std::ssize(state_.scene.objects)](int i) { return i >= count; });
    setObject(state_.scene.objects.empty() ? -1 : std::max(object_, 0));
    setLight(state_.scene.lights.empty() ? -1 : std::max(light_, 0));
    setSide(side_);
}

} // namespace patina
