// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/menus.h"

#include <utility>

#include <QActionGroup>
#include <QDesktopServices>
#include <QDockWidget>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenuBar>
#include <QPointer>
#include <QToolBar>
#include <QToolButton>
#include <QUrl>

#include "docks/lamp_taking.h"
#include "docks/light_actions.h"
#include "docks/material_actions.h"
#include "docks/object_actions.h"
#include "docks/snapshots_dock.h"
#include "docks/stability_dock.h"
#include "document/comparison.h"
#include "document/document_files.h"
#include "files/file_actions.h"
#include "files/material_exporter.h"
#include "files/picture_export.h"
#include "files/turntable_export.h"
#include "session/session.h"
#include "text/short_text.h"
#include "viewport/compare_area.h"
#include "viewport/views_capture.h"
#include "window/command_keys.h"
#include "window/command_palette.h"
#include "window/compare_bar.h"
#include "window/exposure_bar.h"
#include "window/help.h"
#include "window/inspection_menu.h"
#include "window/lighting_menu.h"
#include "window/named_choices.h"
#include "window/preferences_dialog.h"
#include "window/shortcut_sheet.h"
#include "window/theme.h"
#include "window/window_layout.h"

namespace patina {

Menus::Menus(const Parts& parts)
    : QObject(&parts.window), parts_(parts), steps_(parts.document, parts.presets, parts.files),
      capture_(new ViewsCapture(parts.views)) {
    makeFileMenu();
    makeEditMenu();
    makeObjectMenu();
    makeLightMenu();
    makeViewMenu();
    makeHelpMenu();
    makeToolBar();
    keys_ = new CommandKeys(*parts.window.menuBar(), parts.session, this);
    parts.views.setMouseHabits(parts.session.mouseHabits());
}

QAction* Menus::add(QMenu* menu, const QString& text, const QKeySequence& key,
                    std::function<void()> what) {
    QAction* action = menu->addAction(text);
    action->setShortcut(key);
    connect(action, &QAction::triggered, this, std::move(what));
    return action;
}

/// Adds an action whose key works only where a view has the focus, as it means something else in
/// lists and number boxes.
QAction* Menus::addForViews(QMenu* menu, const QString& text, const QKeySequence& key,
                            std::function<void()> what) {
    auto* action = new QAction(text, this);
    action->setShortcut(key);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(action, &QAction::triggered, this, std::move(what));
    parts_.views.addAction(action); // added before the menu, or the whole window would have its key
    menu->addAction(action);
    return action;
}

void Menus::makeFileMenu() {
    QMenu* menu = parts_.window.menuBar()->addMenu(tr("&File"));
    add(menu, tr("&New"), QKeySequence::New, [this] { parts_.files.newDocument(); });
    add(menu, tr("&Open…"), QKeySequence::Open, [this] { parts_.files.askAndOpen(); });
    recent_ = menu->addMenu(tr("Open &Recent"));
    connect(recent_, &QMenu::aboutToShow, this, &Menus::fillRecentFiles);
    menu->addSeparator();
    add(menu, tr("&Save"), QKeySequence::Save, [this] { parts_.files.saving().save(); });
    add(menu, tr("Save &As…"), QKeySequence("Ctrl+Shift+S"),
        [this] { parts_.files.saving().saveAs(); });
    add(menu, tr("&Export Material as Preset…"), QKeySequence("Ctrl+E"),
        [this] { parts_.files.saving().exportPreset(); });
    add(menu, tr("Export Material for &Other Programs…"), {}, [this] {
        if (const Material* material =
                parts_.document.material(parts_.document.selection().side())) {
            parts_.exporter.ask(*material, parts_.document.sharedCatalog());
        }
    });
    add(menu, tr("Export Pict&ure…"), {}, [this] {
        exportPicture();
    })->setShortcuts({QKeySequence("Ctrl+Shift+E"), QKeySequence(Qt::Key_F12)});
    add(menu, tr("Export &Turntable…"), {}, [this] { exportTurntable(); });
    QAction* parked = menu->addAction(tr("&Keep Values of Other Models in Presets"));
    parked->setObjectName("keepParked");
    menu->setToolTipsVisible(true);
    parked->setCheckable(true);
    parked->setToolTip(tr("Presets then also hold what models that were chosen before had"));
    connect(parked, &QAction::toggled, this, [this](bool keeps) {
        parts_.session.setKeepsParked(keeps);
        parts_.documentFiles.setKeepsParked(keeps);
    });
    parked->setChecked(parts_.session.keepsParked());
    menu->addSeparator();
    add(menu, tr("&Import Mesh…"), QKeySequence("Ctrl+I"),
        [this] { parts_.files.meshes().askAndImport(); });
    add(menu, tr("Rea&d Files Again"), QKeySequence(Qt::Key_F5),
        [this] { parts_.files.readAgain(); })
        ->setToolTip(
            tr("Reads images, meshes, environments and presets that another program has written"));
    QAction* allow =
        add(menu, tr("Allow Files Ou&tside…"), {}, [this] { parts_.files.allowOutside(); });
    allow->setObjectName("allowOutside");
    connect(menu, &QMenu::aboutToShow, this,
            [this, allow] { allow->setEnabled(!parts_.documentFiles.withheld().all().empty()); });
    menu->addSeparator();
    add(menu, tr("&Quit"), QKeySequence::Quit, [this] { parts_.window.close(); });
}

void Menus::fillRecentFiles() {
    recent_->clear();
    for (const QString& file : parts_.session.recentFiles()) {
        // A single & would underline the letter after it.
        const QString name =
            shortened(QFileInfo(file).fileName()).replace('&', QLatin1String("&&"));
        QAction* action = recent_->addAction(name, this, [this, file] {
            parts_.files.open({file}, parts_.document.selection().side());
        });
        action->setToolTip(file);
    }
    recent_->setToolTipsVisible(true);
    if (recent_->isEmpty()) {
        recent_->addAction(tr("No files yet"))->setEnabled(false);
        return;
    }
    recent_->addSeparator();
    recent_->addAction(tr("Clear this list"), this, [this] { parts_.session.clearRecentFiles(); });
}

void Menus::makeEditMenu() {
    QMenu* menu = parts_.window.menuBar()->addMenu(tr("&Edit"));
    QAction* undo = parts_.document.undoStack().createUndoAction(this, tr("&Undo"));
    undo->setShortcut(QKeySequence::Undo);
    QAction* redo = parts_.document.undoStack().createRedoAction(this, tr("&Redo"));
    redo->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
    menu->addActions({undo, redo});
    menu->addSeparator();
    add(menu, tr("&Take Snapshot"), QKeySequence("Ctrl+T"), [this] { takeSnapshot(); });
    QMenu* material = menu->addMenu(tr("&Material"));
    material->setToolTipsVisible(true);
    parts_.views.addAction(parts_.material.original()); // first, as in addForViews()
    material->addActions({parts_.material.all().begin(), parts_.material.all().end()});
    add(menu, tr("&Preferences…"), QKeySequence("Ctrl+,"), [this] {
        (new PreferencesDialog(parts_.session, parts_.theme, parts_.views, &parts_.window))->open();
    });
    add(menu, tr("Material &Details…"), QKeySequence("Alt+Return"),
        [this] { parts_.files.editDetails(); });
    menu->addSeparator();
    add(menu, tr("Take Lamps &Out of the Environment"), {},
        [this] { takeLampsOut(parts_.document, parts_.views, parts_.messages); });
}

/// Lets the keys work where a view has the focus, as they mean something else in lists and number
/// boxes.
void Menus::makeObjectMenu() {
    QMenu* menu = parts_.window.menuBar()->addMenu(tr("&Object"));
    for (QAction* action : (new ObjectActions(parts_.document, parts_.files, this))->all()) {
        parts_.views.addAction(action);
        menu->addAction(action);
    }
    menu->addSeparator();
    makeGizmos(menu);
}

/// Adds the keys of the handles: each shows its handles, and hides them again.
void Menus::makeGizmos(QMenu* menu) {
    HandleModes& modes = parts_.views.handleModes();
    const struct {
        QString text;
        const char* key;
        Gizmo gizmo;
    } rows[] = {{tr("Handles: &Move"), "W", Gizmo::Move},
                {tr("Handles: &Turn"), "R", Gizmo::Turn},
                {tr("Handles: S&cale"), "S", Gizmo::Scale}};
    for (const auto& row : rows) {
        QAction* action =
            addForViews(menu, row.text, QKeySequence(row.key), [&modes, gizmo = row.gizmo] {
                modes.setGizmo(modes.gizmo() == gizmo ? Gizmo::None : gizmo);
            });
        action->setCheckable(true);
        connect(&modes, &HandleModes::changed, action, [action, &modes, gizmo = row.gizmo] {
            action->setChecked(modes.gizmo() == gizmo);
        });
    }
}

void Menus::makeLightMenu() {
    QMenu* menu = parts_.window.menuBar()->addMenu(tr("Li&ght"));
    menu->setToolTipsVisible(true);
    HandleModes& modes = parts_.views.handleModes();
    QAction* shown = menu->addAction(tr("Show &Lights in the Views"));
    shown->setObjectName("showLights");
    shown->setCheckable(true);
    connect(shown, &QAction::toggled, this, [this, &modes](bool shows) {
        modes.setShowsLights(shows);
        parts_.session.setShowsLights(shows);
    });
    modes.setShowsLights(parts_.session.showsLights());
    shown->setChecked(modes.showsLights());
    menu->addSeparator();
    add(menu, tr("Put the &Highlight There…"), {}, [this] {
        parts_.views.active().awaitLightPick(false);
    })->setToolTip(tr("Click where the highlight of the current light is to be (L+click)"));
    add(menu, tr("Put the &Shadow There…"), {}, [this] {
        parts_.views.active().awaitLightPick(true);
    })->setToolTip(tr("Click where the shadow of the current object is to fall (L+Shift+click)"));
    menu->addSeparator();
    for (QAction* action : (new LightActions(parts_.document, parts_.files, this))->all()) {
        action->setShortcuts(QList<QKeySequence>()); // in a view these keys belong to the objects
        action->setShortcutContext(Qt::WindowShortcut);
        menu->addAction(action);
    }
}

void Menus::makeViewMenu() {
    QMenu* menu = parts_.window.menuBar()->addMenu(tr("&View"));
    makeCompareMenu(menu);
    menu->addSeparator();
    QAction* inspect = addForViews(menu, tr("&Numerical Check"), QKeySequence("N"), [] {});
    inspect->setObjectName("inspect");
    inspect->setCheckable(true);
    inspect->setToolTip(tr("Mark pixels whose numbers are wrong, and read those under the "
                           "pointer (N)"));
    menu->addMenu(new InspectionMenu(*inspect, parts_.document, parts_.views, &parts_.window));
    lighting_ = new LightingMenu(parts_.document, parts_.thumbnails, &parts_.window);
    menu->addMenu(lighting_);
    add(menu, tr("Check &Stability"), QKeySequence("Ctrl+Shift+K"), [this] { checkStability(); });
    addForViews(menu, tr("&Effects and Their Costs"), QKeySequence("E"),
                [this] { parts_.layout.bringToFront("effects"); });
    addForViews(menu, tr("Acc&uracy and Its Cost"), QKeySequence("A"),
                [this] { parts_.layout.bringToFront("accuracy"); });
    add(menu, tr("L&obe of the Material"), QKeySequence("Ctrl+Shift+R"),
        [this] { parts_.layout.bringToFront("lobe"); });
    menu->addSeparator();
    addForViews(menu, tr("&Frame Object"), QKeySequence("F"),
                [this] { parts_.views.active().frameObjects(); });
    addForViews(menu, tr("&Reset View"), QKeySequence(Qt::Key_Home),
                [this] { parts_.views.cameras().reset(parts_.document.selection().side()); });
    makeCameraMoves(menu);
    makeTurntable(menu->addMenu(tr("Turnta&ble")));
    menu->addSeparator();
    makeLookMenu(menu->addMenu(tr("L&ook")));
    makePanelMenu(menu->addMenu(tr("&Panels")));
    QAction* full = add(menu, tr("F&ull Screen"), QKeySequence(Qt::Key_F11), [this] {
        parts_.window.setWindowState(parts_.window.windowState() ^ Qt::WindowFullScreen);
    });
    full->setCheckable(true);
}

void Menus::makePanelMenu(QMenu* menu) {
    for (QAction* dock : parts_.layout.dockActions()) {
        menu->addAction(dock);
    }
    menu->addSeparator();
    for (const DockEntry& entry : parts_.layout.entries()) {
        QMenu* pages =
            entry.pages.empty() ? nullptr : menu->addMenu(tr("Pages of %1").arg(entry.title));
        for (std::size_t i = 0; i < entry.pages.size(); ++i) {
            QAction* page = add(pages, entry.pages[i].title, {}, [this, name = entry.name, i] {
                parts_.layout.openPage(name, static_cast<int>(i));
            });
            page->setWhatsThis(entry.pages[i].what);
        }
    }
    menu->addSeparator();
    add(menu, tr("Reset Layout"), {}, [this] { parts_.layout.reset(); });
}

/// Adds an action for each thing that can turn; choosing it once more stops it.
void Menus::makeTurntable(QMenu* menu) {
    ViewTurntable& turntable = parts_.views.turntable();
    const std::pair<QString, TurntableOf> rows[] = {
        {tr("Turn the &Objects"), TurntableOf::Object},
        {tr("Turn the &Lights"), TurntableOf::Light},
        {tr("Turn the &Environment"), TurntableOf::Environment}};
    for (const auto& [text, what] : rows) {
        QAction* action = add(menu, text, {}, [this, &turntable, what = what] {
            const bool isTurning = turntable.turning() == what;
            const auto done = turntable.setTurning(isTurning ? std::nullopt : std::optional(what));
            if (!done) {
                parts_.files.report(done.error());
            }
        });
        action->setCheckable(true);
        const auto follow = [action, &turntable, what = what] {
            action->setChecked(turntable.turning() == what);
        };
        connect(action, &QAction::triggered, action, follow);
        connect(&turntable, &ViewTurntable::changed, action, follow);
    }
}

void Menus::makeCameraMoves(QMenu* menu) {
    add(menu, tr("Ort&hographic"), {}, [this] { parts_.views.active().toggleLens(); })
        ->setToolTip(tr("A lens so narrow that parallel lines look parallel; once more: the one "
                        "before (5 of the number pad)"));
    CameraHistory& history = parts_.views.cameras().history();
    QAction* undo =
        add(menu, tr("Undo Camera &Move"), QKeySequence("Alt+Z"), [&history] { history.undo(); });
    QAction* redo = add(menu, tr("Redo Camera Mo&ve"), QKeySequence("Shift+Alt+Z"),
                        [&history] { history.redo(); });
    const auto follow = [&history, undo, redo] {
        undo->setEnabled(history.canUndo());
        redo->setEnabled(history.canRedo());
    };
    connect(&history, &CameraHistory::changed, this, follow);
    follow();
}

void Menus::makeCompareMenu(QMenu* menu) {
    compare_ = add(menu, tr("&Compare A and B"), QKeySequence("Ctrl+B"),
                   [this] { parts_.comparison.setComparing(compare_->isChecked()); });
    compare_->setCheckable(true);
    compare_->setToolTip(tr("Show two materials together (Ctrl+B)"));
    modes_ = menu->addMenu(tr("Compare A&s"));
    modes_->setObjectName("compareModes");
    modes_->setToolTipsVisible(true);
    auto* group = new QActionGroup(this);
    const auto choose = [this](CompareMode mode) {
        CompareLook look = parts_.views.look();
        look.mode = mode;
        parts_.views.setLook(look);
    };
    for (const CompareModeRow& row : compareModes()) {
        QAction* action =
            add(modes_, row.shownLabel(), {}, [choose, mode = row.mode] { choose(mode); });
        action->setToolTip(row.shownDoc());
        action->setCheckable(true);
        group->addAction(action);
    }
    modes_->addSeparator();
    auto* arrangements = new QActionGroup(this);
    const std::pair<QString, ViewArrangement> ways[] = {
        {tr("Views in a &Grid"), ViewArrangement::Grid},
        {tr("Views in a &Row"), ViewArrangement::Row},
        {tr("Views in a &Column"), ViewArrangement::Column}};
    for (const auto& [text, arrangement] : ways) {
        QAction* action = add(modes_, text, {}, [this, arrangement = arrangement] {
            CompareLook look = parts_.views.look();
            look.arrangement = arrangement;
            parts_.views.setLook(look);
        });
        action->setCheckable(true);
        arrangements->addAction(action);
    }
    modes_->addSeparator();
    QAction* more = add(modes_, tr("&One View More"), QKeySequence("Ctrl+Shift+B"), [this] {
        parts_.comparison.setSideCount(parts_.document.shownSides() + 1);
    });
    QAction* fewer = add(modes_, tr("One View &Less"), QKeySequence("Ctrl+Alt+B"), [this] {
        parts_.comparison.setSideCount(parts_.document.shownSides() - 1);
    });
    modes_->addSeparator();
    makeLibrarySteps(modes_);
    modes_->addSeparator();
    QAction* next = addForViews(modes_, tr("&Next Mode"), QKeySequence("C"), [this, choose] {
        const auto rows = compareModes();
        const auto now = static_cast<std::size_t>(&rowOf(parts_.views.look().mode) - rows.data());
        choose(rows[(now + 1) % rows.size()].mode);
    });
    link_ = add(menu, tr("&Link Cameras"), QKeySequence("Ctrl+L"),
                [this] { parts_.views.cameras().setLinked(link_->isChecked()); });
    link_->setCheckable(true);
    link_->setChecked(true);
    link_->setToolTip(tr("Both views move together (Ctrl+L)"));
    realign_ = add(menu, tr("Re-&align Cameras"), QKeySequence("Ctrl+R"),
                   [this] { parts_.views.cameras().realign(); });
    realign_->setToolTip(tr("B looks from where A does (Ctrl+R)"));
    swap_ = addForViews(menu, tr("S&wap A and B"), QKeySequence("X"),
                        [this] { parts_.comparison.swapSides(); });
    swap_->setToolTip(tr("Exchange the two materials (X)"));
    difference_ = add(menu, tr("&Difference"), QKeySequence("Ctrl+D"),
                      [this] { parts_.views.setDifferenceWanted(difference_->isChecked()); });
    difference_->setCheckable(true);
    difference_->setToolTip(tr("Show how far A and another view are apart beside them (Ctrl+D)"));
    const auto follow = [this, group, arrangements, next, more, fewer] {
        const bool comparing = parts_.document.isComparing();
        compare_->setChecked(comparing);
        for (QAction* action : {next, fewer, link_, realign_, swap_, difference_}) {
            action->setEnabled(comparing);
        }
        more->setEnabled(parts_.document.shownSides() < sides.size());
        group->setEnabled(comparing);
        arrangements->setEnabled(comparing);
    };
    onChange(parts_.document, DocumentChange::Comparing, this, follow);
    connect(&parts_.views.cameras(), &ViewCameras::linkChanged, link_, &QAction::setChecked);
    connect(&parts_.views, &CompareArea::differenceWantedChanged, difference_,
            &QAction::setChecked);
    const auto followLook = [this, group, arrangements](const CompareLook& look) {
        parts_.session.setCompareLook(look);
        arrangements->actions().at(static_cast<int>(look.arrangement))->setChecked(true);
        const auto at = &rowOf(look.mode) - compareModes().data();
        group->actions().at(at)->setChecked(true);
    };
    connect(&parts_.views, &CompareArea::lookChanged, this, followLook);
    parts_.views.setLook(parts_.session.compareLook());
    followLook(parts_.views.look());
    follow();
}

/// Lets the keys work where a view has the focus, as they mean something else in lists and number
/// boxes.
void Menus::makeLibrarySteps(QMenu* menu) {
    const struct {
        QString text;
        const char* key;
        Side side;
        int by;
    } steps[] = {{tr("Next Preset on B"), "PgDown", Side::B, 1},
                 {tr("Previous Preset on B"), "PgUp", Side::B, -1},
                 {tr("Next Preset on A"), "Shift+PgDown", Side::A, 1},
                 {tr("Previous Preset on A"), "Shift+PgUp", Side::A, -1}};
    for (const auto& step : steps) {
        addForViews(menu, step.text, QKeySequence(step.key),
                    [this, side = step.side, by = step.by] { steps_.step(side, by); });
    }
}

void Menus::makeLookMenu(QMenu* menu) {
    auto* group = new QActionGroup(this);
    const std::pair<QString, Look> looks[] = {{tr("As the &System"), Look::System},
                                              {tr("&Dark"), Look::Dark},
                                              {tr("&Light"), Look::Light}};
    for (const auto& [text, look] : looks) {
        QAction* action = add(menu, text, {}, [this, look = look] {
            parts_.theme.setLook(look);
            parts_.session.setLook(look);
        });
        action->setCheckable(true);
        action->setChecked(parts_.session.look() == look);
        group->addAction(action);
    }
}

void Menus::makeHelpMenu() {
    QMenu* menu = parts_.window.menuBar()->addMenu(tr("He&lp"));
    QAction* sheet = add(menu, tr("&Mouse and Keys…"), {}, [this] {
        (new ShortcutSheet(*keys_, parts_.session.mouseHabits(), &parts_.window))->open();
    });
    sheet->setShortcuts({QKeySequence(Qt::Key_F1), QKeySequence("?")});
    add(menu, tr("&Run a Command…"), QKeySequence("Ctrl+K"), [this] {
        (new CommandPalette(*keys_, namedChoices(parts_.document, parts_.presets, parts_.files),
                            &parts_.window))
            ->open();
    });
    const auto link = [&](const QString& words, const char* page) {
        add(menu, words, {}, [page] { QDesktopServices::openUrl(QUrl(page)); });
    };
    menu->addSeparator();
    link(tr("Measured Surfaces of M&ERL…"), "https://www.merl.com/research/downloads/BRDF");
    link(tr("Measured Surfaces of R&GL…"), "https://rgl.epfl.ch/materials");
    menu->addSeparator();
    add(menu, tr("&About Patina"), {}, [this] { showAbout(&parts_.window); });
}

void Menus::makeToolBar() {
    QToolBar* bar = parts_.window.addToolBar(tr("Tools"));
    bar->setObjectName("tools");
    bar->setMovable(false);
    bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
    bar->addAction(compare_);
    auto* compared = new CompareBar(parts_.document, parts_.comparison, parts_.views);
    connect(compared, &CompareBar::stepWished, this,
            [this](Side side, int by) { steps_.step(side, by); });
    bar->addWidget(compared);
    bar->addActions({link_, realign_, swap_, difference_});
    bar->addSeparator();
    auto* lighting = new QToolButton(bar);
    lighting->setObjectName("lightingButton");
    lighting->setText(tr("Lighting"));
    lighting->setToolTip(tr("Light the objects as in one of the scenes that ship"));
    lighting->setMenu(lighting_);
    lighting->setPopupMode(QToolButton::InstantPopup);
    bar->addWidget(lighting);
    bar->addWidget(new ExposureBar(parts_.document, parts_.views, bar));
}

void Menus::exportTurntable() {
    const QPointer views(capture_);
    const Material* material = parts_.document.material(Side::A);
    parts_.turntables.ask(
        SaveActions::asFileName(QString::fromStdString(material ? material->name : "")),
        {[views](bool display, PictureCapture::SceneChange change, PictureCapture::Taken taken) {
             views ? views->start(display, std::move(taken), change) : taken({});
         },
         [views] {
             if (views) {
                 views->cancel();
             }
         }});
}

void Menus::exportPicture() {
    const QPointer views(capture_);
    const auto capture = [views](bool display, PictureCapture::Taken taken) {
        views ? views->start(display, std::move(taken)) : taken({});
    };
    const auto cancel = [views] {
        if (views) {
            views->cancel();
        }
    };
    PictureExport::Source source{capture, cancel};
    QStringList names;
    for (const Side side : sides) {
        const Material* material =
            indexOf(side) < parts_.document.shownSides() ? parts_.document.material(side) : nullptr;
        if (material) {
            names << QString::fromStdString(material->name);
        }
    }
    const bool isComparing = parts_.document.isComparing();
    if (isComparing) {
        source.captureEach = [views](const std::function<void(std::vector<NamedPicture>)>& taken) {
            if (!views) {
                taken({});
                return;
            }
            views->startEach(true, [taken](std::vector<SidePictureTaken> pictures) {
                std::vector<NamedPicture> named;
                for (SidePictureTaken& each : pictures) {
                    named.push_back({letterOf(each.side), each.caption, colourOf(each.side).name(),
                                     std::move(each.picture)});
                }
                taken(std::move(named));
            });
        };
    }
    const QString title = isComparing ? tr("Export picture: the views as they stand, with titles")
                                      : tr("Export picture");
    parts_.pictures.ask(title, SaveActions::asFileName(names.join(' ')), source);
}

void Menus::takeSnapshot() {
    parts_.layout.bringToFront("snapshots");
    if (auto* snapshots = parts_.layout.dock("snapshots")->findChild<SnapshotsDock*>()) {
        snapshots->take();
    }
}

void Menus::checkStability() {
    parts_.layout.bringToFront("stability");
    if (auto* check = parts_.layout.dock("stability")->findChild<StabilityDock*>()) {
        check->start();
    }
}

} // namespace patina
