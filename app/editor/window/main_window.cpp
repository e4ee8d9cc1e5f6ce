// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/main_window.h"

#include <algorithm>

#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>

#include "document/scene_edits.h"
#include "gl/driver_cache.h"
#include "parameters/dropped_files.h"
#include "session/start_value_files.h"
#include "shading/effects/occlusion.h"
#include "sheets/sheets_dock.h"
#include "window/focus_order.h"
#include "window/lazy_dock.h"
#include "window/messages_opener.h"

namespace patina {
namespace {

constexpr int saidMs = 4000; ///< milliseconds; the status line says for so long what was done

} // namespace

MainWindow::MainWindow(const std::shared_ptr<const Catalog>& catalog, Theme& theme)
    : theme_(theme), document_(catalog), switches_(document_, effects_, tried_), watcher_(catalog),
      presets_(catalog, session_),
      thumbnails_(catalog, {cacheFolder() / "thumbnails", programFolder(), defaultSceneFile()}),
      programs_(programFolder()), viewContext_(programFolder()),
      autosave_(document_, documentFiles_, stateFolder() / "autosave"),
      files_(new FileActions(document_, documentFiles_, meshes_, textures_, session_, this)),
      material_(new MaterialActions(document_, *files_, tried_, this)),
      pictures_(new PictureExport(session_, this)), exporter_(new MaterialExporter(session_, this)),
      turntables_(new TurntableExport(document_, session_, this)),
      views_(new CompareArea({document_, meshes_, textures_, environments_, switches_, effects_,
                              programs_, viewContext_},
                             this)),
      status_(new StatusLine(document_, messages_, this)),
      recovery_(new RecoveryOffer(autosave_, documentFiles_, *files_, this)) {
    setAcceptDrops(true);
    setCentralWidget(views_);
    setStatusBar(status_);
    layout_ = std::make_unique<WindowLayout>(*this, dockContext());
    menus_ = new Menus({*this, *layout_, document_, documentFiles_, comparison_, *files_,
                        *pictures_, *exporter_, *turntables_, presets_, thumbnails_, *views_,
                        session_, messages_, theme_, *material_});
    connectParts();
    messages_.setGroup("catalog", catalog->errors);
    if (const auto& note = gl::driverCacheNote()) {
        messages_.add(*note);
    }
    StartValueReading start = readStartValues(startValueFolder());
    document_.setStartValues(std::move(start.values));
    messages_.setGroup("start values", start.errors);
    updateTitle();
    layout_->restore(session_);
    theme_.setLook(session_.look());
}

MainWindow::~MainWindow() {
    // The views and docks are deleted before the parts that they refer to.
    delete recovery_;
    delete menus_;
    layout_.reset();
    delete status_;
    delete views_;
    delete turntables_;
    delete exporter_;
    delete pictures_;
    delete material_;
    delete files_;
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
    return {document_,  comparison_, tried_,        documentFiles_, *files_,
            *material_, messages_,   session_,      presets_,       thumbnails_,
            meshes_,    textures_,   environments_, switches_,      *views_};
}

void MainWindow::connectParts() {
    connect(&documentFiles_, &DocumentFiles::message, &messages_, &MessageLog::add);
    connect(&document_, &Document::reported, &messages_, &MessageLog::add);
    connect(&meshes_, &MeshLibrary::remarked, &messages_, &MessageLog::addNote);
    onChange(document_, DocumentChange::Drawn, &meshes_, [this] {
        meshes_.wantOpenness(std::ranges::any_of(sides, [this](Side side) {
            return indexOf(side) < document_.shownSides() &&
                   needsOpenness(document_.scene(side), document_.catalog());
        }));
    });
    connect(&textures_, &TextureLibrary::failed, this,
            [this](const QString&, const Error& why) { messages_.add(why); });
    onChange(document_, DocumentChange::Scene, &textures_, &TextureLibrary::forgetFailures);
    connect(&environments_, &EnvironmentLibrary::failed, &messages_, &MessageLog::add);
    onChange(document_, DocumentChange::Scene, &environments_, &EnvironmentLibrary::forgetFailure);
    onChange(document_,
             DocumentChange::Value | DocumentChange::Block | DocumentChange::OwnView |
                 DocumentChange::Comparing | DocumentChange::Scene | DocumentChange::Catalog,
             &environments_, [this] { environments_.keep(environmentPictures(document_)); });
    connect(&documentFiles_.withheld(), &WithheldFiles::changed, this, [this] {
        const FileRights rights = documentFiles_.withheld().rights();
        meshes_.setRights(rights);
        textures_.forgetFailures(); // a pass may name an image that was withheld
        environments_.withhold(rights.withheld);
    });
    connect(pictures_, &PictureExport::failed, &messages_, &MessageLog::add);
    connect(pictures_, &PictureExport::saved, this, [this](const QString& file) {
        status_->showMessage(tr("%1 is written").arg(QFileInfo(file).fileName()), saidMs);
    });
    connect(turntables_, &TurntableExport::failed, &messages_, &MessageLog::add);
    connect(turntables_, &TurntableExport::saved, this, [this](const QString& first, int count) {
        status_->showMessage(tr("%n pictures are written from %1 on", nullptr, count)
                                 .arg(QFileInfo(first).fileName()),
                             saidMs);
    });
    connect(exporter_, &MaterialExporter::failed, &messages_, &MessageLog::add);
    connect(exporter_, &MaterialExporter::written, this,
            [this](const QString& file, const Errors& lost) {
                for (const Error& note : lost) {
                    messages_.addNote(note);
                }
                const QString name = QFileInfo(file).fileName();
                status_->showMessage(
                    lost.empty() ? tr("%1 is written").arg(name)
                                 : tr("%1 is written; Messages says what it lacks").arg(name),
                    saidMs);
            });
    connect(&autosave_, &Autosave::failed, &messages_, &MessageLog::add);
    connect(&presets_, &PresetLibrary::checked, this,
            [this](const Errors& mistakes) { messages_.setGroup("presets", mistakes); });
    new MessagesOpener(messages_, *layout_, this);
    connect(&documentFiles_, &DocumentFiles::fileChanged, this, &MainWindow::updateTitle);
    onChange(document_, DocumentChange::Scene, this, &MainWindow::updateTitle);
    connect(&document_, &Document::modifiedChanged, this, &QWidget::setWindowModified);
    connect(&files_->saving(), &SaveActions::saved, &autosave_, &Autosave::discard);
    connect(files_, &FileActions::documentReplaced, &autosave_, &Autosave::giveUp);
    connect(&files_->meshes(), &MeshActions::placed, this,
            [this] { views_->active().frameCurrentObject(); });
    connect(files_, &FileActions::readingAgain, &environments_, &EnvironmentLibrary::readAgain);
    connect(files_, &FileActions::readingAgain, &presets_, &PresetLibrary::scan);
    connect(files_, &FileActions::sheetWished, this, [this](const QString& file) {
        layout_->bringToFront("sheets");
        qobject_cast<LazyDock*>(dock("sheets"))->build();
        findChild<SheetsDock*>()->open(file);
    });
    connect(&switches_, &EffectSwitches::changed, this,
            [this] { status_->setSwitchedOff(static_cast<int>(switches_.off().size())); });
    connect(status_, &StatusLine::effectsWished, this,
            [this] { layout_->bringToFront("effects"); });
    connect(&views_->cameras(), &ViewCameras::said, this,
            [this](const QString& text) { status_->showMessage(text, saidMs); });
    connect(views_, &CompareArea::numbersShown, status_, &StatusLine::setComparison);
    connect(views_, &CompareArea::filesDropped, files_, &FileActions::drop);
    connect(status_, &StatusLine::messagesWished, this, [this] {
        const bool inFront = !dock("messages")->visibleRegion().isEmpty();
        inFront ? dock("messages")->hide() : layout_->bringToFront("messages");
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
    connect(&trials_, &UserBlockTrials::finished, this, [this](const Errors& mistakes) {
        messages_.setGroup("shaders", mistakes);
        // A view may wait for a block that it could not draw with before.
        for (SideView* view : views_->views()) {
            view->viewport().frames().refresh();
        }
    });
}

void MainWindow::tellSafeStart() {
    messages_.addNote({{},
                       0,
                       0,
                       "this is a safe start: named files, unsaved work and your own models and "
                       "other blocks are left out until the next start",
                       {}});
    status_->showMessage(tr("Safe start: your own models and files are left out"), saidMs);
}

bool MainWindow::event(QEvent* event) {
    const bool handled = QMainWindow::event(event);
    if (event->type() == QEvent::Show) {
        layout_->arrangeOnce();
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
    const bool isReadOnly = file.readOnly || isShippedPreset(file.path);
    setWindowTitle(isReadOnly ? tr("%1[*] (read-only) – Patina").arg(name)
                              : tr("%1[*] – Patina").arg(name));
    setWindowFilePath(QString::fromStdString(file.path.string()));
    setWindowModified(document_.isModified());
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!files_->saving().mayLoseDocument()) {
        event->ignore();
        return;
    }
    autosave_.giveUp();
    layout_->store(session_);
    session_.sync();
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    acceptFiles(*event);
}

void MainWindow::dropEvent(QDropEvent* event) {
    acceptCopy(*event);
    files_->drop(draggedFiles(*event->mimeData()), document_.selection().side());
}

} // namespace patina
