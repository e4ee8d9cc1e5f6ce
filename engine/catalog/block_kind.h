// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "catalog/argument_field.h"
#include "catalog/parameter_type.h"

namespace patina {

/// Tells what holds a block of a kind.
enum class BlockOwner { Material, Light, Scene, Object };

/// A function that the program calls of every block of a kind. It is named as the block and
/// `suffix`; its last argument is the block's struct.
struct BlockFunction {
    std::string_view suffix;
    std::string_view result;     ///< GLSL type
    std::string_view argument{}; ///< GLSL type of the first argument; empty: it has none
    std::string_view name{};     ///< of the first argument
    bool isSigned = false;       ///< its result may be below 0: it is a direction
    std::span<const ArgumentField> fields{}; ///< of the argument, in the order of its declaration;
                                             ///< empty: other code knows it, or none
};

/// Holds what the program itself reads of a block: a parameter has it by its key `role`, whatever
/// it is called.
struct ParameterRole {
    std::string_view word;
    ParameterType type = ParameterType::Float;
    bool isNeeded = false;                       ///< each block of the kind has one
    bool mayRepeat = false;                      ///< several parameters of a block may have it
    std::span<const std::string_view> choices{}; ///< of an enum: what it may offer; empty: anything
};

/// A kind of block: one row of the table that everything reads which knows kinds.
struct BlockKind {
    std::string_view folder;   ///< under shaders/; also what code calls the kind
    std::string_view singular; ///< the key in files and of `patina eval`, and the option's name
    std::string_view plural;   ///< in sentences
    std::string_view label;    ///< on the screen, before a block's own label
    std::string_view word;     ///< that ends the names of structs: "LinearFog"; may be empty
    BlockOwner owner = BlockOwner::Material;
    std::span<const BlockFunction> functions;
    bool isPart = true;           ///< its owner may do without one
    bool needsSlot = false;       ///< it does nothing for a model that has no slot of this kind
    bool hasReference = true;     ///< it is compiled in double precision as well
    bool hasTables = false;       ///< its levels may read tables
    bool isInBlockLabels = false; ///< labels of its blocks stand alone, without that of the kind
    std::string_view absent{};    ///< what having none is called; empty: the label and "off"
    std::string_view noneWord{"none"};      ///< chooses none on the command line
    std::span<const ParameterRole> roles{}; ///< that parameters of its blocks may have
};

/// The kinds that some code is about, by their folders.
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

/// The roles of parameters that some code is about.
namespace roles {
inline constexpr std::string_view color = "color";             ///< of a light, of fog
inline constexpr std::string_view intensity = "intensity";     ///< that multiplies the colour
inline constexpr std::string_view falloff = "falloff";         ///< "polynomial" or "inverse-square"
inline constexpr std::string_view constant = "constant";       ///< of 1/(c + l x + q x^2)
inline constexpr std::string_view linear = "linear";           ///< of the same
inline constexpr std::string_view quadratic = "quadratic";     ///< of the same
inline constexpr std::string_view nearest = "nearest";         ///< where 1/x^2 ends
inline constexpr std::string_view index = "index";             ///< of refraction
inline constexpr std::string_view indexFrom = "indexFrom";     ///< "surface" or "own"
inline constexpr std::string_view indexInside = "indexInside"; ///< below the surface
inline constexpr std::string_view indexOutside = "indexOutside"; ///< above it
inline constexpr std::string_view f0 = "f0";                     ///< the reflectance facing you
inline constexpr std::string_view dispersion = "dispersion";     ///< at 0 colours bend alike
inline constexpr std::string_view thickness = "thickness";       ///< of a pane
inline constexpr std::string_view filter = "filter";             ///< colours what passes
inline constexpr std::string_view width = "width";               ///< of lines
inline constexpr std::string_view background = "background";     ///< "sharp", "blurred" or "hidden"
inline constexpr std::string_view blur = "blur";                 ///< of the background
inline constexpr std::string_view rotate = "rotate";             ///< about the vertical
inline constexpr std::string_view directions = "directions";     ///< looked in per pixel
inline constexpr std::string_view limit = "limit";               ///< no direction sends more
inline constexpr std::string_view angle = "angle";               ///< how large a far lamp looks
inline constexpr std::string_view layers = "layers";             ///< put in order
inline constexpr std::string_view samples = "samples";           ///< places looked at per pixel
} // namespace roles

/// Returns the kinds that Patina ships blocks of.
std::span<const BlockKind> shippedBlockKinds();

/// All kinds there are, in the order in which they are listed.
std::span<const BlockKind> blockKinds();

/// The kind of a folder; null where there is none.
const BlockKind* findKind(std::string_view folder);

/// The folders of the kinds that an owner may have a block of, or none: its parts.
std::span<const std::string_view> partKinds(BlockOwner owner);

} // namespace patina
