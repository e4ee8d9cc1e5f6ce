// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace patina {

/// A block that did not ship with Patina, as it stands in the text of a program.
struct StrangerBlock {
    std::string kind;
    std::string id;
    std::filesystem::path file;    ///< its GLSL, for messages
    std::filesystem::path shaders; ///< the shipped folder of blocks it was read beside
    std::filesystem::path own;     ///< the folder that its kind's folder lies in
    std::string hash;              ///< of its descriptor and its text

    friend bool operator==(const StrangerBlock&, const StrangerBlock&) = default;
};

} // namespace patina
