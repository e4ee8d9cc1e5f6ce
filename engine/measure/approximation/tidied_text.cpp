// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/tidied_text.h"

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "measure/approximation/shader_edit.h"
#include "measure/approximation/unused_argument.h"
#include "measure/interpreter/shader_parser.h"

namespace patina {
namespace {

using PartKind = ShaderExpression::Kind;
using LineKind = ShaderStatement::Kind;

constexpr int maxPasses = 40; ///< each of them takes one layer off

/// Tells whether a pair of parentheses encloses the whole text.
bool isEnclosed(std::string_view text) {
    if (!text.starts_with('(')) {
        return false;
    }
    int open = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        open += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
        if (open == 0) {
            return i + 1 == text.size();
        }
    }
    return false;
}

std::string_view bare(std::string_view text) {
    while (isEnclosed(text)) {
        text = text.substr(1, text.size() - 2);
    }
    return text;
}

/// Tells whether an expression stands beside any operator without parentheses.
bool isAtom(PartKind kind) {
    return kind != PartKind::Unary && kind != PartKind::Binary && kind != PartKind::Choice &&
           kind != PartKind::Assign && kind != PartKind::Step;
}

/// Takes four blanks off the front of every line but the first.
std::string lessIndented(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        out += text[i];
        if (text[i] == '\n' && text.substr(i + 1).starts_with("    ")) {
            i += 4;
        }
    }
    return out;
}

/// Finds what is taken out of a text in one pass.
class TidyPass {
  public:
    TidyPass(const ShaderSyntax& syntax, const std::set<std::string>& functions)
        : syntax_(syntax), text_(syntax.text) {
        for (std::size_t i = 0; i < syntax.functions.size(); ++i) {
            if (functions.contains(std::string(syntax.functions[i].name))) {
                owners_.insert(static_cast<int>(i));
            }
        }
    }

    /// Returns changes that do not overlap, in the order of the text.
    std::vector<ShaderEdit> run() {
        for (const int owner : owners_) {
            if (const int body = syntax_.functions[static_cast<std::size_t>(owner)].body;
                body >= 0) {
                findReads(owner);
                visit(body);
                replaceCopies(owner);
            }
        }
        for (std::size_t i = 0; i < syntax_.expressions.size(); ++i) {
            if (owners_.contains(syntax_.expressions[i].owner)) {
                tidy(static_cast<int>(i));
            }
        }
        std::ranges::stable_sort(edits_, [](const ShaderEdit& a, const ShaderEdit& b) {
            return a.first != b.first ? a.first < b.first : a.last > b.last;
        });
        std::vector<ShaderEdit> apart;
        for (ShaderEdit& edit : edits_) {
            if (apart.empty() || edit.first >= apart.back().last) {
                apart.push_back(std::move(edit));
            }
        }
        return apart;
    }

  private:
    const ShaderExpression& at(int index) const {
        return syntax_.expressions[static_cast<std::size_t>(index)];
    }
    const ShaderStatement& line(int index) const {
        return syntax_.statements[static_cast<std::size_t>(index)];
    }
    std::string_view textOf(int index) const { return syntax_.textOf(at(index)); }
    std::string_view textOfLine(int index) const {
        return text_.substr(line(index).first, line(index).last - line(index).first);
    }
    void replace(std::size_t first, std::size_t last, std::string by) {
        edits_.push_back({first, last, std::move(by)});
    }

    // --- copies

    /// Counts how often each variable of a function is written to.
    std::map<std::size_t, int> writesOf(int owner) const {
        std::map<std::size_t, int> writes;
        const auto count = [&](int target) {
            const ShaderExpression& root = at(rootOf(target));
            writes[root.place] += root.kind == PartKind::Local ? 1 : 0;
        };
        for (const ShaderExpression& each : syntax_.expressions) {
            if (each.owner != owner) {
                continue;
            }
            if (each.kind == PartKind::Assign || each.kind == PartKind::Step) {
                count(each.operands.front());
            }
            for (std::size_t i = 0; each.kind == PartKind::Call && i < each.operands.size(); ++i) {
                const auto& called = syntax_.functions[static_cast<std::size_t>(each.function)];
                if (called.arguments[i].isOut) {
                    count(each.operands[i]);
                }
            }
        }
        return writes;
    }

