// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QMainWindow>

#include "docks/material_actions.h"
#include "document/comparison.h"
#include "document/document_files.h"
#include "document/program_effects.h"
#include "document/tried_material.h"
#include "files/autosave.h"
#include "files/catalog_watcher.h"
#include "files/file_actions.h"
#include "files/material_exporter.h"
#include "files/picture_export.h"
#include "files/recovery_offer.h"
#include "files/turntable_export.h"
#include "library/preset_library.h"
#include "library/thumbnail_maker.h"
#include "library/user_block_trials.h"
#include "resources/texture_library.h"
#include "session/message_log.h"
#include "session/session.h"
#include "viewport/compare_area.h"
#include "viewport/effect_switches.h"
#include "viewport/program_worker.h"
#include "viewport/view_context.h"
#include "window/menus.h"
#include "window/status_line.h"
#include "window/theme.h"
#include "window/window_layout.h"

namespace patina {

/// Shows the editor's window. It owns the parts of the editor and connects them; what they do is
/// left to them.
class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    MainWindow(const std::shared_ptr<const Catalog>& catalog, Theme& theme);
    ~MainWindow() override;

    Document& document() { return document_; }
    DocumentFiles& documentFiles() { return documentFiles_; }
    Comparison& comparison() { return comparison_; }
    ProgramEffects& effects() { return effects_; }
    FileActions& files() { return *files_; }
    PictureExport& pictures() { return *pictures_; }
    MaterialExporter& exporter() { return *exporter_; }
    TurntableExport& turntables() { return *turntables_; }
    CompareArea& views() { return *views_; }
    MessageLog& messages() { return messages_; }
    MeshLibrary& meshes() { return meshes_; }
    Autosave& autosave() { return autosave_; }
    QDockWidget* dock(const QString& name) const { return layout_->dock(name); }
    DockContext dockContext();

    /// Starts what can wait for the first frame, if that is not long: presets, thumbnails, the
    /// watching of folders, the desktop's look.
    void startRest();

    /// Asks about work that an earlier program could not save, the newest first.
    void offerRecovery() { recovery_->ask(); }

    /// Says that the program began without files and without the user's blocks.
    void tellSafeStart();

  protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    bool event(QEvent* event) override;
    bool focusNextPrevChild(bool next) override;

  private:
    void connectParts();
    void updateTitle();

    Theme& theme_;
    Session session_;
    MessageLog messages_;
    Document document_;
    DocumentFiles documentFiles_{document_};
    Comparison comparison_{document_};
    ProgramEffects effects_{document_};
    TriedMaterial tried_{document_};
    MeshLibrary meshes_;
    TextureLibrary textures_{[this]() -> AssetClient& { return meshes_.client(); }};
    EnvironmentLibrary environments_;
    EffectSwitches switches_;
    CatalogWatcher watcher_;
    PresetLibrary presets_;
    ThumbnailMaker thumbnails_;
    ProgramWorker programs_;
    ViewContext viewContext_;
    UserBlockTrials trials_;
    Autosave autosave_;
    FileActions* files_;
    MaterialActions* material_;
    PictureExport* pictures_;
    MaterialExporter* exporter_;
    TurntableExport* turntables_;
    CompareArea* views_;
    StatusLine* status_;
    std::unique_ptr<WindowLayout> layout_;
    Menus* menus_ = nullptr;
    RecoveryOffer* recovery_;
};

} // namespace patina
