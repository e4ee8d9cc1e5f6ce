// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>

#include <QObject>
#include <QUndoStack>

#include "catalog/catalog.h"
#include "document/document_change.h"
#include "document/document_state.h"
#include "document/frozen_effects.h"
#include "material/reading_rights.h"

namespace patina {

class TextureLibrary;
struct MaterialPlace;

/// What the document was opened from or saved to last.
struct DocumentFile {
    enum class Kind { None, Preset, Scene };
    Kind kind = Kind::None;
    std::filesystem::path path;
    bool readOnly = false; ///< written by a newer version: never saved over

    friend bool operator==(const DocumentFile&, const DocumentFile&) = default;
};

/// Holds the truth of an editing session as values. Widgets show it and ask it to change; every
/// change is a command on the undo stack. Which object, light and side are current, and where the
/// camera stands, is view state: it is kept here and saved, but neither undone nor asked about.
class Document : public QObject {
    Q_OBJECT

  public:
    explicit Document(std::shared_ptr<const Catalog> catalog, QObject* parent = nullptr);
    ~Document() override;

    // What there is.
    const DocumentState& state() const { return state_; }
    const Scene& scene() const { return state_.scene; }
    /// The scene as one side shows it: B has the second material on the current object.
    const Scene& scene(Side side) const;
    /// The same without what is laid over it while ways to draw the picture are compared.
    Scene ownScene(Side side) const;
    /// The current object's material of that side; null when there is none.
    const Material* material(Side side) const;
    /// What a scene file of this document holds: the scene, in its extras side B and its object.
    Scene sceneToSave() const;
    /// The same for a copy that is not its file: it says too what is not to be read.
    Scene sceneToRecover() const;
    /// The file of the environment's picture; empty where it needs none.
    std::string_view environmentPicture() const;
    bool isComparing() const { return state_.second.has_value(); }
    const Catalog& catalog() const { return *catalog_; }
    std::shared_ptr<const Catalog> sharedCatalog() const { return catalog_; }

    // What is current (-1: nothing).
    int currentObject() const { return currentObject_; }
    int currentLight() const { return currentLight_; }
    Side activeSide() const { return activeSide_; }
    void setCurrentObject(int index);
    void setCurrentLight(int index);
    void setActiveSide(Side side);
    /// The path of a kind of block, or of settings, in what is current: the active material, the
    /// current light or object.
    BlockPath currentPath(std::string_view kind) const;

    // Parameter values, whatever they belong to.
    /// Describes the values at a path; null when nothing is there or its block is not known.
    const Block* block(const BlockPath& path) const;
    /// The value a parameter has, conformed to its descriptor; the default where none is stored.
    Value value(const BlockPath& path, const Parameter& parameter) const;
    void setValue(const BlockPath& path, std::string_view parameterId, const Value& value);

    // Images on values of a material.
    /// The image of a value; null where there is none.
    const TextureUse* texture(const BlockPath& path, std::string_view parameterId) const;
    /// Lays an image on a value, changes it, or takes it away (nullopt).
    void setTexture(const BlockPath& path, std::string_view parameterId,
                    const std::optional<TextureUse>& use);
    /// Where images come from, for whoever shows them; null where nothing reads any.
    TextureLibrary* textureLibrary() const { return textureLibrary_; }
    void setTextureLibrary(TextureLibrary* library);

    // One interaction (a drag, a held key) is one undo step: every edit between begin and end
    // merges, and one that ends where it began leaves no step. A new one ends the one before; a
    // token makes a late end harmless (0 ends whichever is going on).
    int beginInteraction();
    void endInteraction(int token = 0);
    /// One that drags this value, which may pass what is left out of the programs: see effects().
    int beginInteraction(const BlockPath& path, std::string_view parameterId);
    /// The artist is about to change this value: what the views need for it is made ready.
    void prewarm(const BlockPath& path, std::string_view parameterId);
    /// The artist may be about to choose this model.
    void prewarmModel(Side side, std::string_view modelId);
    /// The scene whose effects a side's programs have while a value is dragged; null: its own.
    const Scene* effects(Side side) const { return frozenEffects_.scene(side); }
    bool isInteracting() const { return interaction_ != 0; }

