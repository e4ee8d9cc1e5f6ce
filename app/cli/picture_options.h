// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace CLI {
class App;
}

namespace patina {

/// What the commands that draw have in common.
struct PictureOptions {
    std::string model;             ///< id; empty: from the preset
    std::map<std::string, std::string> parts; ///< kind -> id, of what the material chooses
    std::vector<std::string> sets; ///< "id=value"
    std::vector<std::string> textures; ///< "id=file", "id:setting=value"
    std::string mesh;              ///< a file or "builtin:<name>"; empty: the scene's
    std::string scene;             ///< a file; empty: the shipped default scene
    std::string environment;       ///< a block's id, a file or "none"; empty: the scene's
    std::string transparency;      ///< a block's id or "sorted"; empty: the scene's
    bool allowsOutside = false;    ///< files that lie outside the folder of who names them are read
    int samples = 0; ///< directions per pixel of an environment's light; 0: see directionsFor()
    std::optional<double> exposure;
    glm::ivec2 size{512, 512};
};

/// --scene, --mesh, --set, --texture, --model, --fresnel, --specular, --environment,
/// --transparency, --samples, --exposure, --allow-outside.
void addSceneOptions(CLI::App& command, PictureOptions& options);

/// --size.
void addSizeOption(CLI::App& command, PictureOptions& options);

} // namespace patina
