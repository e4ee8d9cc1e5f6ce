// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "shading/glsl/stranger_block.h"

namespace patina {

/// Is text for the driver that knows where its parts came from. `#line N S` says that what follows
/// comes from files[S]; N is the line in that file plus S * linesPerFile, because Mesa forgets S
/// for errors inside expressions. files[0] is "generated": its lines are those of `text` itself.
struct ShaderSource {
    static constexpr int linesPerFile = 100000;

    std::string text;
    std::vector<std::string> files{"generated"};
    std::vector<StrangerBlock> strangers{}; ///< are the blocks in the text that did not ship

    friend bool operator==(const ShaderSource&, const ShaderSource&) = default;
};

} // namespace patina