    // Blocks and materials.
    /// Another block of the path's kind; values with the same id carry over. Empty: none, where the
    /// kind is a part.
    void setBlock(const BlockPath& path, std::string_view blockId);
    void setModel(Side side, std::string_view modelId);
    void replaceMaterial(Side side, const Material& material, const QString& label);
    /// Starts comparing with a material, changes it, or stops (nullopt).
    void setSecondMaterial(std::optional<Material> material);
    /// Starts comparing with what was last on side B of this object, at first with a copy of side
    /// A; or stops.
    void setComparing(bool on);
    /// Compares two materials as one step. Side A shows the first one until comparing ends, keeps
    /// its own meanwhile, also in files, and then has it again.
    void look(const Material& first, const Material& second, const QString& label);
    /// Compares two ways to draw the scene's picture, which is otherwise the active side's, as one
    /// step, until comparing ends: the scene keeps its own.
    void lookAtPictures(const Scene& first, const Scene& second, const QString& label);
    /// Side A draws the picture as its scene says, where another way was shown there.
    void showOwnPicture();
    /// Chooses levels for good, also where side A shows others just to be looked at.
    void setLevels(Side side, const AccuracyLevels& levels, const QString& label);
    void swapSides();

    // Lights, objects, the environment's picture.
    void addLight(std::string_view blockId);
    void setLight(int index, const Light& light);
    void removeLight(int index);
    /// Lights the scene with a picture: of the environment if it shows one, else of the first kind
    /// that does.
    void setEnvironmentPicture(const std::filesystem::path& file);
    void addObject(const Object& object);
    void setObject(int index, const Object& object);
    void removeObject(int index);

    void setCamera(const Camera& camera);
    /// Edits in one undo step, which also takes the camera back where they moved it.
    void editAsOneStep(const QString& label, const std::function<void()>& edits);

    /// Says what changed, which whoever changed the state calls once it is changed.
    void announce(const DocumentChange& change);

    // Undo.
    QUndoStack& undoStack() { return undoStack_; }
    bool isModified() const { return !undoStack_.isClean(); }
    /// The file is a preset, and more than the material it holds was changed.
    bool outgrewPreset() const;
    /// What is shown was recovered and not saved since.
    bool isRecovered() const { return isRecovered_; }

    /// Blocks changed: values are kept by id and brought into their new ranges.
    void setCatalog(std::shared_ptr<const Catalog> catalog);

    // Files. What goes wrong, and what the reader has to tell, comes through message().
    const DocumentFile& file() const { return file_; }
    /// A new, untitled document that starts as this scene.
    void startFrom(const Scene& scene);
    bool openScene(const std::filesystem::path& path, const ReadingRights& rights = {});
    /// Opens a scene as a new, untitled document (the default scene).
    bool openTemplate(const std::filesystem::path& path);
    /// Opens a copy of unsaved work, as the document of the file it came from: it is modified, and
    /// nothing undoes that.
    bool recover(const std::filesystem::path& copy, const DocumentFile& origin);
    /// Opens a preset as the document: the material of side A of the current object.
    bool openPreset(const std::filesystem::path& path, const ReadingRights& rights = {});
    /// Puts a preset on a side, as one undoable edit.
    bool applyPreset(const std::filesystem::path& path, Side side,
                     const ReadingRights& rights = {});
    /// What a scene or preset file names outside its folder and would not read with these rights.
    static OutsideFiles outsideOf(const std::filesystem::path& path, DocumentFile::Kind kind,
                                  const Catalog& catalog, const ReadingRights& rights);
    /// What the document names and does not read, since nobody agreed to it.
    OutsideFiles outside() const;
    /// The meshes and the picture among them.
    std::set<std::string, std::less<>> withheld() const;
    /// Reads them all from now on; images and presets as one undoable step.
    void allowOutside();
    /// The user named this file himself.
    void allow(const std::filesystem::path& file);
    bool saveScene(const std::filesystem::path& path);
    bool savePreset(const std::filesystem::path& path, Side side);
    /// Saves under a name: the preset that is the document is then called so itself.
    bool savePreset(const std::filesystem::path& path, Side side, const std::string& name);
    /// Saves to file(), by its kind; false when there is none or it is read-only.
    bool save();

