// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "catalog/argument_field.h"
#include "catalog/parameter_type.h"

namespace patina {

/// Tells what holds a block of a kind, or settings. Objects hold settings alone so far.
enum class BlockOwner { Material, Light, Scene, Object };

/// Describes a function that the program calls of every block of a kind. Its name is the block's
/// function name and `suffix`; its last argument is the block's struct.
struct BlockFunction {
    std::string_view suffix;
    std::string_view result;     ///< GLSL type
    std::string_view argument{}; ///< GLSL type of the first argument; empty: there is none
    std::string_view name{};     ///< names the first argument
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
    bool isNeeded = false;  ///< each block of the kind has one
    bool mayRepeat = false; ///< several parameters of a block may have it
    /// Lists the values that an enum may offer; empty: any.
    std::span<const std::string_view> choices{};
};

/// Describes a kind of block: one row of the table that everything which knows kinds reads.
struct BlockKind {
    /// Is the folder's name under shaders/, which code uses for the kind, too.
    std::string_view folder;
    std::string_view singular; ///< is the key in files and of `patina eval`, and the option's name
    std::string_view plural;   ///< is used in sentences
    std::string_view label;    ///< is shown before a block's own label
    std::string_view word;     ///< ends the names of structs: "LinearFog"; may be empty
    BlockOwner owner = BlockOwner::Material;
    std::span<const BlockFunction> functions;
    bool isPart = true;           ///< the owner may have no block of the kind
    bool isInRow = false;         ///< the owner has any number of its blocks, one after the other
    bool needsSlot = false;       ///< it has no effect on a model that has no slot of this kind
    bool hasReference = true;     ///< it is compiled in double precision as well
    bool hasTables = false;       ///< its levels may read tables
    bool isInBlockLabels = false; ///< labels of its blocks stand alone, without that of the kind
    std::string_view absent{};    ///< is shown for having none; empty: the label and "off"
    std::string_view noneWord{"none"}; ///< selects none on the command line
    /// Lists the roles that parameters of its blocks may have.
    std::span<const ParameterRole> roles{};
};

/// Names the kinds that some code handles specially, by their folders.
namespace kinds {
inline constexpr std::string_view models = "models";
inline constexpr std::string_view fresnel = "fresnel";
inline constexpr std::string_view specular = "specular";
inline constexpr std::string_view refraction = "refraction";
inline constexpr std::string_view outline = "outline";
inline constexpr std::string_view shells = "shells";
inline constexpr std::string_view strokes = "strokes";
inline constexpr std::string_view lights = "lights";
inline constexpr std::string_view shadows = "shadows";
inline constexpr std::string_view fog = "fog";
inline constexpr std::string_view transparency = "transparency";
inline constexpr std::string_view environment = "environment";
inline constexpr std::string_view tone = "tone";
inline constexpr std::string_view pass = "pass";
} // namespace kinds

/// Names the roles of parameters that the program itself reads.
namespace roles {
inline constexpr std::string_view color = "color"; ///< is the colour of a light or fog
/// Multiply the colour of a light where it meets the diffuse term, the highlight, and any place at
/// all, without being a field of its struct.
inline constexpr std::string_view diffuseColor = "diffuseColor";
inline constexpr std::string_view highlightColor = "highlightColor";
/// Are a light's share that is polarised, and the direction in which its field swings.
inline constexpr std::string_view polarised = "polarised";
inline constexpr std::string_view fieldDirection = "fieldDirection";
/// Says which light a Fresnel term is of: "unpolarised", "s" or "p".
inline constexpr std::string_view polarisation = "polarisation";
/// Also multiplies the ambient light that a highlight reflects.
inline constexpr std::string_view ambientColor = "ambientColor";
inline constexpr std::string_view intensity = "intensity"; ///< multiplies the colour
inline constexpr std::string_view falloff = "falloff";     ///< "polynomial" or "inverse-square"
inline constexpr std::string_view constant = "constant";   ///< is c in 1/(c + l x + q x^2)
inline constexpr std::string_view linear = "linear";       ///< is l in the same
inline constexpr std::string_view quadratic = "quadratic"; ///< is q in the same
inline constexpr std::string_view nearest = "nearest"; ///< is the smallest x in 1/x^2, in metres
inline constexpr std::string_view index = "index";     ///< is the index of refraction
inline constexpr std::string_view indexFrom = "indexFrom";       ///< "surface" or "own"
inline constexpr std::string_view indexInside = "indexInside";   ///< is the index below the surface
inline constexpr std::string_view indexOutside = "indexOutside"; ///< is the index above the surface
inline constexpr std::string_view f0 = "f0"; ///< is the reflectance at normal incidence
inline constexpr std::string_view extinction = "extinction"; ///< absorbs, beside a metal's index
inline constexpr std::string_view diffuse = "diffuse";       ///< multiplies all but the highlight
inline constexpr std::string_view dispersion = "dispersion"; ///< 0: all wavelengths refract alike
/// Are the wavelengths of red, green and blue.
inline constexpr std::string_view wavelengths = "wavelengths";
inline constexpr std::string_view thickness = "thickness"; ///< is the thickness of a pane
inline constexpr std::string_view filter = "filter";       ///< multiplies the transmitted light
inline constexpr std::string_view width = "width";         ///< is the width of lines
/// Are lengths of a drawing that keep their size on the screen, in pixels of the picture times the
/// device pixel ratio.
inline constexpr std::string_view screenLength = "screenLength";
inline constexpr std::string_view length = "length";     ///< is how far strands reach, in metres
inline constexpr std::string_view density = "density";   ///< counts strands along a metre
inline constexpr std::string_view lighting = "lighting"; ///< "surface" or "strand"
inline constexpr std::string_view fins = "fins"; ///< is whether strands stand at silhouettes, too
/// Are set at each pixel of a picture, for models that draw on the surface: the place on it in
/// metres, its unit normal and the way to the viewer, all along the object's axes, and how wide a
/// pixel is there, in metres.
inline constexpr std::string_view place = "place";
inline constexpr std::string_view placeNormal = "placeNormal";
inline constexpr std::string_view placeView = "placeView";
inline constexpr std::string_view placePixel = "placePixel";
/// Are set beside those of the place: how the unit normal changes by the place, in 1/m along the
/// object's axes: the xx, yy and zz of a symmetric matrix, and its xy, yz and zx.
inline constexpr std::string_view placeCurvature = "placeCurvature";
inline constexpr std::string_view placeCurvatureMixed = "placeCurvatureMixed";
/// Are set likewise, for models that lay patterns on the surface by its texture coordinates: those,
/// rising along the tangent and the bitangent, and how they change to the pixel on the right and to
/// the one above.
inline constexpr std::string_view coordinates = "coordinates";
inline constexpr std::string_view coordinatesRight = "coordinatesRight";
inline constexpr std::string_view coordinatesUp = "coordinatesUp";
inline constexpr std::string_view patternWidth = "patternWidth"; ///< at 0: there is no pattern
inline constexpr std::string_view layering = "layering";         ///< "painted" or "standing"
inline constexpr std::string_view background = "background";     ///< "sharp", "blurred" or "hidden"
inline constexpr std::string_view blur = "blur";                 ///< is the blur of the background
inline constexpr std::string_view rotate = "rotate";             ///< turns about the vertical axis
inline constexpr std::string_view directions = "directions";     ///< counts samples per pixel
inline constexpr std::string_view limit = "limit";     ///< is the largest radiance of a direction
inline constexpr std::string_view angle = "angle";     ///< is the angular size of a distant lamp
inline constexpr std::string_view layers = "layers";   ///< is the number of layers that are sorted
inline constexpr std::string_view samples = "samples"; ///< is the number of samples per pixel
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
