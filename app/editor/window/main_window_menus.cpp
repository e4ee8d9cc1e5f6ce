// SPDX-License-Identifier: GPL-3.0-or-later
// The window's menus and its tool bar.
#include <functional>
#include <utility>

#include <QActionGroup>
#include <QCoreApplication>
#include <QDockWidget>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QToolBar>

#include "text/short_text.h"
#include "window/main_window.h"

namespace patina {

QAction* MainWindow::add(QMenu* menu, const QString& text, const QKeySequence& key,
                         std::function<void()> what) {
    QAction* action = menu->addAction(text);
    action->setShortcut(key);
    connect(action, &QAction::triggered, this, std::move(what));
    return action;
}

void MainWindow::makeFileMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&File"));
    add(menu, tr("&New"), QKeySequence::New, [this] { files_->newDocument(); });
    add(menu, tr("&Open…"), QKeySequence::Open, [this] { files_->askAndOpen(); });
    recent_ = menu->addMenu(tr("Open &Recent"));
    connect(recent_, &QMenu::aboutToShow, this, &MainWindow::fillRecentFiles);
    menu->addSeparator();
    add(menu, tr("&Save"), QKeySequence::Save, [this] { files_->save(); });
    add(menu, tr("Save &As…"), QKeySequence("Ctrl+Shift+S"), [this] { files_->saveAs(); });
    add(menu, tr("&Export Material as Preset…"), QKeySequence("Ctrl+E"),
        [this] { files_->exportPreset(); });
    add(menu, tr("Export Pict&ure…"), QKeySequence("Ctrl+Shift+E"), [this] { exportPicture(); });
    menu->addSeparator();
    add(menu, tr("&Import Mesh…"), QKeySequence("Ctrl+I"), [this] { files_->importMesh(); });
    QAction* allow = add(menu, tr("Allow Files Ou&tside…"), {}, [this] { files_->allowOutside(); });
    allow->setObjectName("allowOutside");
    connect(menu, &QMenu::aboutToShow, this,
            [this, allow] { allow->setEnabled(!documentFiles_.withheld().all().empty()); });
    menu->addSeparator();
    add(menu, tr("&Quit"), QKeySequence::Quit, [this] { close(); });
}

void MainWindow::fillRecentFiles() {
    recent_->clear();
    for (const QString& file : session_.recentFiles()) {
        // A single & would underline the letter after it.
        const QString name =
            shortened(QFileInfo(file).fileName()).replace('&', QLatin1String("&&"));
        QAction* action = recent_->addAction(name, this, [this, file] {
            files_->open({file}, document_.activeSide());
        });
        action->setToolTip(file);
    }
    recent_->setToolTipsVisible(true);
    if (recent_->isEmpty()) {
        recent_->addAction(tr("No files yet"))->setEnabled(false);
        return;
    }
    recent_->addSeparator();
    recent_->addAction(tr("Clear this list"), this, [this] { session_.clearRecentFiles(); });
}

void MainWindow::makeEditMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&Edit"));
    QAction* undo = document_.undoStack().createUndoAction(this, tr("&Undo"));
    undo->setShortcut(QKeySequence::Undo);
    QAction* redo = document_.undoStack().createRedoAction(this, tr("&Redo"));
    redo->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
    menu->addActions({undo, redo});
    menu->addSeparator();
    add(menu, tr("Material &Details…"), QKeySequence("Alt+Return"),
        [this] { files_->editDetails(); });
}

