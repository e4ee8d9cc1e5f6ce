// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/left_out.h"

#include <algorithm>

#include <fmt/format.h>

namespace patina {
namespace {

constexpr std::size_t maxNames = 6;
constexpr std::size_t maxNameBytes = 60;

struct Words {
    const char* one;
    const char* many;
};

constexpr std::array<Words, LeftOut::whats> words{{
    {"animation", "animations"},
    {"skin", "skins"},
    {"mesh with morph targets", "meshes with morph targets"},
    {"camera", "cameras"},
    {"light", "lights"},
    {"mesh of points or lines", "meshes of points or lines"},
    {"extension", "extensions"},
    {"image", "images"},
    {"image that is not in the folder", "images that are not in the folder"},
    {"shear of an image", "shears of images"},
    {"second edge of an image", "second edges of images"},
    {"set of vertex colours under an image", "sets of vertex colours under images"},
    {"part of an anisotropy that is too strong", "parts of anisotropies that are too strong"},
    {"extension of materials", "extensions of materials"},
    {"material's extras", "materials' extras"},
}};

/// Returns a name that fits into a sentence: cut between two letters of UTF-8, on one line.
std::string inOneLine(std::string_view name) {
    std::string text(name);
    std::ranges::replace_if(
        text, [](unsigned char c) { return c < ' '; }, ' ');
    if (text.size() <= maxNameBytes) {
        return text;
    }
    std::size_t end = maxNameBytes;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) {
        --end;
    }
    return text.substr(0, end) + "...";
}

} // namespace

void LeftOut::add(What what, std::string_view name) {
    Found& found = found_[static_cast<std::size_t>(what)];
    std::string shown = inOneLine(name);
    const bool isNew = std::ranges::find(found.names, shown) == found.names.end();
    found.count += isNew || what != What::MissingImage ? 1 : 0; // a file counts once
    if (!shown.empty() && found.names.size() <= maxNames && isNew) {
        found.names.push_back(std::move(shown));
    }
}

std::string LeftOut::text(bool areMaterialsWanted) const {
    std::string text;
    const std::size_t told = areMaterialsWanted ? whats : static_cast<std::size_t>(What::Image);
    for (std::size_t i = 0; i < told; ++i) {
        const Found& found = found_[i];
        if (found.count == 0) {
            continue;
        }
        text += fmt::format("{}{} {}", text.empty() ? "not read: " : ", ", found.count,
                            found.count == 1 ? words[i].one : words[i].many);
        for (std::size_t name = 0; name < std::min(found.names.size(), maxNames); ++name) {
            text += (name == 0 ? " (" : ", ") + found.names[name];
        }
        text += found.names.size() > maxNames ? ", ...)" : found.names.empty() ? "" : ")";
    }
    return text;
}

} // namespace patina