    /// Reads what a variable is a copy of in its place, where neither ever changes.
    void replaceCopies(int owner) {
        const std::map<std::size_t, int> writes = writesOf(owner);
        const auto isFixed = [&](const ShaderExpression& variable) {
            const auto known = writes.find(variable.place);
            const int times = known == writes.end() ? 0 : known->second;
            const auto named = declared_.find(std::string(variable.sign));
            const bool isDeclared = variables_.contains(variable.place);
            const int names = named == declared_.end() ? 0 : named->second;
            return variable.kind == PartKind::Local && times == (isDeclared ? 1 : 0) &&
                   names == times;
        };
        for (const ShaderStatement& each : syntax_.statements) {
            if (each.declares.size() != 1 || each.statements.size() != 1) {
                continue;
            }
            const ShaderExpression& given = at(line(each.statements.front()).expression);
            const ShaderExpression& copy = at(given.operands[0]);
            const ShaderExpression& source = at(given.operands[1]);
            if (given.owner == owner && isFixed(copy) && isFixed(source) &&
                copy.type == source.type) {
                replaceReads(owner, given.operands[0], std::string(source.sign));
            }
        }
    }

    void replaceReads(int owner, int written, const std::string& by) {
        for (std::size_t i = 0; i < syntax_.expressions.size(); ++i) {
            const ShaderExpression& each = syntax_.expressions[i];
            if (each.owner == owner && each.kind == PartKind::Local &&
                each.place == at(written).place && static_cast<int>(i) != written &&
                each.first < each.last) {
                replace(each.first, each.last, by);
            }
        }
    }

    // --- statements

    /// Removes a statement, with its line where it is alone there.
    void remove(int index) {
        const ShaderStatement& statement = line(index);
        const std::size_t before = text_.find_last_not_of(" \t", statement.first - 1);
        const std::size_t behind = text_.find_first_not_of(" \t", statement.last);
        const bool isAlone = before != std::string_view::npos && text_[before] == '\n' &&
                             behind != std::string_view::npos && text_[behind] == '\n';
        replace(isAlone ? before + 1 : statement.first, isAlone ? behind + 1 : statement.last, {});
    }

    /// Finds the variables that a function reads, rather than only writes to.
    void findReads(int owner) {
        read_.clear();
        declared_.clear();
        variables_.clear();
        std::set<int> targets;
        for (const ShaderStatement& each : syntax_.statements) {
            if (each.kind == LineKind::Expression && each.expression >= 0 &&
                at(each.expression).kind == PartKind::Assign &&
                at(each.expression).owner == owner && !hasEffect(at(each.expression).operands[1])) {
                targets.insert(rootOf(at(each.expression).operands.front()));
            }
        }
        for (std::size_t i = 0; i < syntax_.expressions.size(); ++i) {
            const ShaderExpression& each = syntax_.expressions[i];
            if (each.owner == owner && each.kind == PartKind::Local &&
                !targets.contains(static_cast<int>(i))) {
                read_.insert(each.place);
            }
        }
        countDeclared(syntax_.functions[static_cast<std::size_t>(owner)].body);
    }

    int rootOf(int target) const {
        while (at(target).kind == PartKind::Field || at(target).kind == PartKind::Swizzle ||
               at(target).kind == PartKind::Index) {
            target = at(target).operands.front();
        }
        return target;
    }

    void countDeclared(int index) {
        for (const std::string& name : namesDeclaredBy(index)) {
            ++declared_[name];
        }
        for (const std::size_t place : line(index).declares) {
            variables_.insert(place);
        }
        for (const int inner : line(index).statements) {
            countDeclared(inner);
        }
    }

    /// Returns the names behind the type of a declaration that have values.
    std::vector<std::string> namesDeclaredBy(int index) const {
        std::vector<std::string> names;
        if (!line(index).declares.empty()) {
            for (const int inner : line(index).statements) {
                const int target = at(line(inner).expression).operands.front();
                names.emplace_back(at(target).sign);
            }
        }
        return names;
    }

    bool hasEffect(int index) const {
        const ShaderExpression& each = at(index);
        if (each.kind == PartKind::Assign || each.kind == PartKind::Step) {
            return true;
        }
        if (each.kind == PartKind::Call) {
            const auto& called = syntax_.functions[static_cast<std::size_t>(each.function)];
            if (std::ranges::any_of(called.arguments, &ShaderVariable::isOut)) {
                return true;
            }
        }
        return std::ranges::any_of(each.operands, [this](int inner) { return hasEffect(inner); });
    }

    /// Tells whether a statement does nothing that anything reads.
    bool isIdle(int index) const {
        const ShaderStatement& each = line(index);
        if (!each.declares.empty()) {
            return std::ranges::none_of(each.declares,
                                        [this](std::size_t p) { return read_.contains(p); }) &&
                   std::ranges::none_of(each.statements, [this](int inner) {
                       return hasEffect(at(line(inner).expression).operands[1]);
                   });
        }
        if (each.kind != LineKind::Expression || each.expression < 0) {
            return false;
        }
        const ShaderExpression& done = at(each.expression);
        if (done.kind != PartKind::Assign) {
            return !hasEffect(each.expression);
        }
        const ShaderExpression& root = at(rootOf(done.operands.front()));
        return root.kind == PartKind::Local && variables_.contains(root.place) &&
               !read_.contains(root.place) && !hasEffect(done.operands[1]);
    }

