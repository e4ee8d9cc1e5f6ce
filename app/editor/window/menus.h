// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QObject>

#include "docks/library_steps.h"

class QAction;
class QKeySequence;
class QMainWindow;
class QMenu;

namespace patina {

class CommandKeys;
class CompareArea;
class Comparison;
class Document;
class DocumentFiles;
class FileActions;
class MaterialActions;
class MaterialExporter;
class MessageLog;
class PictureExport;
class PresetLibrary;
class Session;
class Theme;
class ThumbnailMaker;
class TurntableExport;
class ViewsCapture;
class WindowLayout;

/// Makes the menus and the tool bar of the window: each action with its name, its key and what it
/// calls.
class Menus : public QObject {
    Q_OBJECT

  public:
    /// Holds what the actions call. Everything in it outlives the menus.
    struct Parts {
        QMainWindow& window;
        WindowLayout& layout;
        Document& document;
        DocumentFiles& documentFiles;
        Comparison& comparison;
        FileActions& files;
        PictureExport& pictures;
        MaterialExporter& exporter;
        TurntableExport& turntables;
        const PresetLibrary& presets;
        ThumbnailMaker& thumbnails;
        CompareArea& views;
        Session& session;
        MessageLog& messages;
        Theme& theme;
        MaterialActions& material;
    };

    explicit Menus(const Parts& parts);

  private:
    void makeFileMenu();
    void makeEditMenu();
    void makeObjectMenu();
    void makeGizmos(QMenu* menu);
    void makeLightMenu();
    void makeViewMenu();
    void makeCompareMenu(QMenu* menu);
    void makeCameraMoves(QMenu* menu);
    void makeTurntable(QMenu* menu);
    void makeLibrarySteps(QMenu* menu);
    void makePanelMenu(QMenu* menu);
    void makeLookMenu(QMenu* menu);
    void makeHelpMenu();
    void makeToolBar();
    void fillRecentFiles();
    void exportPicture();
    void exportTurntable();
    void takeSnapshot();
    void checkStability();
    QAction* add(QMenu* menu, const QString& text, const QKeySequence& key,
                 std::function<void()> what);

    QAction* addForViews(QMenu* menu, const QString& text, const QKeySequence& key,
                         std::function<void()> what);

    Parts parts_;
    CommandKeys* keys_ = nullptr;
    LibrarySteps steps_;
    ViewsCapture* capture_; ///< takes pictures of the views
    QMenu* recent_ = nullptr;
    QMenu* lighting_ = nullptr;
    QMenu* modes_ = nullptr;
    QAction* compare_ = nullptr;
    QAction* link_ = nullptr;
    QAction* realign_ = nullptr;
    QAction* swap_ = nullptr;
    QAction* difference_ = nullptr;
};

} // namespace patina
