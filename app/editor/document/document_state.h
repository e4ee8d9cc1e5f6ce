// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "document/compared_picture.h"
#include "scene/scene.h"

namespace patina {

/// The two materials that are compared. A is the object's own, B the second one.
enum class Side { A, B };

/// What side A shows for as long as it is compared, and its own material, which was put aside.
struct LookedAt {
    int object = 0;
    Material own;
    Material shown;

    friend bool operator==(const LookedAt&, const LookedAt&) = default;
};

/// Everything an edit can change.
struct DocumentState {
    Scene scene;
    std::optional<Material> second; ///< side B, shown on the current object; absent: no comparing
    std::optional<LookedAt> lookedAt = std::nullopt; ///< absent: side A shows its own
    std::optional<ComparedPicture> picture = std::nullopt; ///< absent: both draw as the scene says

    friend bool operator==(const DocumentState&, const DocumentState&) = default;
};

/// Names one set of parameter values in a document: what a form shows and a command changes.
struct BlockPath {
    enum class Part {
        Model,    ///< the material's lighting model
        Fresnel,  ///< the material's Fresnel block
        Specular, ///< the material's highlight, for models that leave it open
        Refraction, ///< what bends the light that the material lets through
        Outline,  ///< the lines along the edges of the material's objects
        Accuracy, ///< the accuracy levels of the model
        Material, ///< what every material has: its opacity
        Light,    ///< the values of a light
        Shadow,   ///< the values of a light's shadows
        Fog,      ///< the values of the fog
        Environment, ///< the values of the environment
        Transparency, ///< how what shines through is put together
        Object,   ///< an object's transform and switches
        Scene     ///< ambient, background, exposure, tone mapping
    };
    Part part = Part::Model;
    int index = 0;       ///< of the object (material parts, Object) or of the light (Light, Shadow)
    Side side = Side::A; ///< material parts only

    friend bool operator==(const BlockPath&, const BlockPath&) = default;
};

/// The scene as one side shows it: B has the second material on the current object.
Scene shownScene(const DocumentState& state, int object, Side side);

/// The same without what is laid over it where ways to draw its picture are compared.
Scene ownScene(const DocumentState& state, int object, Side side);

/// What is laid over a side's scene while its picture is compared; null: nothing.
const SidePicture* pictureLaidOver(const DocumentState& state, Side side);

/// Whether side B has another material than what its object has.
bool hasSecondMaterial(const DocumentState& state);

/// The kind of block that a part of a material is beside the model; empty for the other parts.
std::string_view partKind(BlockPath::Part part);

/// Whether values of this part may have images.
bool takesTextures(BlockPath::Part part);

/// The key of a value's image in Material::textures.
std::string textureKey(BlockPath::Part part, std::string_view parameterId);

/// The material a path lies in; null when the object or side B is not there.
const Material* materialAt(const DocumentState& state, int object, Side side);
Material* materialAt(DocumentState& state, int object, Side side);

/// The material that side A of an object has where it shows another one just to be looked at, with
/// what was edited of it since; nothing where it shows its own.
std::optional<Material> materialAside(const DocumentState& state, int object);

/// The block values a path names; null for the parts that no catalogue block describes and for
/// what is not there.
const BlockValues* blockValuesAt(const DocumentState& state, const BlockPath& path);
BlockValues* blockValuesAt(DocumentState& state, const BlockPath& path);

/// A value as it is stored; nothing when it is not stored (its default counts then).
std::optional<Value> storedValue(const DocumentState& state, const BlockPath& path,
                                 std::string_view parameterId);

/// Stores a value; nothing happens when the path is not there or the value has the wrong type.
void storeValue(DocumentState& state, const BlockPath& path, std::string_view parameterId,
                const Value& value);

} // namespace patina
