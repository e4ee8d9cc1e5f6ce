// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheets/cell_taking.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "document/commands/lighting_command.h"
#include "document/commands/material_command.h"
#include "document/picture_edits.h"
#include "document/scene_edits.h"
#include "text/as_text.h"

namespace patina {
namespace {

/// Holds materials with the indices of the objects that get them.
using Materials = std::vector<std::pair<int, Material>>;

/// Returns the material that a cell gives an object: the cell's for the object of the sheet and in
/// the control row, else the object's own with the cell's values. Returns nothing where it cannot
/// have them.
std::optional<Material> materialOf(const SheetPlan& plan, const Scene& cell, std::size_t object,
                                   int column, int row) {
    if (object == plan.object() || plan.isControl(row)) {
        return cell.objects[object].material;
    }
    Scene other = plan.start();
    return plan.apply(other, object, column, row)
               ? std::optional(std::move(other.objects[object].material))
               : std::nullopt;
}

Materials changedMaterials(const Document& document, const SheetPlan& plan, const Scene& cell,
                           int column, int row) {
    const Side side = document.selection().side();
    const std::vector<int> objects = side == Side::A ? document.selection().editedObjects()
                                                     : std::vector{document.selection().object()};
    Materials changed;
    for (const int object : objects) {
        const Material* held = materialAt(document.state(), object, side);
        const auto index = static_cast<std::size_t>(object);
        auto wanted = held && index < cell.objects.size()
                          ? materialOf(plan, cell, index, column, row)
                          : std::nullopt;
        if (wanted && *wanted != *held) {
            changed.emplace_back(object, std::move(*wanted));
        }
    }
    return changed;
}

/// Returns the document's scene with what a cell has of lights, environment, fog, objects and the
/// picture; materials, names and kept views are the document's.
Scene sceneAfter(const Scene& held, const Scene& cell) {
    Scene after = cell;
    after.name = held.name;
    after.bookmarks = held.bookmarks;
    after.extras = held.extras;
    after.unknown = held.unknown;
    after.objects = held.objects;
    for (std::size_t i = 0; i < std::min(after.objects.size(), cell.objects.size()); ++i) {
        after.objects[i] = cell.objects[i];
        after.objects[i].material = held.objects[i].material;
    }
    return after;
}

std::map<int, Object> changedObjects(const Scene& held, const Scene& after) {
    std::map<int, Object> changed;
    for (std::size_t i = 0; i < held.objects.size(); ++i) {
        if (!(held.objects[i] == after.objects[i])) {
            changed.emplace(static_cast<int>(i), after.objects[i]);
        }
    }
    return changed;
}

void takeScene(Document& document, const Scene& after, const QString& label) {
    const Scene before = document.scene();
    const std::map<int, Object> objects = changedObjects(before, after);
    Scene lit = after;
    lit.camera = before.camera;
    lit.objects = before.objects;
    if (lit != before) {
        document.undoStack().push(new LightingCommand(document, lit, label));
        setPicture(document, after);
    }
    if (!objects.empty()) {
        setObjects(document, objects, label);
    }
    document.setCamera(after.camera);
}

} // namespace

bool takeCell(Document& document, const SheetPlan& plan, int column, int row) {
    const Result<Scene> cell = plan.scene(column, row);
    if (!cell) {
        return false;
    }
    const Side side = document.selection().side();
    const Materials materials = changedMaterials(document, plan, *cell, column, row);
    Scene after = sceneAfter(document.scene(), *cell);
    if (cell->camera == plan.start().camera) { // it may have moved since
        after.camera = document.scene().camera;
    }
    if (materials.empty() && after == document.scene()) {
        return false;
    }
    const QString label = Document::tr("Take %1").arg(asText(plan.cellLabel(column, row)));
    document.editAsOneStep(label, [&] {
        takeScene(document, after, label); // whose objects have the materials of before
        for (const auto& [object, material] : materials) {
            document.undoStack().push(
                new MaterialCommand(document, {object, side}, material, label));
        }
    });
    return true;
}

} // namespace patina
