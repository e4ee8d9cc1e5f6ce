// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/preset_trial.h"

#include <QApplication>
#include <QShortcut>

#include "docks/notice_bar.h"
#include "document/document.h"
#include "document/tried_material.h"
#include "files/file_actions.h"
#include "viewport/compare_area.h"

namespace patina {

PresetTrial::PresetTrial(const DockContext& context, NoticeBar& notice, QWidget& panel)
    : context_(context), notice_(notice), panel_(panel),
      back_(new QShortcut(Qt::Key_Escape, &panel, nullptr, nullptr, Qt::ApplicationShortcut)) {
    back_->setEnabled(false);
    connect(back_, &QShortcut::activated, this, &PresetTrial::end);
    connect(&context_.tried, &TriedMaterial::changed, this, [this] {
        if (!context_.tried.isShown()) {
            end();
        }
    });
    connect(qApp, &QApplication::focusChanged, this,
            [this](const QWidget*, const QWidget* now) { followFocus(now); });
}

void PresetTrial::begin(const PresetPtr& entry) {
    context_.tried.show(context_.document.selection().side(), entry->material);
    if (!context_.tried.isShown()) {
        return;
    }
    tried_ = entry;
    back_->setEnabled(true);
    notice_.say(tr("Trying %1").arg(entry->name),
                {{tr("Apply"), tr("Put it on the side (Enter)"), [this] { apply(tried_); }},
                 {tr("Back"), tr("Show the material again (Esc)"), [this] { end(); }}});
}

void PresetTrial::end() {
    if (tried_) {
        tried_.reset();
        back_->setEnabled(false);
        notice_.clear();
        context_.tried.end();
    }
}

void PresetTrial::apply(const PresetPtr& entry) {
    const PresetPtr applied = entry; // which ending may let go of
    end();
    if (applied) {
        context_.files.applyPreset(applied->path, context_.document.selection().side());
    }
}

/// Who looks at what is tried from elsewhere, in a view, goes on trying it.
void PresetTrial::followFocus(const QWidget* now) {
    if (tried_ && now && !panel_.isAncestorOf(now) && !context_.views.isAncestorOf(now)) {
        end();
    }
}

} // namespace patina
