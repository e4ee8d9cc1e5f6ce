// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/catalog.h"
#include "catalog/settings.h"
#include "document/compared_picture.h"
#include "document/own_view.h"
#include "scene/scene.h"

namespace patina {

/// Holds the materials that are compared. A is the object's own, B the second one, C and D are
/// further ones.
enum class Side { A, B, C, D };

inline constexpr std::array sides{Side::A, Side::B, Side::C, Side::D};

constexpr std::size_t indexOf(Side side) {
    return static_cast<std::size_t>(side);
}

/// Holds what side A shows for as long as it is compared, and its own material, which was put
/// aside.
struct MaterialPreview {
    int object = 0;
    Material own;
    Material shown;

    friend bool operator==(const MaterialPreview&, const MaterialPreview&) = default;
};

/// Represents a look that was kept under a name.
struct Snapshot {
    std::string name;
    Material material;
    std::string png; ///< of a small picture of it, the bytes of the file

    friend bool operator==(const Snapshot&, const Snapshot&) = default;
};

/// Everything an edit can change.
struct DocumentState {
    Scene scene;
    std::optional<Material> second; ///< side B, shown on the current object; absent: no comparing
    std::optional<MaterialPreview> preview = std::nullopt; ///< absent: side A shows its own
    std::optional<ComparedPicture> picture = std::nullopt; ///< absent: both draw as the scene says
    /// Holds sides C and D, shown on the current object, too; they rest while nothing is compared.
    std::vector<Material> further{};
    std::array<OwnView, sides.size()> ownViews{}; ///< by side; they rest in the same way
    std::vector<Snapshot> snapshots{}; ///< in the order in which they were taken

    friend bool operator==(const DocumentState&, const DocumentState&) = default;
};

/// Names one set of parameter values in a document: what a form shows and a command changes.
struct BlockPath {
    BlockOwner owner = BlockOwner::Material;
    std::string kind{kinds::models}; ///< of the block, or one of `settings`
    int index = 0;                   ///< of the object or the light that owns it; 0 of the scene
    Side side = Side::A;             ///< of the material that owns it
    bool isOfView = false;           ///< of what the side's view has of its own of the scene

    bool isAt(std::string_view wanted) const { return kind == wanted; }

    friend bool operator==(const BlockPath&, const BlockPath&) = default;
};

/// Names one value of a document.
struct ParameterTarget {
    BlockPath path;
    std::string parameterId;

    friend bool operator==(const ParameterTarget&, const ParameterTarget&) = default;
};

/// Says which material of a document is meant.
struct MaterialPlace {
    int object = 0;
    Side side = Side::A;

    friend bool operator==(const MaterialPlace&, const MaterialPlace&) = default;
};

/// Returns the path of what is of a kind, or one of `settings`.
BlockPath pathOf(std::string_view kind, int index = 0, Side side = Side::A);

/// Returns the scene as one side shows it: all but A have a material of theirs on the current
/// object.
Scene shownScene(const DocumentState& state, int object, Side side);

/// The same without what is laid over it where ways to draw its picture are compared.
Scene ownScene(const DocumentState& state, int object, Side side);

/// Returns what a side's view has of its own; all is linked where nothing is compared.
const OwnView& ownView(const DocumentState& state, Side side);

/// Returns the path of the environment that a side's view shows: its own one or the scene's.
BlockPath environmentPath(const DocumentState& state, Side side);

/// Returns what is laid over a side's scene while its picture is compared; null: nothing.
const SidePicture* overlaidPicture(const DocumentState& state, Side side);

/// Tells whether side A shows another value than this one, which the scene has.
bool isOverlaid(const DocumentState& state, const BlockPath& path, std::string_view parameterId);

/// Tells whether side B has another material than what its object has.
bool hasSecondMaterial(const DocumentState& state);

/// Tells whether a side has a material that is not the object's.
bool hasOwnMaterial(const DocumentState& state, Side side);

/// Returns how many sides are shown: from 1, where nothing is compared.
std::size_t shownSides(const DocumentState& state);

/// Tells whether values at this path may have images.
bool takesTextures(const BlockPath& path);

/// Returns the key of a value's image in Material::textures.
std::string textureKey(const BlockPath& path, std::string_view parameterId);

/// Returns the material a path lies in; null when the object or the side is not there.
const Material* materialAt(const DocumentState& state, int object, Side side);
Material* materialAt(DocumentState& state, int object, Side side);

/// Returns the material that side A of an object has where it shows another one just to be looked
/// at, with what was edited of it since; nothing where it shows its own.
std::optional<Material> materialAside(const DocumentState& state, int object);

/// Returns the block values a path names; null for settings and for what is not there.
const BlockValues* blockValuesAt(const DocumentState& state, const BlockPath& path);
BlockValues* blockValuesAt(DocumentState& state, const BlockPath& path);

/// Returns the parts of the scene or of one of its lights that a path lies in; null where it is not
/// there.
BlockParts* scenePartsAt(DocumentState& state, const BlockPath& path);

/// Returns a value as it is stored; nothing when it is not stored (its default counts then).
std::optional<Value> storedValue(const DocumentState& state, const BlockPath& path,
                                 std::string_view parameterId);

/// Stores a value; nothing happens when the path is not there or the value has the wrong type.
void storeValue(DocumentState& state, const BlockPath& path, std::string_view parameterId,
                const Value& value);

/// Brings all values into the ranges of blocks that have changed.
void reconcile(DocumentState& state, const Catalog& before, const Catalog& after);

} // namespace patina
