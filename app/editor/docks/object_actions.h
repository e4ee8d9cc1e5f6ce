// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QAction>

#include "document/document.h"

namespace patina {

class FileActions;

/// Owns the actions on the selected objects. Their keys work where the focus is in a widget that
/// the actions were added to.
class ObjectActions : public QObject {
    Q_OBJECT

  public:
    ObjectActions(Document& document, FileActions& files, QObject* parent);

    const std::vector<QAction*>& all() const { return actions_; }

  private:
    void add(const QString& text, const char* key, std::function<void()> what,
             std::function<bool()> isPossible);
    void follow();

    Document& document_;
    std::vector<QAction*> actions_;
    /// Tells for each action whether it is enabled now.
    std::vector<std::function<bool()>> possible_;
};

} // namespace patina
