// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace patina {

/// What holds a block of a kind.
enum class BlockOwner { Material, Light, Scene, Object };

/// A function that the program calls of every block of a kind. It is named as the block and
/// `suffix`; its last argument is the block's struct.
struct BlockFunction {
    std::string_view suffix;
    std::string_view result;     ///< GLSL type
    std::string_view argument{}; ///< GLSL type of the first argument; empty: it has none
    std::string_view name{};     ///< of the first argument
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
    std::string_view noneWord{"none"};            ///< chooses none on the command line
    std::span<const std::string_view> decisive{}; ///< parameters; any of them at 0 makes it neutral
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
} // namespace kinds

/// The kinds that Patina ships blocks of.
std::span<const BlockKind> shippedBlockKinds();

/// All kinds there are, in the order in which they are listed.
std::span<const BlockKind> blockKinds();

/// The kind of a folder; null where there is none.
const BlockKind* findKind(std::string_view folder);

/// The folders of the kinds that an owner may have a block of, or none: its parts.
std::span<const std::string_view> partKinds(BlockOwner owner);

} // namespace patina
