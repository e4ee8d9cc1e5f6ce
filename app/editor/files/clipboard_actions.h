// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "document/document_files.h"
#include "document/json_clipboard.h"

namespace patina {

class MeshLibrary;

/// Copies materials, objects and lights as JSON, a preset's or a scene's, and pastes what such a
/// text holds. Each paste is one undo step.
class ClipboardActions : public QObject {
    Q_OBJECT

  public:
    ClipboardActions(Document& document, DocumentFiles& files, MeshLibrary& meshes,
                     QObject* parent);

    void copyMaterial() const;
    /// The objects that an edit changes.
    void copyObjects() const;
    void cutObjects();
    /// The current light.
    void copyLight() const;
    void cutLight();
    void duplicateLight();

    /// A material goes onto the active side and the selected objects; objects are added beside
    /// what is there, lights to the others.
    void paste();

  private:
    void pasteMaterial(const CopiedJson& copied);
    void pasteScene(const CopiedJson& copied);
    bool mayReadAll(const Material& material) const;
    bool mayReadAll(const std::vector<Object>& objects) const;
    std::vector<Object> editedObjects() const;
    const Light* currentLight() const;
    LocatedJson placed(const CopiedJson& copied) const;
    void tell(Errors messages);

    Document& document_;
    DocumentFiles& files_;
    MeshLibrary& meshes_;
};

} // namespace patina
