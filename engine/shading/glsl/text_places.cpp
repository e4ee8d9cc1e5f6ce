// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/glsl/text_places.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

namespace patina {
namespace {

/// Reads the numbers of a line "#line N S".
std::optional<TextPlace> placeIn(std::string_view numbers) {
    int line = 0;
    const auto read = std::from_chars(numbers.data(), numbers.data() + numbers.size(), line);
    if (read.ec != std::errc() || line < 0) {
        return std::nullopt;
    }
    return TextPlace{static_cast<std::size_t>(line / ShaderSource::linesPerFile),
                     line % ShaderSource::linesPerFile};
}

} // namespace

TextPlaces::TextPlaces(std::string_view text) {
    TextPlace place{0, 1};
    std::size_t first = 0;
    do {
        const std::size_t end = std::min(text.find('\n', first), text.size());
        const std::string_view line = text.substr(first, end - first);
        starts_.push_back(first);
        places_.push_back(place);
        ++place.line;
        if (line.starts_with("#line ")) {
            place = placeIn(line.substr(6)).value_or(place);
        }
        first = end + 1;
    } while (first < text.size());
}

std::size_t TextPlaces::lineOf(std::size_t offset) const {
    const auto next = std::ranges::upper_bound(starts_, offset);
    return static_cast<std::size_t>(next - starts_.begin()) - 1;
}

TextPlace TextPlaces::at(std::size_t offset) const {
    return places_[lineOf(offset)];
}

int TextPlaces::columnAt(std::size_t offset) const {
    return static_cast<int>(offset - starts_[lineOf(offset)]) + 1;
}

Error errorAt(const ShaderSource& source, std::size_t offset, std::string problem) {
    const TextPlaces places(source.text);
    const TextPlace place = places.at(offset);
    return {place.file < source.files.size() ? source.files[place.file] : source.files.front(),
            place.line,
            places.columnAt(offset),
            std::move(problem),
            {}};
}

} // namespace patina
