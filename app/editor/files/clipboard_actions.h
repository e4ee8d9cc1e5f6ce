// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "document/document_files.h"
#include "document/json_clipboard.h"

namespace patina {

class MeshLibrary;

/// Copies materials, objects and lights as JSON, in the format of presets and scenes, and pastes
/// such text. Each paste is one undo step.
class ClipboardActions : public QObject {
    Q_OBJECT

  public:
    ClipboardActions(Document& document, DocumentFiles& files, MeshLibrary& meshes,
                     QObject* parent);

    void copyMaterial() const;
    /// Copies the objects that an edit would change.
    void copyObjects() const;
    void cutObjects();
    /// Copies the current light.
    void copyLight() const;
    void cutLight();
    void duplicateLight();

    /// Pastes a material onto the active side and the selected objects; adds objects beside those
    /// of the scene, and lights to its lights. Errors are told by the document.
    void paste();

  private:
    void pasteMaterial(const CopiedJson& copied);
    void pasteScene(const CopiedJson& copied);
    bool mayReadAll(const Material& material) const;
    bool mayReadAll(const std::vector<Object>& objects) const;
    std::vector<Object> editedObjects() const;
    const Light* currentLight() const;
    LocatedJson placed(const CopiedJson& copied) const;
    void report(Errors messages);

    Document& document_;
    DocumentFiles& files_;
    MeshLibrary& meshes_;
};

} // namespace patina