    void visit(int index) {
        const ShaderStatement& each = line(index);
        bool isLeft = false;
        for (const int inner : each.statements) {
            if (each.isBlock && (isLeft || isIdle(inner))) {
                remove(inner);
            } else if (each.isBlock && isDecided(inner)) {
                decide(inner);
            } else {
                visit(inner);
            }
            isLeft = isLeft || line(inner).kind == LineKind::Return;
        }
        if (each.kind == LineKind::If && each.statements.size() > 1 &&
            isDecided(each.statements[1])) {
            decideElse(each);
        }
    }

    bool isDecided(int index) const {
        const ShaderStatement& each = line(index);
        return each.kind == LineKind::If && at(each.expression).kind == PartKind::Literal;
    }

    /// Puts the branch that is taken in the place of a statement of a block.
    void decide(int index) {
        const ShaderStatement& each = line(index);
        const bool isTaken = at(each.expression).number != 0.0;
        if (!isTaken && each.statements.size() < 2) {
            remove(index);
            return;
        }
        const int kept = each.statements[isTaken ? 0 : 1];
        replace(each.first, each.last, inlined(kept));
    }

    /// Returns a branch's text without its braces, where its variables have names of their own.
    std::string inlined(int index) const {
        const ShaderStatement& each = line(index);
        bool isFree = each.isBlock && !each.statements.empty();
        for (const int inner : each.statements) {
            for (const std::string& name : namesDeclaredBy(inner)) {
                isFree = isFree && declared_.at(name) == 1;
            }
        }
        if (!isFree) {
            return std::string(textOfLine(index));
        }
        const std::size_t first = line(each.statements.front()).first;
        const std::size_t last = line(each.statements.back()).last;
        return lessIndented(text_.substr(first, last - first));
    }

    /// Puts what is done in the place of a decided "else if".
    void decideElse(const ShaderStatement& whole) {
        const ShaderStatement& other = line(whole.statements[1]);
        const bool isTaken = at(other.expression).number != 0.0;
        if (isTaken || other.statements.size() > 1) {
            replace(other.first, other.last,
                    std::string(textOfLine(other.statements[isTaken ? 0 : 1])));
        } else {
            replace(line(whole.statements[0]).last, other.last, {});
        }
    }

    // --- expressions

    /// Returns the number that an expression is, in each component of a vector; nothing where it is
    /// none.
    std::optional<double> numberOf(int index) const {
        const ShaderExpression& each = at(index);
        if (each.kind == PartKind::Literal && each.type.isFloat()) {
            return each.number;
        }
        if (each.kind == PartKind::Unary && each.sign == "-" && each.type.isNumber()) {
            const auto number = numberOf(each.operands.front());
            return number ? std::optional(-*number) : std::nullopt;
        }
        if (each.kind != PartKind::Construct || !each.type.isFloat() || each.type.columns > 1) {
            return std::nullopt;
        }
        std::optional<double> all;
        for (const int operand : each.operands) {
            const auto number = numberOf(operand);
            if (!number || (all && *all != *number)) {
                return std::nullopt;
            }
            all = number;
        }
        return all;
    }

    /// Puts an operand, or another text, in the place of an expression.
    void replaceBy(int index, std::string text, bool isAtomic) {
        const bool needs = !isAtomic && isEnclosed(textOf(index)) && !isEnclosed(text);
        replace(at(index).first, at(index).last, needs ? '(' + text + ')' : std::move(text));
    }
    void keepOperand(int index, std::size_t which) {
        const int operand = at(index).operands[which];
        if (at(operand).first < at(operand).last) {
            replaceBy(index, std::string(textOf(operand)), isAtom(at(operand).kind));
        }
    }

