// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>

#include <QObject>
#include <QStringList>

#include "document/document.h"
#include "files/clipboard_actions.h"
#include "files/outside_consent.h"
#include "resources/mesh_library.h"
#include "session/session.h"

class QWidget;

namespace patina {

class TextureLibrary;

/// Does what the File menu, drops and the command line do with files: asks for files, asks before
/// unsaved work would be lost, and remembers folders and recent files.
class FileActions : public QObject {
    Q_OBJECT

  public:
    /// Is what a file holds, told by its name or, for other JSON files, by its "format".
    enum class Kind { Preset, Scene, Panorama, Mesh, Sheet };

    FileActions(Document& document, DocumentFiles& files, MeshLibrary& meshes,
                TextureLibrary& textures, Session& session, QWidget* window);

    void newDocument();
    /// Returns whether the document was saved.
    bool save();
    bool saveAs();
    void askAndOpen();
    void exportPreset();
    void importMesh();

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

    /// Adds an object and makes it current. It gets the current material of side A, or in an
    /// empty scene that of a new document.
    void addObject(const Object& object);

    /// Adds an object beside the others as one undo step, and emits meshPlaced(). Its mesh must be
    /// loaded.
    void addBeside(const Object& object);

    /// Adds copies of the objects that an edit would change, beside all others, and selects them.
    void duplicateObjects();

    ClipboardActions& clipboard() const { return *clipboard_; }

    /// Asks about unsaved changes, and saves them if the user wants that. Returns false if the user
    /// cancels.
    bool mayLoseDocument();

    void report(const Error& message) { Q_EMIT files_.message(message); }

    static Kind kindOf(const QString& file);

    /// Returns a name that any file system accepts: lower case, without spaces and slashes.
    static QString asFileName(const QString& name);

  Q_SIGNALS:
    /// Is emitted when the whole document is on disk.
    void saved();
    /// Is emitted when a preset was applied to a side.
    void presetApplied(const QString& file);
    /// Is emitted when the document was replaced. Unsaved work of the former one was given up on
    /// purpose.
    void documentReplaced();
    /// Is emitted when a mesh that was opened, imported or dropped is the current object.
    void meshPlaced();
    /// Is emitted when the file of a contact sheet was opened or dropped.
    void sheetWished(const QString& file);

  private:
    void openDocument(const QString& file);
    void forgetMeshes();
    bool askHowToImport(const QString& file);
    void load(const QString& mesh);
    void meshLoaded(const QString& mesh);
    bool showsOnlyTheStart() const;
    bool writePreset(const QString& file);
    Object withCurrentMaterial(Object object) const;
    std::vector<Object> objectsOf(const Object& mesh) const;
    void place(const std::vector<Object>& objects, bool isInPlace);
    void replaceObject(const std::vector<Object>& objects);
    void whenRead(const QStringList& files, const std::function<void()>& next);
    void openRead(const QStringList& files, Side side);
    void dropRead(const QStringList& files, Side side);
    void applyRead(const QString& file, Side side);
    void meshFailed(const QString& mesh, const Error& why);
    void noteLinks(const QString& mesh, const std::vector<std::string>& places);
    void noteSaved(const QString& file);
    void tellOutside(const QString& file);
    bool mayReplace(const QString& asked, const QString& file);
    bool mayReplaceChanged(const std::filesystem::path& file);
    QString questionText() const;
    QString suggestedFile() const;
    QString suggestedName() const;
    QString nameOfCopy() const;

    Document& document_;
    DocumentFiles& files_;
    MeshLibrary& meshes_;
    TextureLibrary& textures_;
    Session& session_;
    ClipboardActions* clipboard_;
    OutsideConsent consent_;
    QWidget* window_;
    /// Is when the document's file was last read or written here.
    std::optional<std::filesystem::file_time_type> written_;
    /// Is an object that waits for its mesh.
    struct Wanted {
        Object object;
        bool joins = false; ///< says that it stays one, whatever the materials
    };
    std::map<QString, Wanted> wanted_; ///< holds these by the file of the mesh
};

} // namespace patina
