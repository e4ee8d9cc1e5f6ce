// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/commands/lighting_command.h"

#include <algorithm>
#include <utility>

namespace patina {

LightingCommand::LightingCommand(Document& document, Scene after)
    : LightingCommand(document, after,
                      Document::tr("Light as in %1").arg(QString::fromStdString(after.name))) {}

LightingCommand::LightingCommand(Document& document, Scene after, const QString& label)
    : ChangeCommand(document, label, SceneLighting(), document.scene(), std::move(after)) {}

void LightingCommand::apply(const Scene& lighting) {
    Scene lit = lighting;
    Scene& scene = state().scene;
    lit.name = std::move(scene.name);
    lit.objects = std::move(scene.objects);
    lit.camera = scene.camera;
    lit.extras = std::move(scene.extras);
    lit.unknown = std::move(scene.unknown);
    lit.passes = std::move(scene.passes);
    lit.accuracy = scene.accuracy;
    lit.accuracy.choose(PictureChoice::Environment,
                        lighting.accuracy.level(PictureChoice::Environment));
    const BlockValues* transparency = scene.part(kinds::transparency);
    lit.setPart(kinds::transparency, transparency ? std::optional(*transparency) : std::nullopt);
    scene = std::move(lit);
    document().announce({DocumentChange::Block | DocumentChange::Lights});
    const int last = static_cast<int>(scene.lights.size()) - 1;
    document().selection().setLight(
        std::clamp(document().selection().light(), std::min(last, 0), last));
}

} // namespace patina
