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

/// Names the materials that are compared: A is the object's own, B the second one, C and D are
/// further ones.
enum class Side { A, B, C, D };

inline constexpr std::array sides{Side::A, Side::B, Side::C, Side::D};

constexpr std::size_t indexOf(Side side) {
    return static_cast<std::size_t>(side);
}

/// Holds the material that side A shows only while it is compared, and its own one, which was put
/// aside.
struct MaterialPreview {
    int object = 0;
    Material own;
    Material shown;

    friend bool operator==(const MaterialPreview&, const MaterialPreview&) = default;
};

/// Holds a material that was kept under a name.
struct Snapshot {
    std::string name;
    Material material;
    std::string png; ///< holds the bytes of a PNG file, a small picture of it

    friend bool operator==(const Snapshot&, const Snapshot&) = default;
};

/// Holds everything that an edit can change.
struct DocumentState {
    Scene scene;
    /// Holds side B, shown on the current object; absent while nothing is compared.
    std::optional<Material> second;
    std::optional<MaterialPreview> preview = std::nullopt; ///< is absent where side A shows its own
    /// Holds the picture settings that are compared; absent where both sides draw as the scene
    /// says.
    std::optional<ComparedPicture> picture = std::nullopt;
    /// Holds sides C and D, also shown on the current object; they are unused while nothing is
    /// compared.
    std::vector<Material> further{};
    /// Holds what each side's view has of its own, by index of the side; unused while nothing is
    /// compared.
    std::array<OwnView, sides.size()> ownViews{};
    std::vector<Snapshot> snapshots{}; ///< are in the order in which they were taken

    friend bool operator==(const DocumentState&, const DocumentState&) = default;
};

/// Names one set of parameter values in a document: what a form shows and a command changes.
struct BlockPath {
    BlockOwner owner = BlockOwner::Material;
    std::string kind{kinds::models}; ///< is that of the block, or one of `settings`
    int index = 0;         ///< is that of the object or light that owns it, or that of a pass; 0
                           ///< for the scene
    Side side = Side::A;   ///< is that of the material that owns it
    bool isOfView = false; ///< says that it is in what the side's view has of its own

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

/// Returns the path of a kind of block, or of one of `settings`.
BlockPath pathOf(std::string_view kind, int index = 0, Side side = Side::A);

/// Returns the scene as one side shows it: sides other than A have their own material on this
/// object.
Scene shownScene(const DocumentState& state, int object, Side side);

/// Returns the same without the picture settings that overlay it while such settings are
/// compared.
Scene ownScene(const DocumentState& state, int object, Side side);

/// Returns what a side's view has of its own; all is linked where nothing is compared.
const OwnView& ownView(const DocumentState& state, Side side);

/// Returns the path of the environment that a side's view shows: its own one or the scene's.
BlockPath environmentPath(const DocumentState& state, Side side);

/// Returns what overlays a side's scene while its picture is compared; null where nothing is.
const SidePicture* overlaidPicture(const DocumentState& state, Side side);

/// Tells whether side A shows another value than the scene's at this path.
bool isOverlaid(const DocumentState& state, const BlockPath& path, std::string_view parameterId);

/// Tells whether side B has another material than what its object has.
bool hasSecondMaterial(const DocumentState& state);

/// Tells whether a side has a material that is not the object's.
bool hasOwnMaterial(const DocumentState& state, Side side);

/// Returns how many sides are shown, 1 .. 4; 1 while nothing is compared.
std::size_t shownSides(const DocumentState& state);

/// Tells whether values at this path may have images.
bool takesTextures(const BlockPath& path);

/// Returns the key of a value's image in Material::textures.
std::string textureKey(const BlockPath& path, std::string_view parameterId);

/// Returns the material of a side, for A that of this object; null when the object or side is not
/// there.
const Material* materialAt(const DocumentState& state, int object, Side side);
Material* materialAt(DocumentState& state, int object, Side side);

/// Returns the own material of an object whose side A previews another one, with what was edited of
/// it since; nothing where side A shows its own.
std::optional<Material> materialAside(const DocumentState& state, int object);

/// Returns the block values at a path; null for settings and for what is not there.
const BlockValues* blockValuesAt(const DocumentState& state, const BlockPath& path);
BlockValues* blockValuesAt(DocumentState& state, const BlockPath& path);

/// Returns the parts of the scene, or of the light, that a path lies in; null where it is not
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
