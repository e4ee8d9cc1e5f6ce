// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>

#include "catalog/block.h"

namespace patina {

/// Tells what an image on a surface is for; follows from the key under which a material has it.
enum class TextureRole {
    Input,   ///< it drives a parameter of the model or of a part
    Normal,  ///< "normal": a normal map in tangent space, green up
    Height,  ///< "height": a height map in metres
    Opacity, ///< "opacity": how much of the surface is there
};

/// Auto is sRGB for the colours of 8-bit and 16-bit files, and linear for everything else.
enum class TextureColorSpace { Auto, Srgb, Linear };

/// Auto is the first channel that the parameter takes; alpha for the opacity.
enum class TextureChannel { Auto, Color, Red, Green, Blue, Alpha };

enum class TextureMode { Replace, Multiply, Add };
enum class TextureWrap { Repeat, Clamp, Mirror };
enum class TextureFilter { Smooth, Nearest };

/// Represents an image on a surface: which file, and how it is read and laid on.
struct TextureUse {
    std::string file;     ///< a full path with forward slashes
    bool outside = false; ///< a file named it that may not: it is not read until the user agrees
    bool enabled = true;  ///< off: it stays where it lies and counts for nothing
    TextureColorSpace colorSpace = TextureColorSpace::Auto;
    TextureChannel channel = TextureChannel::Auto;
    TextureMode mode = TextureMode::Replace;
    TextureWrap wrap = TextureWrap::Repeat;
    TextureFilter filter = TextureFilter::Smooth;
    glm::dvec2 scale{1.0};  ///< how often the image fits into one unit of u and of v
    glm::dvec2 offset{0.0}; ///< in images, after scale and rotation
    double rotation = 0.0;  ///< degrees, counter-clockwise as seen on the surface
    double strength = 1.0;  ///< 0 .. 1: its share; of a normal map: times the slopes; of a height
                            ///< map: metres from black to white
    bool cutOut = false;    ///< opacity only: either there or not
    double threshold = 0.5; ///< of what is there, while cut out
    nlohmann::json unknown = nlohmann::json::object(); ///< keys the reader did not know

    friend bool operator==(const TextureUse&, const TextureUse&) = default;
};

/// Returns the keys of a material's images that are no parameter's id.
TextureRole textureRole(std::string_view key);

/// Returns an image laid on as usual for that key.
TextureUse textureUse(std::string_view key, std::string file);

/// Returns the settings of an image in this role, described as the parameters of a block;
/// `channels` are those that the parameter takes.
Block textureSettings(TextureRole role, const std::vector<std::string>& channels = {});

/// Reads a setting's value, and puts another one in its place. The id must be one of
/// textureSettings().
Value textureSetting(const TextureUse& use, std::string_view id);
void storeTextureSetting(TextureUse& use, std::string_view id, const Value& value);

} // namespace patina