    void tidy(int index) {
        const ShaderExpression& each = at(index);
        tidyOperands(each);
        if (each.first >= each.last) {
            return;
        }
        if (isAtom(each.kind) && isEnclosed(syntax_.textOf(each))) {
            replace(each.first, each.last, std::string(bare(syntax_.textOf(each))));
        } else if (each.kind == PartKind::Binary && each.type.isFloat()) {
            tidyArithmetic(index);
        } else if (each.kind == PartKind::Binary && (each.sign == "&&" || each.sign == "||")) {
            tidyLogic(index);
        } else if (each.kind == PartKind::Unary && each.sign == "!" &&
                   at(each.operands.front()).kind == PartKind::Literal) {
            replaceBy(index, at(each.operands.front()).number != 0.0 ? "false" : "true", true);
        } else if (each.kind == PartKind::Choice &&
                   at(each.operands.front()).kind == PartKind::Literal) {
            keepOperand(index, at(each.operands.front()).number != 0.0 ? 1 : 2);
        } else if (each.kind == PartKind::Construct && each.operands.size() > 1 &&
                   each.operands.size() == each.size && numberOf(index)) {
            replaceBy(index,
                      std::string(each.sign) + '(' +
                          std::string(bare(textOf(each.operands.front()))) + ')',
                      true);
        }
    }

    /// Takes the parentheses off what stands by itself.
    void tidyOperands(const ShaderExpression& each) {
        const bool isList = each.kind == PartKind::Call || each.kind == PartKind::Builtin ||
                            each.kind == PartKind::Construct;
        const std::size_t begin = isList ? 0 : 1;
        const bool hasFree =
            isList || each.kind == PartKind::Assign || each.kind == PartKind::Index;
        for (std::size_t i = begin; hasFree && i < each.operands.size(); ++i) {
            tidyAlone(each.operands[i]);
        }
    }

    void tidyAlone(int index) {
        if (at(index).first < at(index).last && isEnclosed(textOf(index))) {
            replace(at(index).first, at(index).last, std::string(bare(textOf(index))));
        }
    }

    void tidyArithmetic(int index) {
        const ShaderExpression& each = at(index);
        const auto left = numberOf(each.operands[0]);
        const auto right = numberOf(each.operands[1]);
        const auto isSame = [&](std::size_t which) {
            return at(each.operands[which]).type == each.type;
        };
        const double neutral = each.sign == "*" || each.sign == "/" ? 1.0 : 0.0;
        const bool isEither = each.sign == "*" || each.sign == "+";
        if (left && right && each.type.isNumber()) {
            const double result = each.sign == "*"   ? *left * *right
                                  : each.sign == "/" ? *left / *right
                                  : each.sign == "+" ? *left + *right
                                                     : *left - *right;
            replaceBy(index, floatText(result), result >= 0.0);
        } else if (right && *right == neutral && isSame(0)) {
            keepOperand(index, 0);
        } else if (left && *left == neutral && isEither && isSame(1)) {
            keepOperand(index, 1);
        }
    }

    void tidyLogic(int index) {
        const ShaderExpression& each = at(index);
        for (const std::size_t which : {std::size_t(0), std::size_t(1)}) {
            const ShaderExpression& operand = at(each.operands[which]);
            if (operand.kind != PartKind::Literal) {
                continue;
            }
            const bool decides = (operand.number != 0.0) == (each.sign == "||");
            if (!decides) {
                keepOperand(index, 1 - which);
            } else if (which == 0 || !hasEffect(each.operands[0])) {
                replaceBy(index, operand.number != 0.0 ? "true" : "false", true);
            }
            return;
        }
    }

    const ShaderSyntax& syntax_;
    std::string_view text_;
    std::set<int> owners_;
    std::set<std::size_t> read_;          ///< are places of variables of one function
    std::set<std::size_t> variables_;     ///< are places of those that it declares
    std::map<std::string, int> declared_; ///< counts the variables of a name
    std::vector<ShaderEdit> edits_;
};

} // namespace

namespace {

/// Makes changes of one pass, as far as the text parses with them.
ShaderSource changed(const ShaderSource& source, std::string_view root,
                     std::span<const ShaderEdit> edits) {
    ShaderSource next = source;
    next.text = editedPart(source.text, 0, source.text.size(), edits);
    if (parsedShader(next, root)) {
        return next;
    }
    if (edits.size() < 2) {
        return source;
    }
    // The later half comes first: it moves no place before it.
    const std::size_t half = edits.size() / 2;
    return changed(changed(source, root, edits.subspan(half)), root, edits.first(half));
}

} // namespace

ShaderSource tidiedSource(ShaderSource source, std::string_view root,
                          const std::set<std::string>& functions) {
    for (int pass = 0; pass < maxPasses; ++pass) {
        const auto syntax = parsedShader(source, root);
        const auto edits = syntax ? TidyPass(*syntax, functions).run() : std::vector<ShaderEdit>();
        ShaderSource next = changed(source, root, edits);
        if (next.text == source.text && syntax) {
            next.text = editedPart(source.text, 0, source.text.size(),
                                   withoutUnusedArgument(*syntax, functions));
        }
        if (next.text == source.text || !parsedShader(next, root)) {
            break;
        }
        source = std::move(next);
    }
    return source;
}

} // namespace patina
