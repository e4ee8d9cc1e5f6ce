// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// Does what the File menu, a drop and the command line do with files: asks where to, asks before
/// unsaved work would be lost, remembers folders and recent files.
class FileActions : public QObject {
    Q_OBJECT

  public:
    /// Tells what a file is, by its name, and where that says no more than JSON, by its "format".
    enum class Kind { Preset, Scene, Panorama, Mesh, Sheet };

    FileActions(Document& document, DocumentFiles& files, MeshLibrary& meshes, Session& session,
                QWidget* window);

    void newDocument();
    /// True when the document was saved.
    bool save();
    bool saveAs();
    void askAndOpen();
    void exportPreset();
    void importMesh();

    /// Asks for the name, description, author, licence and tags of the current material.
    void editDetails();

    /// Opens what was named on the command line or in a menu: a scene or a preset becomes the
    /// document, a mesh an object in it: beside the others, or in place of a new document's.
    void open(const QStringList& files, Side side);

    /// Does what a drop asks for: a preset goes onto the side it was dropped on, undoably, and so
    /// does that of a sheet.
    void drop(const QStringList& files, Side side);

    /// Puts a preset on a side; asks about what it names outside its folder.
    void applyPreset(const QString& file, Side side);

    /// Asks about what the document names outside its folder and was not read.
    void allowOutside();

    /// Adds an object with a material like the current one's, in an empty scene like a new
    /// document's, and makes it current.
    void addObject(Object object);

    /// The same, beside what is there and in view, as one undo step. Its mesh must be there.
    void addBeside(const Object& object);

    /// Adds copies of the objects that an edit changes, beside all others, and selects them.
    void duplicateObjects();

    ClipboardActions& clipboard() const { return *clipboard_; }

    /// False when the user wants to go back. Saves when the user wants that.
    bool mayLoseDocument();

    void tell(const Error& message) { Q_EMIT files_.message(message); }

    static Kind kindOf(const QString& file);

    /// A name that any file system takes.
    static QString asFileName(const QString& name);

  Q_SIGNALS:
    /// The document is on disk, all of it.
    void saved();
    /// A preset was put on a side.
    void presetApplied(const QString& file);
    /// There is another document; what was not saved of the former one was given up on purpose.
    void documentReplaced();
    /// A mesh that was opened, imported or dropped is now the current object.
    void meshPlaced();
    /// A contact sheet's file was opened or dropped.
    void sheetWished(const QString& file);

  private:
    void openDocument(const QString& file);
    void forgetMeshes();
    bool askHowToImport(const QString& file);
    void load(const QString& mesh);
    void meshLoaded(const QString& mesh);
    bool showsOnlyTheStart() const;
    bool writePreset(const QString& file);
    void replaceObject(Object object);
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
    Session& session_;
    ClipboardActions* clipboard_;
    OutsideConsent consent_;
    QWidget* window_;
    std::optional<std::filesystem::file_time_type> written_; ///< the document's file, by us
    std::map<QString, Object> wanted_; ///< objects that wait for their mesh, by its file
};

} // namespace patina
