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
    std::string model;                                     ///< id; empty: from the preset
    std::map<std::string, std::string, std::less<>> parts; ///< kind -> id, of material and scene
    std::map<std::string, std::vector<std::string>, std::less<>>
        ofLights;                      ///< kind -> "id" or "light=id"
    std::vector<std::string> sets;     ///< "id=value"
    std::vector<std::string> textures; ///< "id=file", "id:setting=value"
    std::string mesh;                  ///< a file or "builtin:<name>"; empty: the scene's
    std::string scene;                 ///< a file; empty: the shipped default scene
    bool allowsOutside = false; ///< files that lie outside the folder of who names them are read
    int samples = 0; ///< directions per pixel of an environment's light; 0: see directionsFor()
    std::optional<double> exposure;
    glm::ivec2 size{512, 512};

    /// Returns what is chosen of a kind; empty: what the preset or the scene has.
    const std::string& part(std::string_view kind) const;
};

/// What is expected where something outside a folder was not read.
inline constexpr const char* allowOutsideHint = "--allow-outside, where you trust it";

/// Adds --scene, --mesh, --set, --texture, --model, --samples, --exposure, --allow-outside, and an
/// option for every other kind of block.
void addSceneOptions(CLI::App& command, PictureOptions& options);

/// Adds --size.
void addSizeOption(CLI::App& command, PictureOptions& options);

} // namespace patina
