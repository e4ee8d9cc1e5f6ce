// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QAction>

#include "document/document.h"

namespace patina {

class FileActions;
class MeshLibrary;

/// Owns the actions on the current light: copy, cut, paste, duplicate, solo, mute, remove. Their
/// keys work where the focus is in a widget that the actions were added to.
class LightActions : public QObject {
    Q_OBJECT

  public:
    LightActions(Document& document, FileActions& files, QObject* parent);

    const std::vector<QAction*>& all() const { return actions_; }

  private:
    QAction* add(const QString& text, const char* key, std::function<void()> what);
    void follow();

    Document& document_;
    std::vector<QAction*> actions_;
    QAction* paste_ = nullptr;
};

/// Gives the current light another kind, as one step. It shines from where it shone before: one
/// that gets a place stands so far away that it lights all objects, and is aimed at them.
void setKindOfLight(Document& document, MeshLibrary& meshes, const std::string& kind);

} // namespace patina