  Q_SIGNALS:
    /// See onChange().
    void changed(const patina::DocumentChange& change);
    /// The views need other programs for the same picture: a drag has begun or ended.
    void effectsChanged();
    /// An image that was asked for is there, or will not come.
    void imagesArrived();
    /// The views may need the programs of this state soon.
    void effectsPrewarmed(const patina::DocumentState& state);
    void fileChanged();
    /// Other files are withheld, or fewer.
    void withheldChanged();
    void modifiedChanged(bool modified);
    void message(const patina::Error& message);

  private:
    friend class DocumentCommand;

    void setLightBlock(const BlockPath& path, const Block* wanted);
    void setSceneBlock(const BlockPath& path, const Block* wanted);
    void endComparing();
    void putBack();
    void setLookedAt(std::optional<LookedAt> lookedAt);
    bool isLaidOver(const BlockPath& path, std::string_view parameterId) const;
    void setPicture(std::optional<ComparedPicture> picture);
    void endFrozenEffects();
    void forgetShownScenes() const { shownScenes_ = {}; }
    void updateShownScene(Side side, const BlockPath& path, const std::string& id);
    void keepCurrentInside();
    std::optional<Errors> takeScene(const std::filesystem::path& path,
                                    const ReadingRights& rights);
    void setOutside(OutsideFiles outside);
    void allowIn(const MaterialPlace& place, const ReadingRights& rights);
    void replaceState(DocumentState state, DocumentFile file, int object = 0);
    bool savePreset(const std::filesystem::path& path, const BlockPath& of, Material saved);
    void tell(const Errors& messages);
    bool isOwnFile(const std::filesystem::path& path) const;
    bool mayOverwrite(const std::filesystem::path& path);
    void setFile(DocumentFile file);
    void markPresetSaved(Side side);

    std::shared_ptr<const Catalog> catalog_;
    TextureLibrary* textureLibrary_ = nullptr;
    DocumentState state_;
    /// By side, where it is not the scene itself; made on demand.
    mutable std::array<std::optional<Scene>, 2> shownScenes_;
    int currentObject_ = -1;
    int currentLight_ = -1;
    Side activeSide_ = Side::A;
    int interaction_ = 0;
    int lastInteraction_ = 0;
    FrozenEffects frozenEffects_;
    DocumentFile file_;
    OutsideFiles outside_; ///< what is not read, beside images, which know it themselves
    int presetObject_ = -1; ///< whose material is in file_, when that is a preset
    bool isRecovered_ = false;
    DocumentState savedState_; ///< as opened or saved, to know what saving a preset leaves out
    BlockParts lastParts_;     ///< of the scene: they come back when the kind is turned on again
    std::optional<Material> lastSecond_;
    int lastSecondObject_ = -1; ///< what `lastSecond_` was compared on
    std::map<std::string, Block, std::less<>> settings_;
    mutable std::map<std::vector<const Block*>, Block> accuracyBlocks_; ///< by the blocks in use
    QUndoStack undoStack_;
};

/// Calls a function, which may be one of the listener's and may take the change, whenever any of
/// these aspects of a document has changed.
template <class Listener, class Function>
void onChange(const Document& document, DocumentChange::Aspects aspects, Listener* listener,
              Function function) {
    const auto call = [aspects, listener, function](const DocumentChange& change) {
        if (!change.has(aspects)) {
            return;
        }
        if constexpr (std::is_member_function_pointer_v<Function>) {
            std::invoke(function, *listener);
        } else if constexpr (std::is_invocable_v<Function, const DocumentChange&>) {
            function(change);
        } else {
            function();
        }
    };
    QObject::connect(&document, &Document::changed, listener, call);
}

} // namespace patina
