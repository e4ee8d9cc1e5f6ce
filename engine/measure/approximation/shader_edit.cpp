// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/shader_edit.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace patina {

namespace {

// Around the offsets of a part that stays; no shader's text has them.
constexpr char keptBegin = '\x02';
constexpr char keptEnd = '\x03';

struct KeptPart {
    std::size_t first = 0;
    std::size_t last = 0;
};

/// Reads the part that a replacement keeps at `at`, and goes behind it.
KeptPart readKeptPart(std::string_view replacement, std::size_t& at) {
    KeptPart part;
    const char* const end = replacement.data() + replacement.size();
    const auto first = std::from_chars(replacement.data() + at + 1, end, part.first);
    const auto last = std::from_chars(first.ptr + 1, end, part.last);
    at = static_cast<std::size_t>(last.ptr + 1 - replacement.data());
    return part;
}

std::vector<KeptPart> keptPartsOf(std::string_view replacement) {
    std::vector<KeptPart> parts;
    for (std::size_t at = replacement.find(keptBegin); at != std::string_view::npos;
         at = replacement.find(keptBegin, at)) {
        parts.push_back(readKeptPart(replacement, at));
    }
    return parts;
}

bool areApart(const ShaderEdit& a, const ShaderEdit& b) {
    return a.last <= b.first || b.last <= a.first;
}

bool isWithin(const ShaderEdit& inner, const ShaderEdit& outer) {
    return outer.first <= inner.first && inner.last <= outer.last &&
           inner.last - inner.first < outer.last - outer.first;
}

/// Tells whether an edit leaves out the text that another one changes.
bool leavesOut(const ShaderEdit& outer, const ShaderEdit& inner) {
    return isWithin(inner, outer) &&
           std::ranges::none_of(keptPartsOf(outer.replacement), [&inner](const KeptPart& part) {
               return part.first <= inner.first && inner.last <= part.last;
           });
}

/// Tells whether a move changes nothing beside another one.
bool isLostIn(const CheapMove& move, const CheapMove& other) {
    return std::ranges::all_of(move.edits, [&other](const ShaderEdit& edit) {
        return std::ranges::any_of(
            other.edits, [&edit](const ShaderEdit& outer) { return leavesOut(outer, edit); });
    });
}

} // namespace

std::string keptPart(std::size_t first, std::size_t last) {
    return fmt::format("{}{},{}{}", keptBegin, first, last, keptEnd);
}

bool areCompatible(const CheapMove& a, const CheapMove& b) {
    const bool isOneTable = !a.table || !b.table || *a.table == *b.table;
    return isOneTable && !isLostIn(a, b) && !isLostIn(b, a) &&
           std::ranges::none_of(a.edits, [&b](const ShaderEdit& edit) {
               return std::ranges::any_of(b.edits, [&edit](const ShaderEdit& other) {
                   return !areApart(edit, other) && !isWithin(edit, other) &&
                          !isWithin(other, edit);
               });
           });
}

void sortEdits(std::vector<ShaderEdit>& edits) {
    std::ranges::stable_sort(edits, {}, [](const ShaderEdit& edit) {
        // What is put in between, as a helper, precedes what is replaced behind it.
        const std::size_t size = edit.last - edit.first;
        return std::pair(edit.first,
                         size == 0 ? 0 : std::numeric_limits<std::size_t>::max() - size);
    });
}

std::vector<ShaderEdit> editsOf(std::span<const CheapMove* const> moves) {
    std::vector<ShaderEdit> edits;
    for (const CheapMove* move : moves) {
        edits.insert(edits.end(), move->edits.begin(), move->edits.end());
    }
    sortEdits(edits);
    return edits;
}

std::string editedPart(std::string_view text, std::size_t first, std::size_t last,
                       std::span<const ShaderEdit> edits) {
    std::string out;
    for (std::size_t i = 0; i < edits.size(); ++i) {
        const ShaderEdit& edit = edits[i];
        if (edit.first < first || edit.last > last) {
            continue;
        }
        out += text.substr(first, edit.first - first);
        const std::string_view replacement = edit.replacement;
        std::size_t at = 0;
        for (std::size_t kept = replacement.find(keptBegin); kept != std::string_view::npos;
             kept = replacement.find(keptBegin, at)) {
            out += replacement.substr(at, kept - at);
            at = kept;
            const KeptPart part = readKeptPart(replacement, at);
            out += editedPart(text, part.first, part.last, edits.subspan(i + 1));
        }
        out += replacement.substr(at);
        first = edit.last;
    }
    return out.append(text.substr(first, last - first));
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
    sortEdits(all);
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
