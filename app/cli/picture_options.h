// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace CLI {
class App;
}

namespace patina {

/// Holds what the commands that draw have in common.
struct PictureOptions {
    std::string model; ///< is an id; empty where the preset's model is meant
    /// Maps a kind to an id, for material and scene.
    std::map<std::string, std::string, std::less<>> parts;
    std::map<std::string, std::vector<std::string>, std::less<>>
        ofLights;                      ///< maps a kind to "id" or "light=id"
    std::vector<std::string> sets;     ///< entries are "id=value"
    std::vector<std::string> textures; ///< entries are "id=file" or "id:setting=value"
    std::string mesh;  ///< is a file or "builtin:<name>"; empty where the scene's mesh is meant
    std::string scene; ///< is a file; empty where the shipped default scene is meant
    /// Allows reading files outside the folder of the file that names them.
    bool allowsOutside = false;
    /// Is the number of directions per pixel of an environment's light; 0 where directionsFor()
    /// decides.
    int samples = 0;
    std::optional<double> exposure;
    glm::ivec2 size{512, 512};
    double pixelRatio = 1.0; ///< is View::pixelRatio

    /// Returns the id that is chosen of a kind; empty where the preset or the scene decides.
    const std::string& part(std::string_view kind) const;
};

/// Tells the user, in a message, how to have files outside a folder read.
inline constexpr const char* allowOutsideHint = "--allow-outside, where you trust it";

/// Adds --allow-outside.
void addAllowOutside(CLI::App& command, bool& allowsOutside);

/// Adds --scene, --mesh, --set, --texture, --model, --samples, --exposure, --allow-outside, and an
/// option for every other kind of block.
void addSceneOptions(CLI::App& command, PictureOptions& options);

/// Adds --size.
void addSizeOption(CLI::App& command, PictureOptions& options);

/// Adds --pixel-ratio.
void addPixelRatioOption(CLI::App& command, PictureOptions& options);

} // namespace patina
