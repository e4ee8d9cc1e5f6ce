// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/unused_argument.h"

#include <algorithm>
#include <optional>

namespace patina {
namespace {

/// Says where each entry of a list begins and ends, without the commas between them.
struct ListedPart {
    std::size_t first = 0;
    std::size_t last = 0;
};

/// Returns the declarations of a function's arguments.
std::vector<ListedPart> declarationsOf(std::string_view text, const ParsedFunction& function) {
    std::vector<ListedPart> parts;
    std::size_t begin = text.find('(', function.first) + 1;
    int open = 1;
    for (std::size_t i = begin; i < function.last && open > 0; ++i) {
        open += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
        if (open == 0 || (open == 1 && text[i] == ',')) {
            parts.push_back({text.find_first_not_of(" \n", begin), i});
            begin = i + 1;
        }
    }
    return parts;
}

/// Returns the edit that takes an entry out of a list, with the comma beside it.
ShaderEdit withoutPart(const std::vector<ListedPart>& parts, std::size_t which) {
    const std::size_t first = which > 0 ? parts[which - 1].last : parts[which].first;
    const bool isFirstOfMore = which == 0 && parts.size() > 1;
    return {first, isFirstOfMore ? parts[1].first : parts[which].last, {}};
}

class ArgumentSearch {
  public:
    ArgumentSearch(const ShaderSyntax& syntax, const std::set<std::string>& functions)
        : syntax_(syntax) {
        for (std::size_t i = 0; i < syntax.functions.size(); ++i) {
            if (functions.contains(std::string(syntax.functions[i].name))) {
                owners_.insert(static_cast<int>(i));
            }
        }
    }

    std::vector<ShaderEdit> run() const {
        for (const int owner : owners_) {
            const ParsedFunction& function = syntax_.functions[static_cast<std::size_t>(owner)];
            for (std::size_t i = 0; function.body >= 0 && i < function.arguments.size(); ++i) {
                if (isUnused(owner, function.arguments[i])) {
                    if (auto edits = editsWithout(owner, i)) {
                        return *edits;
                    }
                }
            }
        }
        return {};
    }

  private:
    bool isUnused(int owner, const ShaderVariable& argument) const {
        return !argument.isOut &&
               std::ranges::none_of(syntax_.expressions, [&](const ShaderExpression& each) {
                   return each.owner == owner && each.kind == ShaderExpression::Kind::Local &&
                          each.place == argument.place;
               });
    }

    bool isPlain(int index) const {
        const ShaderExpression& each = syntax_.expressions[static_cast<std::size_t>(index)];
        const bool isWriting = each.kind == ShaderExpression::Kind::Assign ||
                               each.kind == ShaderExpression::Kind::Step ||
                               each.kind == ShaderExpression::Kind::Call;
        return !isWriting && each.first < each.last &&
               std::ranges::all_of(each.operands, [this](int inner) { return isPlain(inner); });
    }

    /// Returns nothing where a call cannot be changed.
    std::optional<std::vector<ShaderEdit>> editsWithout(int owner, std::size_t which) const {
        const ParsedFunction& function = syntax_.functions[static_cast<std::size_t>(owner)];
        const auto declarations = declarationsOf(syntax_.text, function);
        if (declarations.size() != function.arguments.size()) {
            return std::nullopt;
        }
        std::vector<ShaderEdit> edits{withoutPart(declarations, which)};
        for (const ShaderExpression& call : syntax_.expressions) {
            if (call.kind != ShaderExpression::Kind::Call || call.function != owner) {
                continue;
            }
            std::vector<ListedPart> given;
            for (const int operand : call.operands) {
                const auto& each = syntax_.expressions[static_cast<std::size_t>(operand)];
                given.push_back({each.first, each.last});
            }
            if (!owners_.contains(call.owner) || !isPlain(call.operands[which])) {
                return std::nullopt;
            }
            edits.push_back(withoutPart(given, which));
        }
        if (edits.size() < 2) {
            return std::nullopt; // it is called from outside
        }
        sortEdits(edits);
        return edits;
    }

    const ShaderSyntax& syntax_;
    std::set<int> owners_;
};

} // namespace

std::vector<ShaderEdit> withoutUnusedArgument(const ShaderSyntax& syntax,
                                              const std::set<std::string>& functions) {
    return ArgumentSearch(syntax, functions).run();
}

} // namespace patina
