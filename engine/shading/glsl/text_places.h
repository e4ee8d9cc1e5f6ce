// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "shading/glsl/shader_source.h"

namespace patina {

/// Is where a piece of a shader's text came from.
struct TextPlace {
    std::size_t file = 0; ///< is an index of ShaderSource::files
    int line = 0;

    friend auto operator<=>(const TextPlace&, const TextPlace&) = default;
};

/// Finds the places of a text by its lines "#line N S".
class TextPlaces {
  public:
    explicit TextPlaces(std::string_view text);

    TextPlace at(std::size_t offset) const;

    /// Returns the column of a byte, 1-based.
    int columnAt(std::size_t offset) const;

  private:
    /// Returns the index of the line of the text that has a byte.
    std::size_t lineOf(std::size_t offset) const;

    std::vector<std::size_t> starts_;
    std::vector<TextPlace> places_;
};

/// Returns an error at the byte `offset` of a shader's text, in the file that it came from.
Error errorAt(const ShaderSource& source, std::size_t offset, std::string problem);

} // namespace patina
