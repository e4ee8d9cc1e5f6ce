// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/object_actions.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "document/scene_edits.h"
#include "files/file_actions.h"
#include "text/counted.h"

namespace patina {
namespace {

std::vector<int> allOf(const Scene& scene) {
    std::vector<int> objects(scene.objects.size());
    std::iota(objects.begin(), objects.end(), 0);
    return objects;
}

} // namespace

ObjectActions::ObjectActions(Document& document, FileActions& files, QObject* parent)
    : QObject(parent), document_(document) {
    const auto any = [&document] { return !document.scene().objects.empty(); };
    const auto edited = [&document] { return document.selection().editedObjects(); };
    const auto isGrouped = [&document](int index) {
        return !document.scene().objects[static_cast<std::size_t>(index)].group.empty();
    };
    add(
        tr("Select &All Objects"), "Ctrl+A",
        [&document] { document.selection().setObjects(allOf(document.scene())); }, any);
    add(
        tr("&Copy"), "Ctrl+C", [&files] { files.clipboard().copyObjects(); }, any);
    add(
        tr("Cu&t"), "Ctrl+X", [&files] { files.clipboard().cutObjects(); }, any);
    add(
        tr("&Paste"), "Ctrl+V", [&files] { files.clipboard().paste(); }, [] { return true; });
    add(
        tr("&Duplicate"), "Shift+D", [&files] { files.meshes().duplicateObjects(); }, any);
    add(
        tr("&Hide"), "H",
        [&document, edited] {
            const std::vector<int> hidden = edited();
            changeObjects(document, hidden,
                          counted(hidden.size(), tr("Hide object"), tr("Hide %1 objects")),
                          [](Object& object) { object.visible = false; });
        },
        any);
    add(
        tr("&Show All"), "Alt+H",
        [&document] {
            changeObjects(document, allOf(document.scene()), tr("Show all objects"),
                          [](Object& object) { object.visible = true; });
        },
        any);
    add(
        tr("&Group"), "Ctrl+G", [&document, edited] { groupObjects(document, edited()); },
        [edited] { return edited().size() > 1; });
    add(
        tr("&Ungroup"), "Ctrl+Shift+G", [&document, edited] { ungroupObjects(document, edited()); },
        [edited, isGrouped] { return std::ranges::any_of(edited(), isGrouped); });
    add(
        tr("&Remove"), "Del", [&document, edited] { removeObjects(document, edited()); }, any);
    add(
        tr("Remove All &Objects"), "",
        [&document] { removeObjects(document, allOf(document.scene())); }, any);
    onChange(document, DocumentChange::Objects | DocumentChange::Current | DocumentChange::Scene,
             this, &ObjectActions::follow);
    follow();
}

void ObjectActions::add(const QString& text, const char* key, std::function<void()> what,
                        std::function<bool()> isPossible) {
    auto* action = new QAction(text, this);
    action->setShortcut(QKeySequence(key));
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(action, &QAction::triggered, this, std::move(what));
    actions_.push_back(action);
    possible_.push_back(std::move(isPossible));
}

void ObjectActions::follow() {
    for (std::size_t i = 0; i < actions_.size(); ++i) {
        actions_[i]->setEnabled(possible_[i]());
    }
}

} // namespace patina
