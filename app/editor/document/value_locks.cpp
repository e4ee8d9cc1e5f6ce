// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/value_locks.h"

#include <algorithm>
#include <set>
#include <utility>

#include "document/commands/lock_command.h"

namespace patina {
namespace {

using Json = nlohmann::json;

/// The owner of locked values keeps their ids under this key, by kind, as data that files keep
/// unread.
constexpr const char* lockedKey = "locked";

/// Returns where the owner of the values keeps what only the editor knows; null where the owner is
/// missing.
template <class State>
auto keptAt(State& state, const BlockPath& path) -> decltype(&state.scene.extras) {
    const auto index = static_cast<std::size_t>(path.index);
    switch (path.owner) {
    case BlockOwner::Material: {
        auto* material = materialAt(state, path.index, path.side);
        return material ? &material->extras : nullptr;
    }
    case BlockOwner::Light:
        return path.index >= 0 && index < state.scene.lights.size()
                   ? &state.scene.lights[index].block.unknown
                   : nullptr;
    case BlockOwner::Object:
        return path.index >= 0 && index < state.scene.objects.size()
                   ? &state.scene.objects[index].unknown
                   : nullptr;
    default:
        return &state.scene.extras;
    }
}

} // namespace

std::vector<std::string> lockedValues(const DocumentState& state, const BlockPath& path) {
    const Json* kept = keptAt(state, path);
    const Json none;
    const Json& all = kept && kept->is_object() ? kept->value(lockedKey, none) : none;
    const Json& ids = all.is_object() ? all.value(path.kind, none) : none;
    std::vector<std::string> locked;
    for (const Json& id : ids) {
        if (id.is_string()) {
            locked.push_back(id.get<std::string>());
        }
    }
    return locked;
}

bool isLocked(const DocumentState& state, const BlockPath& path, std::string_view parameterId) {
    const std::vector<std::string> locked = lockedValues(state, path);
    return std::ranges::find(locked, parameterId) != locked.end();
}

void storeLockedValues(DocumentState& state, const BlockPath& path,
                       const std::vector<std::string>& ids) {
    Json* kept = keptAt(state, path);
    if (!kept) {
        return;
    }
    Json all = kept->value(lockedKey, Json::object());
    all = all.is_object() ? all : Json::object();
    if (ids.empty()) {
        all.erase(path.kind);
    } else {
        all[path.kind] = ids;
    }
    if (all.empty()) {
        kept->erase(lockedKey);
    } else {
        (*kept)[lockedKey] = std::move(all);
    }
}

void setLocked(Document& document, const BlockPath& path, const std::vector<std::string>& ids,
               bool isLocked) {
    const std::vector<std::string> before = lockedValues(document.state(), path);
    std::set<std::string> after(before.begin(), before.end());
    for (const std::string& id : ids) {
        isLocked ? void(after.insert(id)) : void(after.erase(id));
    }
    if (after != std::set<std::string>(before.begin(), before.end())) {
        document.undoStack().push(
            new LockCommand(document, path, {after.begin(), after.end()},
                            isLocked ? Document::tr("Lock") : Document::tr("Unlock")));
    }
}

} // namespace patina
