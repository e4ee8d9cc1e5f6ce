// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QAction>

#include "document/document.h"

namespace patina {

class FileActions;
class TriedMaterial;

/// Has an action for what can be done to the active material as a whole, but for what files are
/// asked for.
class MaterialActions : public QObject {
    Q_OBJECT

  public:
    MaterialActions(Document& document, FileActions& files, TriedMaterial& tried, QObject* parent);

    const std::vector<QAction*>& all() const { return actions_; }
    /// Shows the material as it was opened or applied, for as long as it is checked and nothing is
    /// edited; no edit, and in no file.
    QAction* original() const { return original_; }

  private:
    QAction* add(const QString& text, const QString& toolTip, std::function<void()> what);
    void showOriginal(bool shows);
    void randomise();
    void setStartValues(bool isRemoval);
    void follow();

    Document& document_;
    TriedMaterial& tried_;
    std::vector<QAction*> actions_;
    QAction* original_ = nullptr;
    QAction* forget_ = nullptr;
};

} // namespace patina
