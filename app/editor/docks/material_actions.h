// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QAction>

#include "document/document.h"

namespace patina {

class FileActions;
class TriedMaterial;

/// Owns the actions on the active material as a whole: copy, paste, randomise, show the original
/// and its model's defaults.
class MaterialActions : public QObject {
    Q_OBJECT

  public:
    MaterialActions(Document& document, FileActions& files, TriedMaterial& tried, QObject* parent);

    const std::vector<QAction*>& all() const { return actions_; }
    /// Returns the action that shows the material as it was opened or applied, while it is checked
    /// and until something is edited. It is no edit, and is not saved.
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
