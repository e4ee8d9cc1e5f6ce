// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/main_window.h"

#include <functional>
#include <utility>

#include <QActionGroup>
#include <QCloseEvent>
#include <QCoreApplication>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QLocale>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPointer>
#include <QPushButton>
#include <QScreen>
#include <QToolBar>
#include <QUrl>

#include "docks/stability_dock.h"
#include "files/key_pause.h"
#include "gl/driver_cache.h"
#include "text/short_text.h"
#include "window/focus_order.h"
#include "window/lazy_dock.h"

namespace patina {
namespace {

/// Goes up when docks come, go or move, so that an older layout is not forced upon them.
constexpr int layoutVersion = 5;

constexpr QSize preferredSize{1600, 1000};
constexpr int narrowWindow = 1400;
constexpr int saidMs = 4000; ///< so long the status line says what was done

std::filesystem::path programCacheFolder() {
    return cacheFolder() / "programs";
}

Qt::DockWidgetArea areaOf(DockPlace place) {
    switch (place) {
    case DockPlace::LeftTop:
    case DockPlace::LeftBottom:
        return Qt::LeftDockWidgetArea;
    case DockPlace::Bottom:
        return Qt::BottomDockWidgetArea;
    default:
        return Qt::RightDockWidgetArea;
    }
}

} // namespace

MainWindow::MainWindow(std::shared_ptr<const Catalog> catalog, Theme& theme)
    : theme_(theme), document_(catalog), switches_(document_, effects_), watcher_(catalog),
      presets_(catalog), thumbnails_(catalog, {cacheFolder() / "thumbnails", programCacheFolder(),
                                               defaultSceneFile()}),
      programs_(programCacheFolder()),
      autosave_(document_, documentFiles_, stateFolder() / "autosave"),
      files_(new FileActions(document_, documentFiles_, meshes_, session_, this)),
      pictures_(new PictureExport(session_, this)),
      views_(new CompareArea(
          {document_, meshes_, textures_, environments_, switches_, effects_, programs_},
          programCacheFolder(), this)),
      status_(new StatusLine(document_, meshes_, textures_, environments_, messages_, this)) {
    setAcceptDrops(true);
    setCentralWidget(views_);
    setStatusBar(status_);
    makeDocks();
    makeFileMenu();
    makeEditMenu();
    makeViewMenu();
    makeHelpMenu();
    makeToolBar();
    connectParts();
    messages_.setGroup("catalog", catalog->errors);
    if (const auto& note = gl::driverCacheNote()) {
        messages_.add(*note);
    }
    updateTitle();
    restoreWindow();
}

MainWindow::~MainWindow() {
    // The views and docks go before the parts that they look at.
    for (const auto& [name, dock] : docks_) {
        delete dock;
    }
    delete status_;
    delete views_;
    delete pictures_;
    delete files_;
}

QDockWidget* MainWindow::dock(const QString& name) const {
    const auto found = docks_.find(name);
    return found == docks_.end() ? nullptr : found->second;
}

void MainWindow::startRest() {
    watcher_.start();
    presets_.scan();
    thumbnails_.start();
    trials_.run(document_.sharedCatalog());
    theme_.followDesktop();
    views_->first().viewport().frames().chooseTimer();
}

DockContext MainWindow::dockContext() {
    return {document_,   comparison_, documentFiles_, *files_,       messages_, presets_,
            thumbnails_, meshes_,     textures_,      environments_, switches_, *views_};
}

void MainWindow::makeDocks() {
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    setDockOptions(QMainWindow::AllowTabbedDocks | QMainWindow::AllowNestedDocks);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    const DockContext context = dockContext();
    for (const DockEntry& entry : dockList()) {
        auto* dock = new LazyDock(entry, context, this);
        docks_[entry.name] = dock;
        const auto [first, isFirst] = firstDocks_.try_emplace(entry.place, dock);
        addDockWidget(areaOf(entry.place), dock);
        if (!isFirst) {
            tabifyDockWidget(first->second, dock);
        }
    }
}

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
        QAction* action = recent_->addAction(
            name, this, [this, file] { files_->open({file}, document_.activeSide()); });
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
    QAction* full = add(menu, tr("F&ull Screen"), QKeySequence(Qt::Key_F11),
                        [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
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
        row(tr("N"), tr("numerical check of every pixel")) + row(tr("F"), tr("frame the object")) +
        row(tr("Home"), tr("reset the view")) +
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

void MainWindow::connectParts() {
    connect(&documentFiles_, &DocumentFiles::message, &messages_, &MessageLog::add);
    connect(&meshes_, &MeshLibrary::remarked, &messages_, &MessageLog::add);
    connect(&textures_, &TextureLibrary::failed, this,
            [this](const QString&, const Error& why) { messages_.add(why); });
    onChange(document_, DocumentChange::Scene, &textures_, &TextureLibrary::forgetFailures);
    connect(&environments_, &EnvironmentLibrary::failed, &messages_, &MessageLog::add);
    onChange(document_, DocumentChange::Scene, &environments_, &EnvironmentLibrary::forgetFailure);
    connect(&documentFiles_.withheld(), &WithheldFiles::changed, this, [this] {
        const auto withheld = documentFiles_.withheld().withoutImages();
        meshes_.withhold(withheld);
        environments_.withhold(withheld);
    });
    connect(pictures_, &PictureExport::failed, &messages_, &MessageLog::add);
    connect(pictures_, &PictureExport::saved, this, [this](const QString& file) {
        status_->showMessage(tr("%1 is written").arg(QFileInfo(file).fileName()), saidMs);
    });
    connect(&autosave_, &Autosave::failed, &messages_, &MessageLog::add);
    connect(&presets_, &PresetLibrary::checked, this,
            [this](const Errors& mistakes) { messages_.setGroup("presets", mistakes); });
    connect(&messages_, &MessageLog::arrived, this, &MainWindow::showMessages);
    connect(&documentFiles_, &DocumentFiles::fileChanged, this, &MainWindow::updateTitle);
    onChange(document_, DocumentChange::Scene, this, &MainWindow::updateTitle);
    connect(&document_, &Document::modifiedChanged, this, &QWidget::setWindowModified);
    connect(files_, &FileActions::saved, &autosave_, &Autosave::discard);
    connect(files_, &FileActions::documentReplaced, &autosave_, &Autosave::giveUp);
    connect(files_, &FileActions::meshPlaced, this,
            [this] { views_->active().frameCurrentObject(); });
    connect(&switches_, &EffectSwitches::changed, this,
            [this] { status_->setSwitchedOff(static_cast<int>(switches_.off().size())); });
    connect(status_, &StatusLine::effectsWished, this, &MainWindow::showEffects);
    connect(views_, &CompareArea::filesDropped, files_, &FileActions::drop);
    connect(status_, &StatusLine::messagesWished, this, [this] {
        const bool inFront = !dock("messages")->visibleRegion().isEmpty();
        inFront ? dock("messages")->hide() : showMessages();
    });
    onChange(document_, DocumentChange::Current, this,
             [this] { status_->setViewport(&views_->active().viewport()); });
    status_->setViewport(&views_->first().viewport());
    const auto listen = [this](SideView* view) {
        const QString group = "view " + letterOf(view->side());
        connect(&view->viewport().frames(), &FrameLoop::messagesDrawn, this,
                [this, group](const Errors& errors) { messages_.setGroup(group, errors); });
    };
    listen(&views_->first());
    connect(views_, &CompareArea::viewAdded, this, listen);
    connect(&watcher_, &CatalogWatcher::changed, this,
            [this](const std::shared_ptr<const Catalog>& catalog) {
                document_.setCatalog(catalog);
                presets_.setCatalog(catalog);
                thumbnails_.setCatalog(catalog);
                messages_.setGroup("catalog", catalog->errors);
                trials_.run(catalog);
            });
    connect(&trials_, &UserBlockTrials::begun, this, [this](const QStringList& names) {
        status_->showMessage(tr("Checking %1 …").arg(names.join(", ")));
    });
    connect(&trials_, &UserBlockTrials::finished, this, [this](const Errors& mistakes) {
        messages_.setGroup("shaders", mistakes);
        status_->clearMessage();
        // A view may wait for a block that it could not draw with before.
        views_->first().viewport().frames().refresh();
        if (SideView* second = views_->second()) {
            second->viewport().frames().refresh();
        }
    });
}

/// The layout of a first start: the material's look on the left, its values on the right, the
/// picture large in the middle.
void MainWindow::arrangeDocks() {
    for (const auto& [place, dock] : firstDocks_) {
        dock->show();
        dock->raise();
    }
    hideBottom();
    if (messages_.count() > 0) { // of the files that were opened before the window came
        showMessages();
    }
    const bool narrow = width() < narrowWindow;
    const int left = narrow ? 212 : 276;
    const int right = narrow ? 384 : 440;
    resizeDocks({dock("models"), dock("parameters")}, {left, right}, Qt::Horizontal);
    resizeDocks({dock("models"), dock("presets")}, {10, 11}, Qt::Vertical);
    resizeDocks({dock("parameters"), dock("lights")}, {11, 10}, Qt::Vertical);
}

/// Messages and checks come when there is something to say.
void MainWindow::hideBottom() {
    dock("messages")->hide();
    dock("stability")->hide();
    dock("effects")->hide();
    dock("accuracy")->hide();
}

void MainWindow::restoreWindow() {
    const QSize available = screen()->availableSize();
    resize(preferredSize.boundedTo(available));
    const bool known = restoreGeometry(session_.windowGeometry());
    if (!known && available.width() < preferredSize.width()) {
        setWindowState(Qt::WindowMaximized);
    }
    hideBottom();
    arranged_ = restoreState(session_.windowLayout(), layoutVersion);
    const QStringList opened = session_.openedDocks();
    for (const auto& [name, dock] : docks_) {
        if (arranged_ && opened.contains(name)) {
            dock->keepHeight();
        }
    }
    theme_.setLook(session_.look());
}

bool MainWindow::event(QEvent* event) {
    const bool handled = QMainWindow::event(event);
    if (event->type() == QEvent::Show && !arranged_) {
        arranged_ = true;
        arrangeDocks();
    }
    return handled;
}

bool MainWindow::focusNextPrevChild(bool next) {
    return moveFocus(*this, next);
}

void MainWindow::updateTitle() {
    const DocumentFile& file = documentFiles_.file();
    const QString name =
        file.path.empty() ? tr("Untitled") : QString::fromStdString(file.path.filename().string());
    setWindowTitle(file.readOnly ? tr("%1[*] (read-only) – Patina").arg(name)
                                 : tr("%1[*] – Patina").arg(name));
    setWindowFilePath(QString::fromStdString(file.path.string()));
    setWindowModified(document_.isModified());
}

void MainWindow::exportPicture() {
    const QPointer viewport(&views_->active().viewport());
    const auto capture = [viewport](bool display, PictureCapture::Taken taken) {
        viewport ? viewport->capture().start(display, std::move(taken)) : taken({});
    };
    const auto cancel = [viewport] {
        if (viewport) {
            viewport->capture().cancel();
        }
    };
    const Material* material = document_.material(document_.activeSide());
    pictures_->ask(
        FileActions::asFileName(material ? QString::fromStdString(material->name) : QString()),
        {capture, cancel});
}

void MainWindow::checkStability() {
    QDockWidget* place = dock("stability");
    place->show();
    place->raise();
    if (auto* check = place->findChild<StabilityDock*>()) {
        check->start();
    }
}

void MainWindow::showEffects() {
    dock("effects")->show();
    dock("effects")->raise();
}

void MainWindow::showMessages() {
    dock("messages")->show();
    dock("messages")->raise(); // it may lie behind other tabs
}

void MainWindow::offerRecovery() {
    const std::vector<Recovery> found = Autosave::found(stateFolder() / "autosave");
    if (found.empty()) {
        return;
    }
    const Recovery& newest = found.front();
    auto* question =
        new QMessageBox(QMessageBox::Question, tr("Recover unsaved work"),
                        tr("Patina did not close properly. There is unsaved work from %1.")
                            .arg(QLocale().toString(newest.saved, QLocale::ShortFormat)),
                        QMessageBox::NoButton, this);
    question->setObjectName("recovery");
    question->setAttribute(Qt::WA_DeleteOnClose);
    const QString file = QString::fromStdString(newest.original.path.string());
    question->setInformativeText(file.isEmpty() ? tr("It was not saved to a file yet.")
                                                : tr("It belongs to %1, which stays as it is until "
                                                     "you save.")
                                                      .arg(file));
    QPushButton* take = question->addButton(tr("Recover"), QMessageBox::AcceptRole);
    QPushButton* drop = question->addButton(tr("Discard"), QMessageBox::DestructiveRole);
    question->addButton(tr("Ask again later"), QMessageBox::RejectRole);
    question->setDefaultButton(take);
    new KeyPause(*question);
    connect(take, &QPushButton::clicked, this, [this, newest] { recover(newest); });
    connect(drop, &QPushButton::clicked, this, [this, newest] {
        Autosave::remove(newest);
        offerRecovery();
    });
    question->open();
}

void MainWindow::recover(const Recovery& recovery) {
    if (!files_->mayLoseDocument()) {
        return;
    }
    autosave_.complete(recovery);
    if (documentFiles_.recover(recovery.scene, recovery.original)) {
        autosave_.giveUp();
        autosave_.adopt(recovery);
    }
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!files_->mayLoseDocument()) {
        event->ignore();
        return;
    }
    autosave_.giveUp();
    session_.setWindow(saveGeometry(), saveState(layoutVersion));
    QStringList opened = session_.openedDocks();
    for (const auto& [name, dock] : docks_) {
        if (dock->isBuilt() && !opened.contains(name)) {
            opened << name;
        }
    }
    session_.setOpenedDocks(opened);
    session_.sync();
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    QStringList dropped;
    for (const QUrl& url : event->mimeData()->urls()) {
        dropped << url.toLocalFile();
    }
    dropped.removeAll(QString());
    event->acceptProposedAction();
    files_->drop(dropped, document_.activeSide());
}

} // namespace patina
