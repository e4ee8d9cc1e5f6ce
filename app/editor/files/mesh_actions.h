// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include <QObject>

#include "document/document_files.h"

class QWidget;

namespace patina {

class MeshLibrary;
class Session;

/// Makes objects of the document from meshes, each with a material: one, or one for each material
/// of the mesh, beside the others or in place of the one in a new document.
class MeshActions : public QObject {
    Q_OBJECT

  public:
    /// All outlive it; dialogs belong to the window.
    MeshActions(Document& document, DocumentFiles& files, MeshLibrary& meshes, Session& session,
                QWidget* window);

    /// Asks for files and, unless Shift is held, how to import them.
    void askAndImport();

    /// Adds the objects of a mesh once it is loaded, with the choices of the last import. A mesh
    /// that cannot be read changes nothing.
    void load(const QString& mesh);

    /// Adds an object and makes it current. It gets the current material of side A, or in an
    /// empty scene that of a new document.
    void addObject(const Object& object);

    /// Adds an object beside the others as one undo step, and emits placed(). Its mesh must be
    /// loaded.
    void addBeside(const Object& object);

    /// Adds copies of the objects that an edit would change, beside all others, and selects them.
    void duplicateObjects();

    /// Forgets the meshes that are being loaded, since they belong to a former document.
    void forget();

  Q_SIGNALS:
    /// Is emitted when a mesh that was opened, imported or dropped is the current object.
    void placed();

  private:
    bool askHowToImport(const QString& file);
    void meshLoaded(const QString& mesh);
    void meshFailed(const QString& mesh, const Error& why);
    bool showsOnlyTheStart() const;
    Object withCurrentMaterial(Object object) const;
    std::vector<Object> objectsOf(const Object& mesh) const;
    void place(const std::vector<Object>& objects, bool isInPlace);
    void replaceObject(const std::vector<Object>& objects);

    Document& document_;
    DocumentFiles& files_;
    MeshLibrary& meshes_;
    Session& session_;
    QWidget* window_;
    /// Is an object that waits for its mesh.
    struct Wanted {
        Object object;
        bool joins = false; ///< says that it stays one, whatever the materials
    };
    std::map<QString, Wanted> wanted_; ///< holds these by the file of the mesh
};

} // namespace patina
