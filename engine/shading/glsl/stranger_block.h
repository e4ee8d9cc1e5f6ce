// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace patina {

/// Identifies a block that did not ship with Patina and is in the text of a program.
struct StrangerBlock {
    std::string kind;
    std::string id;
    std::filesystem::path file;    ///< is its GLSL file, for messages
    std::filesystem::path shaders; ///< is the shipped folder of blocks that was loaded with it
    std::filesystem::path own;     ///< is the user's folder, which has the folder of its kind
    std::string hash;              ///< covers its descriptor and its text

    friend bool operator==(const StrangerBlock&, const StrangerBlock&) = default;
};

} // namespace patina
