// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>

#include "catalog/block.h"
#include "core/mesh_material.h"

namespace patina {

/// Tells what an image on a surface is for. It follows from the key under which a material has it.
enum class TextureRole {
    Input,   ///< drives a parameter of the model or of a part
    Normal,  ///< is "normal": a normal map in tangent space, green up
    Height,  ///< is "height": a height map in metres
    Opacity, ///< is "opacity": the share of the surface that is there
};

/// Tells how a file encodes its values. Auto is sRGB for the colours of 8-bit and 16-bit files, and
/// linear for everything else. Roots are the square roots of numbers, as those of roughness are in
/// glTF and in game engines.
enum class TextureColorSpace { Auto, Srgb, Linear, Roots };

/// Tells which channel is used. Auto is the first channel that the parameter takes; alpha for the
/// opacity.
enum class TextureChannel { Auto, Color, Red, Green, Blue, Alpha };

enum class TextureMode { Replace, Multiply, Add };
enum class TextureWrap { Repeat, Clamp, Mirror };
enum class TextureFilter { Smooth, Nearest };

/// Describes an image on a surface: which file it is, how it is read, and how it is placed.
struct TextureUse {
    std::string file;     ///< is a full path with forward slashes, or vertexColorsName
    bool outside = false; ///< says that it is not read until the user agrees (OutsideFile)
    bool enabled = true;  ///< keeps the settings of an unused image where it is false
    TextureColorSpace colorSpace = TextureColorSpace::Auto;
    TextureChannel channel = TextureChannel::Auto;
    TextureMode mode = TextureMode::Replace;
    TextureWrap wrap = TextureWrap::Repeat;
    TextureFilter filter = TextureFilter::Smooth;
    glm::dvec2 scale{1.0};  ///< repeats of the image in one unit of u and of v
    glm::dvec2 offset{0.0}; ///< images, after scale and rotation
    double rotation = 0.0;  ///< degrees, counter-clockwise as seen on the surface
    double strength = 1.0;  ///< is its share, 0 .. 1; a normal map's factor of slopes; a height
                            ///< map's metres from black to white
    bool cutOut = false;    ///< makes each point opaque or absent; for opacity only
    double threshold = 0.5; ///< is the opacity below which a point is absent, while cut out
    nlohmann::json unknown = nlohmann::json::object(); ///< holds keys the reader did not know

    friend bool operator==(const TextureUse&, const TextureUse&) = default;
};

/// Returns the role of an image by its key; every key but "normal", "height" and "opacity" is taken
/// for a parameter's.
TextureRole textureRole(std::string_view key);

/// Returns an image with the default settings for that key.
TextureUse textureUse(std::string_view key, std::string file);

/// Returns the settings of an image in this role, described as the parameters of a block.
/// `channels` are those that the parameter takes; where it is empty, each single channel is one.
Block textureSettings(TextureRole role, const std::vector<std::string>& channels = {});

/// Returns those that vertex colours have: nothing places them.
Block vertexColorSettings(const std::vector<std::string>& channels);

/// Returns a setting's value; the id must be one of textureSettings().
Value textureSetting(const TextureUse& use, std::string_view id);
void storeTextureSetting(TextureUse& use, std::string_view id, const Value& value);

} // namespace patina
