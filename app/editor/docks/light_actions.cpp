// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/light_actions.h"

#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "document/block_label.h"
#include "document/scene_edits.h"
#include "files/file_actions.h"
#include "render/lights/placement.h"
#include "resources/mesh_library.h"
#include "viewport/light_pose.h"

namespace patina {
namespace {

/// Returns a ball around all that is seen; around what the camera sees at its pivot where nothing
/// is.
Ball ballAroundAll(const Scene& scene, MeshLibrary& meshes) {
    Bounds all;
    for (const Object& object : scene.objects) {
        const Bounds bounds = meshes.view(object).bounds;
        if (object.visible && !bounds.empty()) {
            for (const glm::dvec3& corner : placementOf(object, bounds).corners) {
                all.add(glm::vec3(corner));
            }
        }
    }
    if (all.empty()) {
        const double halfAngle = glm::radians(0.5 * scene.camera.fieldOfView);
        return {scene.camera.pivot, scene.camera.distance * std::tan(halfAngle)};
    }
    return {glm::dvec3(all.center()), 0.5 * glm::length(glm::dvec3(all.size()))};
}

std::optional<LightPose> poseOf(const Document& document, const BlockPath& path) {
    const Light& light = document.scene().lights[static_cast<std::size_t>(path.index)];
    const Block* block = document.catalog().find(kinds::lights, light.block.id);
    return block == nullptr ? std::nullopt
                            : lightPose(light.block.parameters, *block, document.scene().camera);
}

} // namespace

LightActions::LightActions(Document& document, FileActions& files, QObject* parent)
    : QObject(parent), document_(document) {
    add(tr("&Copy"), "Ctrl+C", [&files] { files.clipboard().copyLight(); });
    add(tr("Cu&t"), "Ctrl+X", [&files] { files.clipboard().cutLight(); });
    paste_ = add(tr("&Paste"), "Ctrl+V", [&files] { files.clipboard().paste(); });
    add(tr("&Duplicate"), "Ctrl+D", [&files] { files.clipboard().duplicateLight(); });
    add(tr("S&olo"), "", [&document] {
        toggleSolo(document, document.selection().light());
    })->setToolTip(tr("Only the current light is on; once more: those that were"));
    add(tr("&Mute"), "", [&document] {
        toggleMute(document, document.selection().light());
    })->setToolTip(tr("Turn the current light off or on"));
    add(tr("&Remove"), "", [&document] { removeLight(document, document.selection().light()); });
    onChange(document, DocumentChange::Lights | DocumentChange::Current | DocumentChange::Scene,
             this, &LightActions::follow);
    follow();
}

QAction* LightActions::add(const QString& text, const char* key, std::function<void()> what) {
    auto* action = new QAction(text, this);
    action->setShortcut(QKeySequence(key));
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(action, &QAction::triggered, this, std::move(what));
    actions_.push_back(action);
    return action;
}

void LightActions::follow() {
    for (QAction* action : actions_) {
        action->setEnabled(action == paste_ || document_.selection().light() >= 0);
    }
}

void setKindOfLight(Document& document, MeshLibrary& meshes, const std::string& kind) {
    const BlockPath path = document.selection().currentPath(kinds::lights);
    const QString label = blockLabel(kinds::lights, document.catalog().find(kinds::lights, kind));
    document.editAsOneStep(label, [&] {
        const auto before = poseOf(document, path);
        document.setBlock(path, kind);
        const auto after = poseOf(document, path);
        if (before && after) {
            const LightPose aimed =
                aimedAt(*before, *after, ballAroundAll(document.scene(), meshes));
            document.setValues(path, valuesAt(aimed, document.scene().camera), label);
        }
    });
}

} // namespace patina
