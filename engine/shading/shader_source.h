// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace patina {

/// Text for the driver that knows where its parts came from: `#line N S` in it means line N of
/// files[S]. files[0] is "generated", whose lines are those of `text` itself.
struct ShaderSource {
    std::string text;
    std::vector<std::string> files{"generated"};

    friend bool operator==(const ShaderSource&, const ShaderSource&) = default;
};

} // namespace patina
