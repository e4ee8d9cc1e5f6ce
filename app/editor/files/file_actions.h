// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QObject>
#include <QStringList>

#include "document/document.h"
#include "files/clipboard_actions.h"
#include "files/mesh_actions.h"
#include "files/outside_consent.h"
#include "files/save_actions.h"
#include "resources/mesh_library.h"
#include "session/session.h"

class QWidget;

namespace patina {

class TextureLibrary;

/// Opens what menus, drops and the command line name, each kind of file in its way, and asks before
/// a file reads others outside its folder. Saving, meshes and the clipboard have classes of their
/// own behind it.
class FileActions : public QObject {
    Q_OBJECT

  public:
    /// Is what a file holds, told by its name or, for other JSON files, by its "format".
    enum class Kind { Preset, Scene, Panorama, Mesh, Sheet };

    FileActions(Document& document, DocumentFiles& files, MeshLibrary& meshes,
                TextureLibrary& textures, Session& session, QWidget* window);

    SaveActions& saving() { return saving_; }
    MeshActions& meshes() { return meshActions_; }
    ClipboardActions& clipboard() const { return *clipboard_; }

    void newDocument();
    void askAndOpen();

    /// Asks for the name, description, author, licence and tags of the current material.
    void editDetails();

    /// Opens files from the command line or a menu. A scene or preset becomes the document, a
    /// second preset goes onto the other side, and a mesh becomes an object, or one for
    /// each of its materials: beside the others, or in place of the one in a new document.
    void open(const QStringList& files, Side side);

    /// Opens dropped files. A preset goes onto `side`, undoably, and a sheet is made of that side.
    void drop(const QStringList& files, Side side);

    /// Applies a preset to a side; asks about files that it names outside its folder.
    void applyPreset(const QString& file, Side side);

    /// Asks about the files outside its folder that the document names and that were not read.
    void allowOutside();

    void report(const Error& message) { Q_EMIT files_.message(message); }

    static Kind kindOf(const QString& file);

    /// Reads images, meshes and environments again, which another program may have written.
    void readAgain();

  Q_SIGNALS:
    /// Is emitted when a preset was applied to a side.
    void presetApplied(const QString& file);
    /// Is emitted when the document was replaced. Unsaved work of the former one was given up on
    /// purpose.
    void documentReplaced();
    /// Is emitted when the file of a contact sheet was opened or dropped.
    void sheetWished(const QString& file);
    /// Is emitted when all that files hold is to be read again, for those who read others.
    void readingAgain();

  private:
    void openDocument(const QString& file);
    void whenRead(const QStringList& files, const std::function<void()>& next);
    void openRead(const QStringList& files, Side side);
    void dropRead(const QStringList& files, Side side);
    void applyRead(const QString& file, Side side);
    void noteLinks(const QString& mesh, const std::vector<std::string>& places);
    void tellOutside(const QString& file);

    Document& document_;
    DocumentFiles& files_;
    MeshLibrary& meshes_;
    TextureLibrary& textures_;
    Session& session_;
    OutsideConsent consent_;
    SaveActions saving_;
    MeshActions meshActions_;
    ClipboardActions* clipboard_;
    QWidget* window_;
};

} // namespace patina
