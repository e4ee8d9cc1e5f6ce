// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace patina {

/// Identifies a block that did not ship with Patina and is in the text of a program.
struct StrangerBlock {
    std::string kind;
    std::string id;
    std::filesystem::path file;    ///< its GLSL file, for messages
    std::filesystem::path shaders; ///< the shipped folder of blocks that was loaded with it
    std::filesystem::path own;     ///< the user's folder, in which the folder of its kind is
    std::string hash;              ///< hash of its descriptor and its text

    friend bool operator==(const StrangerBlock&, const StrangerBlock&) = default;
};

} // namespace patina
