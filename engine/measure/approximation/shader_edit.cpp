// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/shader_edit.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace patina {

bool areCompatible(const CheapMove& a, const CheapMove& b) {
    const bool isOneTable = !a.table || !b.table || *a.table == *b.table;
    return isOneTable && std::ranges::none_of(a.edits, [&b](const ShaderEdit& edit) {
               return std::ranges::any_of(b.edits, [&edit](const ShaderEdit& other) {
                   return edit.first < other.last && other.first < edit.last;
               });
           });
}

std::vector<ShaderEdit> editsOf(std::span<const CheapMove* const> moves) {
    std::vector<ShaderEdit> edits;
    for (const CheapMove* move : moves) {
        edits.insert(edits.end(), move->edits.begin(), move->edits.end());
    }
    std::ranges::sort(edits, {}, &ShaderEdit::first);
    return edits;
}

std::string editedPart(std::string_view text, std::size_t first, std::size_t last,
                       std::span<const ShaderEdit> edits) {
    std::string out;
    for (const ShaderEdit& edit : edits) {
        if (edit.first >= first && edit.last <= last) {
            out += text.substr(first, edit.first - first);
            out += edit.replacement;
            first = edit.last;
        }
    }
    return out.append(text.substr(first, last - first));
}

std::string helpersOf(std::span<const ShaderEdit> edits) {
    std::vector<std::string> helpers;
    for (const ShaderEdit& edit : edits) {
        if (!edit.helper.empty() && std::ranges::find(helpers, edit.helper) == helpers.end()) {
            helpers.push_back(edit.helper);
        }
    }
    std::string out;
    for (const std::string& helper : helpers) {
        out += helper;
    }
    return out;
}

ShaderSource editedSource(const ShaderSource& source, const ShaderSyntax& syntax,
                          std::span<const ShaderEdit> edits) {
    std::map<std::string, std::size_t> helpers; // to the first function that calls them
    for (const ShaderEdit& edit : edits) {
        if (const std::string code = edit.helper + edit.tableComputed; !code.empty()) {
            const auto function = static_cast<std::size_t>(edit.function);
            const std::size_t place = syntax.functions[function].first;
            const auto [known, isNew] = helpers.emplace(code, place);
            known->second = isNew ? place : std::min(known->second, place);
        }
    }
    std::vector<ShaderEdit> all(edits.begin(), edits.end());
    for (const auto& [code, place] : helpers) {
        all.push_back({place, place, '\n' + code});
    }
    std::ranges::stable_sort(all, {}, &ShaderEdit::first);
    ShaderSource edited = source;
    edited.text = editedPart(source.text, 0, source.text.size(), all);
    return edited;
}

std::string floatText(double x) {
    std::string text = fmt::format("{}", static_cast<float>(x)); // the fewest digits that give it
    if (text.find_first_of(".e") == std::string::npos) {
        text += ".0";
    }
    return text;
}

} // namespace patina
