// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/marked_source.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <string_view>

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

/// Returns the effect that a file belongs to, given by its folder and its name without extension;
/// null when it is none's. Files in passes/ are called kind or kind_name:
/// passes/texture_normal.glsl is that of texture/normal, passes/shadows_taps.glsl that of whatever
/// shadows there are.
const EffectLine* effectOf(const std::string& folder, const std::string& stem,
                           const std::vector<EffectLine>& effects) {
    const bool isOfPass = folder == "passes";
    const std::string kind = stem.substr(0, stem.find('_'));
    const std::string name = !isOfPass      ? folder + '/' + stem
                             : stem == kind ? kind
                                            : kind + '/' + stem.substr(kind.size() + 1);
    auto found = std::ranges::find(effects, name, &EffectLine::effect);
    if (found == effects.end() && isOfPass) {
        found = std::ranges::find_if(effects, [&kind](const EffectLine& line) {
            return line.effect.substr(0, line.effect.find('/')) == kind;
        });
    }
    return found == effects.end() ? nullptr : &*found;
}

std::string markOf(const std::string& file, const std::vector<EffectLine>& effects) {
    const std::filesystem::path path(file);
    const std::string folder = path.parent_path().filename().string();
    if (folder.empty()) {
        return "// ---- generated\n";
    }
    const std::string name = folder + '/' + path.filename().string();
    const EffectLine* effect = effectOf(folder, path.stem().string(), effects);
    return effect == nullptr
               ? fmt::format("// ---- {}\n", name)
               : fmt::format("// ---- {}: effect {}. {}\n", name, effect->effect, effect->reason);
}

} // namespace

std::string markedSource(std::string_view title, const ShaderSource& source,
                         const std::vector<EffectLine>& effects,
                         const std::map<int, std::string>& margins) {
    std::size_t columns = 0;
    for (const auto& margin : margins) {
        columns = std::max(columns, margin.second.size());
    }
    const std::string blank = columns > 0 ? std::string(columns, ' ') + " | " : "";
    int number = 0;
    std::string out = fmt::format("// ======== {}\n", title);
    std::string_view rest = source.text;
    const std::string* current = nullptr;
    const std::string* announced = nullptr;
    while (!rest.empty()) {
        const std::size_t end = rest.find('\n');
        const std::string_view line = rest.substr(0, end);
        const auto margin = margins.find(++number);
        if (const std::string* file = fileStarting(line, source)) {
            current = file;
        } else {
            // A "#line" that only returns to another file has no line of its own.
            const bool isAnother = current != announced && current != nullptr;
            out += isAnother ? blank + markOf(*current, effects) : "";
            announced = current;
            out +=
                margin == margins.end() ? blank : fmt::format("{:>{}} | ", margin->second, columns);
            out.append(line).append("\n");
        }
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    }
    return out;
}

} // namespace patina
