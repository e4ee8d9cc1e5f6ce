// SPDX-License-Identifier: GPL-3.0-or-later
#include "lobe/lobe_times.h"

#include <QToolButton>

#include "accuracy/cost_subject.h"
#include "docks/effect_label.h"
#include "docks/panel.h"
#include "session/message_log.h"
#include "session/session.h"
#include "shading/effects/effect_set.h"
#include "text/as_text.h"
#include "text/display_number.h"

namespace patina {

LobeTimes::LobeTimes(const DockContext& context, QWidget* parent)
    : QObject(parent), document_(context.document), messages_(context.messages),
      meshes_(context.meshes), textures_(context.textures), environments_(context.environments),
      button_(textButton(
          tr("Time"), tr("Measure what a pixel of each takes, and say what is not in its program"),
          parent)),
      worker_({.name = tr("Timing materials"), .canCancel = true}) {
    button_->setObjectName("time");
    connect(button_, &QToolButton::clicked, this, &LobeTimes::measure);
    // They are of the object in its scene.
    onChange(document_, DocumentChange::Lights | DocumentChange::Objects | DocumentChange::Scene,
             this, [this] { forget(); });
}

void LobeTimes::setMaterials(const std::vector<LobeMaterial>& materials) {
    if (materials != materials_) {
        materials_ = materials;
        forget();
    }
}

void LobeTimes::measure() {
    if (isMeasuring() || materials_.empty() || document_.selection().object() < 0) {
        return;
    }
    button_->setEnabled(false);
    CostSweep::Options options;
    options.programCache = programFolder();
    worker_.ask(
        [subject = costSubject(document_, meshes_, textures_, environments_), options,
         materials = materials_](Worker::Control& control) -> Result<std::vector<MaterialTime>> {
            if (const auto opened = control.openContext(); !opened) {
                return tl::unexpected(opened.error());
            }
            std::vector<Material> timed;
            for (const LobeMaterial& each : materials) {
                timed.push_back(each.material);
            }
            return materialTimes(subject, timed, options,
                                 [&control] { return !control.isCancelled(); });
        },
        [this, materials = materials_](const Result<std::vector<MaterialTime>>& times) {
            take(materials, times);
        });
}

void LobeTimes::take(const std::vector<LobeMaterial>& materials,
                     const Result<std::vector<MaterialTime>>& times) {
    button_->setEnabled(true);
    if (!times) {
        messages_.add(times.error());
        return;
    }
    if (materials != materials_) {
        return; // they have changed meanwhile
    }
    times_.clear();
    QStringList notes;
    for (std::size_t i = 0; i < times->size(); ++i) {
        const MaterialTime& each = (*times)[i];
        times_ << (each.isBelowNoise ? tr("too quick to measure")
                                     : tr("%1 ns/pixel").arg(roundText(each.nanoseconds)));
        notes << tr("%1: %2; %3.")
                     .arg(asText(materials[i].name), times_.back(), leftOutText(materials[i]));
    }
    note_ = notes.join(' ');
    Q_EMIT changed();
}

QString LobeTimes::leftOutText(const LobeMaterial& material) const {
    const Scene& scene = document_.scene();
    const EffectView view;
    const EffectSet set = effectSet(material.material, scene, document_.catalog(), view);
    QStringList names;
    for (const EffectLine& line :
         leftOut(set, {&material.material, scene, document_.catalog(), view})) {
        names << effectLabel(line.effect, &material.material, scene, document_.catalog());
    }
    return names.isEmpty() ? tr("all it has is in its program")
                           : tr("not in its program: %1").arg(names.join(QStringLiteral(", ")));
}

void LobeTimes::forget() {
    if (times_.isEmpty()) {
        return;
    }
    times_.clear();
    note_.clear();
    Q_EMIT changed();
}

void LobeTimes::cancel() {
    worker_.forget();
    button_->setEnabled(true);
}

} // namespace patina
