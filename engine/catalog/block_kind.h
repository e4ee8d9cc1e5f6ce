// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "catalog/argument_field.h"
#include "catalog/parameter_type.h"

namespace patina {

/// Tells what a block of a kind belongs to.
enum class BlockOwner { Material, Light, Scene, Object };

/// Describes a function that the program calls of every block of a kind. Its name is the block's
/// function name and `suffix`; its last argument is the block's struct.
struct BlockFunction {
    std::string_view suffix;
    std::string_view result;     ///< GLSL type
    std::string_view argument{}; ///< GLSL type of the first argument; empty: it has none
    std::string_view name{};     ///< name of the first argument
    bool isSigned = false;       ///< the result may be below 0: it is a direction
    /// Lists the fields of the argument, in the order of its declaration. It is empty when other
    /// code knows them, or there are none.
    std::span<const ArgumentField> fields{};
};

/// Describes a parameter that the program itself reads: a block's parameter has the role by its key
/// `role`, whatever its id is.
struct ParameterRole {
    std::string_view word;
    ParameterType type = ParameterType::Float;
    bool isNeeded = false;                       ///< each block of the kind has one
    bool mayRepeat = false;                      ///< several parameters of a block may have it
    std::span<const std::string_view> choices{}; ///< values that an enum may offer; empty: any
};

/// Describes a kind of block: one row of the table that everything which knows kinds reads.
struct BlockKind {
    std::string_view folder; ///< name of the folder under shaders/; code uses it as the kind's name
    std::string_view singular; ///< key in files and of `patina eval`, and the option's name
    std::string_view plural;   ///< name in sentences
    std::string_view label;    ///< text on the screen, before a block's own label
    std::string_view word;     ///< ends the names of structs: "LinearFog"; may be empty
    BlockOwner owner = BlockOwner::Material;
    std::span<const BlockFunction> functions;
    bool isPart = true;           ///< the owner may have no block of the kind
    bool needsSlot = false;       ///< it has no effect on a model that has no slot of this kind
    bool hasReference = true;     ///< it is compiled in double precision as well
    bool hasTables = false;       ///< its levels may read tables
    bool isInBlockLabels = false; ///< labels of its blocks stand alone, without that of the kind
    std::string_view absent{};    ///< text for having none; empty: the label and "off"
    std::string_view noneWord{"none"};      ///< selects none on the command line
    std::span<const ParameterRole> roles{}; ///< roles that parameters of its blocks may have
};

/// Names the kinds that some code handles specially, by their folders.
namespace kinds {
inline constexpr std::string_view models = "models";
inline constexpr std::string_view fresnel = "fresnel";
inline constexpr std::string_view specular = "specular";
inline constexpr std::string_view refraction = "refraction";
inline constexpr std::string_view outline = "outline";
inline constexpr std::string_view lights = "lights";
inline constexpr std::string_view shadows = "shadows";
inline constexpr std::string_view fog = "fog";
inline constexpr std::string_view transparency = "transparency";
inline constexpr std::string_view environment = "environment";
inline constexpr std::string_view tone = "tone";
} // namespace kinds

/// Names the roles of parameters that the program itself reads.
namespace roles {
inline constexpr std::string_view color = "color";             ///< the colour of a light or fog
inline constexpr std::string_view intensity = "intensity";     ///< multiplies the colour
inline constexpr std::string_view falloff = "falloff";         ///< "polynomial" or "inverse-square"
inline constexpr std::string_view constant = "constant";       ///< c in 1/(c + l x + q x^2)
inline constexpr std::string_view linear = "linear";           ///< l in the same
inline constexpr std::string_view quadratic = "quadratic";     ///< q in the same
inline constexpr std::string_view nearest = "nearest";         ///< smallest x in 1/x^2
inline constexpr std::string_view index = "index";             ///< index of refraction
inline constexpr std::string_view indexFrom = "indexFrom";     ///< "surface" or "own"
inline constexpr std::string_view indexInside = "indexInside"; ///< index below the surface
inline constexpr std::string_view indexOutside = "indexOutside"; ///< index above the surface
inline constexpr std::string_view f0 = "f0";                 ///< reflectance at normal incidence
inline constexpr std::string_view dispersion = "dispersion"; ///< 0: all wavelengths refract alike
inline constexpr std::string_view thickness = "thickness";   ///< thickness of a pane
inline constexpr std::string_view filter = "filter";         ///< colour of the transmitted light
inline constexpr std::string_view width = "width";           ///< width of lines
inline constexpr std::string_view background = "background"; ///< "sharp", "blurred" or "hidden"
inline constexpr std::string_view blur = "blur";             ///< blur of the background
inline constexpr std::string_view rotate = "rotate";         ///< rotation about the vertical axis
inline constexpr std::string_view directions = "directions"; ///< samples per pixel
inline constexpr std::string_view limit = "limit";           ///< largest radiance of a direction
inline constexpr std::string_view angle = "angle";           ///< angular size of a distant lamp
inline constexpr std::string_view layers = "layers";         ///< number of layers that are sorted
inline constexpr std::string_view samples = "samples";       ///< samples per pixel
} // namespace roles

/// Returns the kinds that Patina ships blocks of.
std::span<const BlockKind> shippedBlockKinds();

/// Returns all kinds, in the order in which they are listed.
std::span<const BlockKind> blockKinds();

/// Returns the kind of a folder; null where there is none.
const BlockKind* findKind(std::string_view folder);

/// Returns the folders of an owner's parts: the kinds that it may have a block of, or none.
std::span<const std::string_view> partKinds(BlockOwner owner);

} // namespace patina
