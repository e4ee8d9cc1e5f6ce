// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <QObject>
#include <QUndoStack>

#include "catalog/catalog.h"
#include "document/described_blocks.h"
#include "document/document_change.h"
#include "document/document_state.h"
#include "document/interaction.h"
#include "document/selection.h"
#include "document/shown_scenes.h"

namespace patina {

class DocumentCommand;

/// Says whether a whole material that replaces another one is an edit of that, or is put in its
/// place, as a preset is.
enum class MaterialEdit { Changed, Applied };

/// Says what users want values to be where a model is chosen anew: model's id -> "parameters" as in
/// a preset.
using StartValues = std::map<std::string, nlohmann::json, std::less<>>;

/// Represents images by the ids of the values that they are laid on; nothing: one is taken away.
using TextureEdits = std::map<std::string, std::optional<TextureUse>, std::less<>>;

/// Holds the truth of an editing session as values. Widgets show it and ask it to change; every
/// change is a command on the undo stack. Where the camera stands is view state, as the selection
/// is: it is saved, but neither undone nor asked about.
class Document : public QObject {
    Q_OBJECT

  public:
    explicit Document(std::shared_ptr<const Catalog> catalog, QObject* parent = nullptr);
    ~Document() override;

    // What there is.
    const DocumentState& state() const { return state_; }
    const Scene& scene() const { return state_.scene; }
    /// Returns the scene as one side shows it: all but A have a material of theirs on the current
    /// object.
    const Scene& scene(Side side) const;
    /// Returns the same without what overlays it while ways to draw the picture are compared.
    Scene ownScene(Side side) const;
    /// Returns the current object's material of that side; null when there is none.
    const Material* material(Side side) const;
    bool isComparing() const { return state_.second.has_value(); }
    std::size_t shownSides() const { return patina::shownSides(state_); } ///< 1: none is compared
    /// Starts anew with this state: there is nothing to undo, and this object is the current one.
    void startFrom(DocumentState state, int object = 0);

    // Blocks: values are kept by id and brought into new ranges where blocks change.
    const Catalog& catalog() const { return *catalog_; }
    std::shared_ptr<const Catalog> sharedCatalog() const { return catalog_; }
    void setCatalog(std::shared_ptr<const Catalog> catalog);

    /// Returns values that a chosen model has where nothing carries over.
    const StartValues& startValues() const { return startValues_; }
    void setStartValues(StartValues values) { startValues_ = std::move(values); }

    const Selection& selection() const { return selection_; }
    Selection& selection() { return selection_; }
    const Interaction& interaction() const { return interaction_; }
    Interaction& interaction() { return interaction_; }

    // Parameter values, whatever they belong to.
    /// Describes the values at a path; null when nothing is there or its block is not known.
    const Block* block(const BlockPath& path) const;
    /// Describes one value in the same way.
    const Parameter* parameter(const ParameterTarget& target) const;
    /// Returns the value a parameter has, conformed to its descriptor; the default where none is
    /// stored.
    Value value(const BlockPath& path, const Parameter& parameter) const;
    /// Makes an edit, but where the camera is: its moves have an undo of their own.
    void setValue(const BlockPath& path, std::string_view parameterId, const Value& value);

    /// Sets several values of one block, and images on them, as one step.
    void setValues(const BlockPath& path, const Values& values, const QString& label,
                   const TextureEdits& textures = {});

    // Images on values of a material.
    /// Returns the image of a value; null where there is none.
    const TextureUse* texture(const BlockPath& path, std::string_view parameterId) const;
    /// Lays an image on a value, changes it, or takes it away (nullopt).
    void setTexture(const BlockPath& path, std::string_view parameterId,
                    const std::optional<TextureUse>& use);

    // Blocks and materials. Edits of the scene's lists are in scene_edits.h, those of what is
    // compared in compare_edits.h.
    /// Sets another block of the path's kind; values with the same id carry over. Empty: none,
    /// where the kind is a part.
    void setBlock(const BlockPath& path, std::string_view blockId);
    void setModel(Side side, std::string_view modelId);
    void replaceMaterial(Side side, const Material& material, const QString& label,
                         MaterialEdit edit = MaterialEdit::Changed);
    /// Applies a material to every object that is edited.
    void replaceMaterials(Side side, const Material& material, const QString& label);

    // What is no edit.
    void setCamera(const Camera& camera);
    /// The scene is called as the file that it was saved to.
    void nameScene(const std::string& name);

    // Undo.
    QUndoStack& undoStack() { return undoStack_; }
    bool isModified() const { return !undoStack_.isClean(); }
    /// Returns the material of a place as it was opened or applied, before what was edited of it
    /// since; null where there is none.
    const Material* originalMaterial(MaterialPlace place) const;
    /// Edits in one undo step, which also takes the camera back where they moved it.
    void editAsOneStep(const QString& label, const std::function<void()>& edits);
    /// Says what changed, which whoever changed the state calls once it is changed.
    void announce(const DocumentChange& change);

  Q_SIGNALS:
    /// See onChange().
    void changed(const patina::DocumentChange& change);
    void modifiedChanged(bool modified);
    /// Something is to be told the user.
    void reported(const patina::Error& message);
    /// The user named this file, which then may be read.
    void fileNamed(const std::filesystem::path& file);
    /// The artist is about to change this value.
    void valueApproached(const patina::ParameterTarget& target);
    /// The artist may be about to choose this model.
    void modelApproached(patina::Side side, std::string_view modelId);

  private:
    friend class DocumentCommand;

    bool addValueEdits(std::vector<std::unique_ptr<DocumentCommand>>& edits, const BlockPath& path,
                       const Values& values, const QString& label);
    bool addTextureEdits(std::vector<std::unique_ptr<DocumentCommand>>& edits,
                         const BlockPath& path, const TextureEdits& textures, const QString& label);
    void setBlocksOfMaterials(const BlockPath& path, const Block* wanted);
    void setKindOfLight(const BlockPath& path, const Block& wanted);
    void setScenePart(const BlockPath& path, const Block* wanted);
    void setOwnEnvironment(const BlockPath& path, const Block* wanted);

    std::shared_ptr<const Catalog> catalog_;
    mutable DescribedBlocks blocks_;
    DocumentState state_;
    DocumentState opened_; ///< what it started from
    StartValues startValues_;
    mutable ShownScenes shownScenes_;
    Selection selection_;
    Interaction interaction_;
    BlockParts lastParts_; ///< of the scene: they come back when the kind is turned on again
    QUndoStack undoStack_;
};

/// Calls a function, which may be one of the listener's and may take the change, whenever any of
/// these aspects of a document has changed.
template <class Listener, class Function>
void onChange(const Document& document, DocumentChange::Aspects aspects, Listener* listener,
              Function function) {
    const auto heard = [&] {
        if constexpr (std::is_member_function_pointer_v<Function>) {
            return std::bind_front(function, listener);
        } else {
            return function;
        }
    }();
    const auto call = [aspects, heard](const DocumentChange& change) {
        if (!change.has(aspects)) {
            return;
        }
        if constexpr (std::is_invocable_v<decltype(heard), const DocumentChange&>) {
            heard(change);
        } else {
            heard();
        }
    };
    QObject::connect(&document, &Document::changed, listener, call);
}

} // namespace patina