void MainWindow::makeViewMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&View"));
    compare_ = add(menu, tr("&Compare A and B"), QKeySequence("Ctrl+B"),
                   [this] { comparison_.setComparing(compare_->isChecked()); });
    compare_->setCheckable(true);
    compare_->setToolTip(tr("Show two materials side by side (Ctrl+B)"));
    link_ = add(menu, tr("&Link Cameras"), QKeySequence("Ctrl+L"),
                [this] { views_->setCamerasLinked(link_->isChecked()); });
    link_->setCheckable(true);
    link_->setChecked(true);
    link_->setToolTip(tr("Both views move together (Ctrl+L)"));
    realign_ = add(menu, tr("Re-&align Cameras"), QKeySequence("Ctrl+R"),
                   [this] { views_->realignCameras(); });
    realign_->setToolTip(tr("B looks from where A does (Ctrl+R)"));
    swap_ = add(menu, tr("S&wap A and B"), QKeySequence("X"), [this] { comparison_.swapSides(); });
    swap_->setToolTip(tr("Exchange the two materials (X)"));
    difference_ = add(menu, tr("&Difference in C"), QKeySequence("Ctrl+D"),
                      [this] { views_->setDifferenceWanted(difference_->isChecked()); });
    difference_->setCheckable(true);
    difference_->setToolTip(tr("Show how far A and B are apart beside them (Ctrl+D)"));
    menu->addSeparator();
    QAction* inspect = menu->addAction(tr("&Numerical Check"));
    inspect->setObjectName("inspect");
    inspect->setShortcut(QKeySequence("N"));
    inspect->setCheckable(true);
    inspect->setToolTip(tr("Mark pixels whose numbers are wrong, and read those under the "
                           "pointer (N)"));
    connect(inspect, &QAction::toggled, views_, &CompareArea::setInspecting);
    add(menu, tr("Check &Stability"), QKeySequence("Ctrl+K"), [this] { checkStability(); });
    add(menu, tr("&Effects and Their Costs"), QKeySequence("E"), [this] { showEffects(); });
    add(menu, tr("Acc&uracy and Its Cost"), QKeySequence("A"), [this] {
        dock("accuracy")->show();
        dock("accuracy")->raise(); // it may lie behind other tabs
    });
    menu->addSeparator();
    add(menu, tr("&Frame Object"), QKeySequence("F"),
        [this] { views_->active().frameCurrentObject(); });
    QAction* reset = add(menu, tr("&Reset View"), QKeySequence(Qt::Key_Home),
                         [this] { views_->resetCamera(document_.activeSide()); });
    // Home means something else in number boxes and lists.
    reset->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    menu->removeAction(reset);
    views_->addAction(reset);
    menu->addAction(reset);
    menu->addSeparator();
    makeLookMenu(menu->addMenu(tr("L&ook")));
    QMenu* panels = menu->addMenu(tr("&Panels"));
    for (const DockEntry& entry : dockList()) {
        panels->addAction(dock(entry.name)->toggleViewAction());
    }
    panels->addSeparator();
    add(panels, tr("Reset Layout"), {}, [this] {
        for (const auto& [place, first] : firstDocks_) {
            for (const DockEntry& entry : dockList()) {
                QDockWidget* each = dock(entry.name);
                each->setFloating(false);
                if (entry.place == place && each != first) {
                    each->show();
                    tabifyDockWidget(first, each);
                }
            }
        }
        arrangeDocks();
    });
    QAction* full = add(menu, tr("F&ull Screen"), QKeySequence(Qt::Key_F11), [this] {
        setWindowState(windowState() ^ Qt::WindowFullScreen);
    });
    full->setCheckable(true);
    const auto follow = [this] {
        const bool comparing = document_.isComparing();
        compare_->setChecked(comparing);
        for (QAction* action : {link_, realign_, swap_, difference_}) {
            action->setEnabled(comparing);
        }
    };
    onChange(document_, DocumentChange::Comparing, this, follow);
    connect(views_, &CompareArea::linkChanged, link_, &QAction::setChecked);
    connect(views_, &CompareArea::differenceWantedChanged, difference_, &QAction::setChecked);
    follow();
}

void MainWindow::makeLookMenu(QMenu* menu) {
    auto* group = new QActionGroup(this);
    const std::pair<QString, Look> looks[] = {{tr("As the &System"), Look::System},
                                              {tr("&Dark"), Look::Dark},
                                              {tr("&Light"), Look::Light}};
    for (const auto& [text, look] : looks) {
        QAction* action = add(menu, text, {}, [this, look = look] {
            theme_.setLook(look);
            session_.setLook(look);
        });
        action->setCheckable(true);
        action->setChecked(session_.look() == look);
        group->addAction(action);
    }
}

void MainWindow::makeHelpMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&Help"));
    add(menu, tr("&Mouse and Keys"), QKeySequence(Qt::Key_F1), [this] { showKeys(); });
    add(menu, tr("&About Patina"), {}, [this] { showAbout(); });
}

void MainWindow::makeToolBar() {
    QToolBar* bar = addToolBar(tr("Tools"));
    bar->setObjectName("tools");
    bar->setMovable(false);
    bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
    bar->addActions({compare_, link_, realign_, swap_, difference_});
}

void MainWindow::showKeys() {
    const auto row = [](const QString& keys, const QString& what) {
        return QStringLiteral("<tr><td><b>%1</b></td><td>&nbsp;&nbsp;%2</td></tr>").arg(keys, what);
    };
    const QString table =
        "<table>" + row(tr("Left drag, Alt+left"), tr("orbit")) +
        row(tr("Middle drag, Shift+left, Alt+middle"), tr("pan")) +
        row(tr("Wheel, right drag, Alt+right"), tr("move nearer or farther")) +
        row(tr("Ctrl+left drag"), tr("turn the object")) +
        row(tr("L and left drag"), tr("turn the key light")) +
        row(tr("Double click"), tr("turn about that point of the surface")) +
        row(tr("N"), tr("numerical check of every pixel")) +
        row(tr("F"), tr("frame the object")) + row(tr("Home"), tr("reset the view")) +
        row(tr("1, 3, 7 of the number pad"), tr("from the front, the right, above")) +
        row(tr("Drag on a slider or a name"), tr("change it; Shift: finer, Ctrl: steps")) +
        row(tr("Arrows, Page Up, Page Down"), tr("one step, ten steps")) +
        row(tr("Backspace, double click on a name"), tr("back to the default")) + "</table>";
    QMessageBox::information(this, tr("Mouse and Keys"), table);
}

void MainWindow::showAbout() {
    QMessageBox::about(this, tr("About Patina"),
                       tr("<p><b>Patina %1</b></p><p>An editor of lighting models.</p>"
                          "<p>The program is free software under the GNU General Public License, "
                          "version 3 or later. What you make with it is yours.</p>")
                           .arg(QCoreApplication::applicationVersion()));
}

} // namespace patina
