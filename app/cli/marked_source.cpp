// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/marked_source.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace patina {
namespace {

/// Returns the name of the file that a "#line N S" starts; null for any other line.
const std::string* fileStarting(std::string_view line, const ShaderSource& source) {
    if (!line.starts_with("#line ")) {
        return nullptr;
    }
    const std::string_view number = line.substr(line.rfind(' ') + 1);
    std::size_t index = 0;
    std::from_chars(number.data(), number.data() + number.size(), index);
    return index < source.files.size() ? &source.files[index] : nullptr;
}

/// Maps the start of file names in passes/ to that of effects which have another name.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> effectsOfPasses{{
    {"textures", "texture/"},
    {"image_place", "texture/"},
    {"normal_map", "texture/normal"},
    {"height_map", "texture/height"},
    {"shadow", "shadows/"},
}};

/// Tells whether a file, given by its folder and its name without an extension, belongs to an
/// effect. Files in passes/ begin with the name of an effect or of its kind, as passes/fog.glsl.
bool belongsTo(const std::string& folder, const std::string& stem, const std::string& effect) {
    if (folder != "passes") {
        return effect == folder + '/' + stem;
    }
    for (const auto& [pass, effects] : effectsOfPasses) {
        if (stem.starts_with(pass)) {
            return effect.starts_with(effects);
        }
    }
    return effect.substr(0, effect.find('/')) == stem.substr(0, stem.find('_'));
}

std::string markOf(const std::string& file, const std::vector<EffectLine>& effects) {
    const std::filesystem::path path(file);
    const std::string folder = path.parent_path().filename().string();
    if (folder.empty()) {
        return "// ---- generated\n";
    }
    const std::string name = folder + '/' + path.filename().string();
    const auto found = std::find_if(effects.begin(), effects.end(), [&](const EffectLine& line) {
        return belongsTo(folder, path.stem().string(), line.effect);
    });
    return found == effects.end()
               ? fmt::format("// ---- {}\n", name)
               : fmt::format("// ---- {}: effect {}. {}\n", name, found->effect, found->reason);
}

} // namespace

std::string markedSource(std::string_view title, const ShaderSource& source,
                         const std::vector<EffectLine>& effects) {
    std::string out = fmt::format("// ======== {}\n", title);
    std::string_view rest = source.text;
    const std::string* current = nullptr;
    const std::string* announced = nullptr;
    while (!rest.empty()) {
        const std::size_t end = rest.find('\n');
        const std::string_view line = rest.substr(0, end);
        if (const std::string* file = fileStarting(line, source)) {
            current = file;
        } else {
            // A "#line" that only returns to another file has no line of its own.
            out += current != announced && current != nullptr ? markOf(*current, effects) : "";
            announced = current;
            out.append(line).append("\n");
        }
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    }
    return out;
}

} // namespace patina
