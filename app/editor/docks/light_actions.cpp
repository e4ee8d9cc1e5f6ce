// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/light_actions.h"

#include <utility>

#include "document/scene_edits.h"
#include "files/file_actions.h"

namespace patina {

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

} // namespace patina
