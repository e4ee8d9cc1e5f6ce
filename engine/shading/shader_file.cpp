// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/shader_file.h"

#include <algorithm>
#include <fstream>
#include <string_view>
#include <system_error>

namespace patina {
namespace {

/// What some editors put before text in UTF-8; to a driver it is no GLSL.
constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";

tl::unexpected<Error> wrong(const std::filesystem::path& file, int line, std::string problem,
                            std::string expected) {
    return tl::unexpected(Error{file.string(), line, line > 0 ? 1 : 0, std::move(problem),
                                std::move(expected)});
}

} // namespace

Result<std::string> readShaderFile(const std::filesystem::path& file) {
    std::error_code failed;
    std::ifstream stream;
    if (std::filesystem::is_regular_file(file, failed)) { // whoever opens a pipe waits
        stream.open(file, std::ios::binary);
    }
    if (!stream.is_open()) {
        return wrong(file, 0, "the shader cannot be read", "an existing file that you may read");
    }
    std::string text(mostShaderBytes + 1, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(stream.gcount()));
    if (stream.bad()) {
        return wrong(file, 0, "reading the shader failed", {});
    }
    if (text.size() > mostShaderBytes) {
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
