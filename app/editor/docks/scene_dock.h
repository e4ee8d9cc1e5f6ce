// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QWidget>

#include "docks/dock_context.h"
#include "docks/dock_page.h"

class QMenu;
class QToolButton;

namespace patina {

class BlockChooser;
class CheckList;

/// Lists the scene's objects, and edits their transforms and the settings of the scene, the display
/// and the camera.
class SceneDock : public QWidget {
    Q_OBJECT

  public:
    explicit SceneDock(const DockContext& context);

    /// Returns its sections from top to bottom.
    static std::vector<DockPage> pages();

  private:
    QWidget* display(const DockContext& context);
    void connectList();
    void fillMenu();
    void update();
    void addBuiltin(const std::string& name);
    void switchObject(int index, bool on);
    void renameObject(int index, const QString& name);

    Document& document_;
    FileActions& files_;
    CheckList* list_;
    QToolButton* add_;
    QToolButton* remove_;
    QMenu* meshes_;
    BlockChooser* tone_;
};

} // namespace patina
