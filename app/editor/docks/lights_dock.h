// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "docks/dock_context.h"

class QCheckBox;
class QMenu;
class QToolButton;

namespace patina {

class BlockChooser;
class CheckList;

/// Lists the scene's lights, adds any kind, switches, renames and removes them, marks the key light
/// and edits the current one.
class LightsDock : public QWidget {
    Q_OBJECT

  public:
    explicit LightsDock(const DockContext& context);

  private:
    void connectList(FileActions& files);
    void fillMenu();
    void update();
    void updateShadow();
    void switchLight(int index, bool on);
    void renameLight(int index, const QString& name);
    void markKey(bool isKey);

    Document& document_;
    CheckList* list_;
    QToolButton* add_;
    QToolButton* remove_;
    QToolButton* solo_;
    QMenu* kinds_;
    BlockChooser* kind_;
    QCheckBox* key_;
    BlockChooser* shadow_;
};

} // namespace patina
