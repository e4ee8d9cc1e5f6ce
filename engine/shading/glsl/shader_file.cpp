// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/glsl/shader_file.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string_view>

#include "core/ordinary_file.h"

namespace patina {
namespace {

/// Is what some editors put before text in UTF-8; a driver does not accept it as GLSL.
constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";

tl::unexpected<Error> wrong(const std::filesystem::path& file, int line, std::string problem,
                            std::string expected) {
    return tl::unexpected(
        Error{file.string(), line, line > 0 ? 1 : 0, std::move(problem), std::move(expected)});
}

} // namespace

Result<std::string> readShaderFile(const std::filesystem::path& file) {
    constexpr auto anySize = std::numeric_limits<std::uintmax_t>::max();
    const auto read = OrdinaryFile::open(file, anySize).and_then([](const OrdinaryFile& opened) {
        return opened.start(maxShaderBytes + 1);
    });
    if (!read) {
        const std::string& why = read.error().problem;
        const bool isOfTheFile = why.starts_with("is ") || why.starts_with("cannot ");
        return wrong(file, 0, (isOfTheFile ? "the shader " : "the shader cannot be read: ") + why,
                     "an existing file that you may read");
    }
    std::string text = *read;
    if (text.size() > maxShaderBytes) {
        return wrong(file, 0, "the shader is larger than 1 MiB", "a text in GLSL");
    }
    const auto nul = std::find(text.begin(), text.end(), '\0');
    if (nul != text.end()) {
        const auto line = 1 + static_cast<int>(std::count(text.begin(), nul, '\n'));
        return wrong(file, line, "the shader has a NUL byte in it", "a text in GLSL");
    }
    if (text.starts_with(byteOrderMark)) {
        text.erase(0, byteOrderMark.size());
    }
    return text;
}

} // namespace patina
