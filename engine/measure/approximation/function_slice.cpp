// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/function_slice.h"

#include <algorithm>
#include <span>

#include <fmt/format.h>

#include "measure/approximation/shader_edit.h"
#include "shading/glsl/tokens.h"

namespace patina {
namespace {

using SyntaxKind = ShaderExpression::Kind;
using Places = std::set<std::size_t>; ///< are places of variables in the numbers of their function

/// Is a variable that an expression reads, with the fields and elements that follow it.
struct ReadLeaf {
    int expression = -1;
    int root = -1; ///< is the variable alone
};

/// Is a statement of a function's body, with what lies in it.
struct BodyStatement {
    int statement = -1;
    std::size_t first = 0; ///< are the offsets of its text
    std::size_t last = 0;
    std::vector<ReadLeaf> reads{};
    Places writes{};
    std::set<std::string_view> declares{}; ///< are names that it declares without a value
    std::set<int> expressions{};
    bool isLeft = false; ///< it may return
};

bool isPath(SyntaxKind kind) {
    return kind == SyntaxKind::Field || kind == SyntaxKind::Swizzle || kind == SyntaxKind::Index;
}

/// Returns the names in a text, without fields and components.
std::set<std::string> namesIn(const std::string& text) {
    std::set<std::string> names;
    const GlslTokens tokens = glslTokens(text);
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (tokens[i].isName() && (i == 0 || tokens[i - 1].text != ".")) {
            names.insert(std::string(tokens[i].text));
        }
    }
    return names;
}

/// Returns a name that is not taken, and takes it.
std::string freeName(std::string name, std::set<std::string>& taken) {
    while (!taken.insert(name).second) {
        name += '1';
    }
    return name;
}

/// Returns the last name of "d.nl"; empty for what is more than a path.
std::string lastName(const std::string& text) {
    const GlslTokens tokens = glslTokens(text);
    const bool isOne = std::ranges::all_of(
        tokens, [](const GlslToken& token) { return token.isName() || token.text == "."; });
    return isOne && !tokens.empty() ? std::string(tokens.back().text) : std::string();
}

} // namespace

/// Holds what the statements of one function's body read and write.
class FunctionSlicer::Flow {
  public:
    Flow(const ShaderSyntax& syntax, int function, const std::string& parameters)
        : syntax_(syntax), function_(syntax.functions[static_cast<std::size_t>(function)]) {
        for (const ShaderVariable& argument : function_.arguments) {
            arguments_.insert(argument.place);
            const int structure = argument.type.structure;
            if (structure >= 0 && !argument.isOut &&
                syntax.structs[static_cast<std::size_t>(structure)].name == parameters) {
                values_ = argument.place;
                valuesName_ = argument.name;
            }
        }
        isKnown_ = values_.has_value() && readStatements();
        for (const BodyStatement& statement : statements_) {
            written_.insert(statement.writes.begin(), statement.writes.end());
        }
    }

    std::optional<SlicedTerm> slice(int expression, TermLeaves leaves) const {
        const std::size_t at = statementOf(expression);
        BodyStatement alone;
        addExpression(expression, alone);
        if (!isKnown_ || at == statements_.size() || !alone.writes.empty()) {
            return std::nullopt;
        }
        Slice made(*this, expression, at);
        return made.run(leaves);
    }

  private:
    const ShaderExpression& expressionAt(int index) const {
        return syntax_.expressions[static_cast<std::size_t>(index)];
    }
    bool isValues(const ShaderExpression& root) const { return root.place == *values_; }
    bool isArgument(const ShaderExpression& root) const { return arguments_.contains(root.place); }
    bool isNumber(int index) const { return expressionAt(index).type.isNumber(); }
    bool hasText(int index) const { return expressionAt(index).first < expressionAt(index).last; }

    std::size_t statementOf(int expression) const {
        const auto found = std::ranges::find_if(statements_, [&](const BodyStatement& each) {
            return each.expressions.contains(expression);
        });
        return static_cast<std::size_t>(found - statements_.begin());
    }

    /// Collects the variables that an expression reads.
    void addReads(int index, std::vector<ReadLeaf>& reads) const {
        const ShaderExpression& expression = expressionAt(index);
        int root = index;
        while (isPath(expressionAt(root).kind)) {
            root = expressionAt(root).operands.front();
        }
        if (expressionAt(root).kind == SyntaxKind::Local) {
            reads.push_back({index, root});
            for (int each = index; each != root; each = expressionAt(each).operands.front()) {
                if (expressionAt(each).kind == SyntaxKind::Index) {
                    addReads(expressionAt(each).operands[1], reads);
                }
            }
            return;
        }
        for (const int operand : expression.operands) {
            addReads(operand, reads);
        }
    }

    void addWrite(int target, Places& writes) const {
        while (isPath(expressionAt(target).kind)) {
            target = expressionAt(target).operands.front();
        }
        if (expressionAt(target).kind == SyntaxKind::Local) {
            writes.insert(expressionAt(target).place);
        }
    }

    void addExpression(int index, BodyStatement& to) const {
        const ShaderExpression& expression = expressionAt(index);
        to.expressions.insert(index);
        if (expression.kind == SyntaxKind::Assign || expression.kind == SyntaxKind::Step) {
            addWrite(expression.operands.front(), to.writes);
        }
        if (expression.kind == SyntaxKind::Call) {
            const auto called = static_cast<std::size_t>(expression.function);
            const auto& arguments = syntax_.functions[called].arguments;
            for (std::size_t i = 0; i < arguments.size(); ++i) {
                if (arguments[i].isOut) {
                    addWrite(expression.operands[i], to.writes);
                }
            }
        }
        for (const int operand : expression.operands) {
            addExpression(operand, to);
        }
    }

    void addStatement(int index, BodyStatement& to) const {
        const ShaderStatement& each = syntax_.statements[static_cast<std::size_t>(index)];
        to.isLeft = to.isLeft || each.kind == ShaderStatement::Kind::Return;
        for (const int expression : {each.expression, each.step}) {
            if (expression >= 0) {
                addExpression(expression, to);
                addReads(expression, to.reads);
            }
        }
        for (const int inner : each.statements) {
            addStatement(inner, to);
        }
    }

    /// Finds the text of each statement of the body; false where that is not clear.
    bool readStatements() {
        const std::string code =
            withoutComments(syntax_.text.substr(function_.first, function_.last - function_.first));
        GlslTokens tokens = glslTokens(code);
        std::erase_if(tokens,
                      [](const GlslToken& token) { return directiveName(token) == "line"; });
        const auto open = std::ranges::find(tokens, "{", &GlslToken::text);
        if (open == tokens.end() || function_.body < 0) {
            return false;
        }
        const auto& body = syntax_.statements[static_cast<std::size_t>(function_.body)];
        int depth = 0;
        auto begin = open + 1;
        for (auto it = begin; it + 1 < tokens.end(); ++it) {
            depth += it->text == "{" || it->text == "(" ? 1 : 0;
            depth -= it->text == "}" || it->text == ")" ? 1 : 0;
            const bool ends = depth == 0 && (it->text == ";" || it->text == "}");
            if (it->isDirective()) {
                return false;
            }
            if (!ends || (it + 1)->text == "else") {
                continue;
            }
            if (statements_.size() == body.statements.size()) {
                return false;
            }
            BodyStatement made{.statement = body.statements[statements_.size()]};
            made.first = offsetOf(code, *begin);
            made.last = offsetOf(code, *it) + 1;
            addStatement(made.statement, made);
            if (made.expressions.empty() && begin->text != "{" && begin->text != ";") {
                addDeclared({begin + 1, it}, made);
            }
            statements_.push_back(std::move(made));
            begin = it + 1;
        }
        return statements_.size() == body.statements.size();
    }

    std::size_t offsetOf(const std::string& code, const GlslToken& token) const {
        return function_.first + static_cast<std::size_t>(token.text.data() - code.data());
    }

    /// Keeps the names of "x, y" in "float x, y"; their text is that of the syntax.
    void addDeclared(std::span<const GlslToken> tokens, BodyStatement& to) const {
        const std::string_view text = syntax_.text.substr(to.first, to.last - to.first);
        for (const GlslToken& token : tokens) {
            if (token.isName()) {
                to.declares.insert(text.substr(text.find(token.text), token.text.size()));
            }
        }
    }

    /// Is what leads to some variables: statements before one, with all that they read.
    struct Cone {
        std::set<std::size_t> statements;
        Places variables;
        std::vector<ReadLeaf> leaves; ///< are arguments of the function that the statements read
    };

    /// Returns what leads to a variable before a statement; nothing where it depends on what is
    /// neither a number nor one of the block's values.
    std::optional<Cone> coneOf(std::size_t place, std::size_t before) const {
        Cone cone{{}, {place}, {}};
        if (statements_[before].writes.contains(place)) {
            return std::nullopt;
        }
        for (std::size_t i = before; i-- > 0;) {
            const BodyStatement& each = statements_[i];
            if (!leadsTo(each, cone.variables)) {
                continue;
            }
            if (each.isLeft || std::ranges::any_of(each.writes, [this](std::size_t written) {
                    return arguments_.contains(written);
                })) {
                return std::nullopt;
            }
            cone.statements.insert(i);
            cone.variables.insert(each.writes.begin(), each.writes.end());
            for (const ReadLeaf& leaf : each.reads) {
                const ShaderExpression& root = expressionAt(leaf.root);
                if (!isArgument(root)) {
                    cone.variables.insert(root.place);
                } else if (isAllowed(leaf)) {
                    cone.leaves.push_back(leaf);
                } else {
                    return std::nullopt;
                }
            }
        }
        return cone;
    }

    bool leadsTo(const BodyStatement& statement, const Places& variables) const {
        const auto isNamed = [&](const ShaderExpression& each) {
            return each.kind == SyntaxKind::Local && variables.contains(each.place) &&
                   statement.declares.contains(each.sign);
        };
        const auto isOwn = [this](const ShaderExpression& each) {
            return each.owner >= 0 &&
                   &syntax_.functions[static_cast<std::size_t>(each.owner)] == &function_;
        };
        return std::ranges::any_of(
                   variables,
                   [&](std::size_t place) { return statement.writes.contains(place); }) ||
               (!statement.declares.empty() &&
                std::ranges::any_of(syntax_.expressions, [&](const ShaderExpression& each) {
                    return isOwn(each) && isNamed(each);
                }));
    }

    /// Tells whether an argument may be read in a function of the block's values and numbers.
    bool isAllowed(const ReadLeaf& leaf) const {
        const ShaderExpression& root = expressionAt(leaf.root);
        if (!hasText(leaf.expression) || written_.contains(root.place)) {
            return false;
        }
        return isValues(root) ? leaf.expression != leaf.root : isNumber(leaf.expression);
    }

    /// Makes one term.
    class Slice {
      public:
        Slice(const Flow& flow, int expression, std::size_t at)
            : flow_(flow), expression_(expression), at_(at) {
            made_.expression = expression;
            made_.parameters = flow.valuesName_;
        }

        std::optional<SlicedTerm> run(TermLeaves leaves) {
            const bool isFound =
                leaves == TermLeaves::Operands ? readOperands() : readLeaves(expression_, leaves);
            if (!isFound || !flow_.hasText(expression_)) {
                return std::nullopt;
            }
            for (const ReadLeaf& leaf : cone_.leaves) {
                use(leaf);
            }
            write();
            remove();
            return std::move(made_);
        }

      private:
        /// Takes what varies among the arguments of a call as numbers.
        bool readOperands() {
            const ShaderExpression& call = flow_.expressionAt(expression_);
            const bool isCall = call.kind == SyntaxKind::Call || call.kind == SyntaxKind::Builtin;
            if (!isCall || !std::ranges::all_of(call.operands, [this](int operand) {
                    return flow_.isNumber(operand);
                })) {
                return false;
            }
            for (const int operand : call.operands) {
                if (isUniform(operand)) {
                    readLeaves(operand, TermLeaves::Near);
                } else if (!useNumber(operand)) {
                    return false;
                }
            }
            return true;
        }

        /// Tells whether an expression follows from the block's values alone.
        bool isUniform(int index) const {
            std::vector<ReadLeaf> reads;
            flow_.addReads(index, reads);
            return std::ranges::all_of(reads, [this](const ReadLeaf& leaf) {
                const ShaderExpression& root = flow_.expressionAt(leaf.root);
                if (flow_.isArgument(root)) {
                    return flow_.isValues(root) && flow_.isAllowed(leaf);
                }
                const auto cone = flow_.coneOf(root.place, at_);
                return cone && isOfValues(*cone);
            });
        }

        bool isOfValues(const Cone& cone) const {
            return std::ranges::all_of(cone.leaves, [this](const ReadLeaf& leaf) {
                return flow_.isValues(flow_.expressionAt(leaf.root));
            });
        }

        bool readLeaves(int index, TermLeaves leaves) {
            std::vector<ReadLeaf> reads;
            flow_.addReads(index, reads);
            return std::ranges::all_of(reads, [&](const ReadLeaf& leaf) {
                const ShaderExpression& root = flow_.expressionAt(leaf.root);
                if (flow_.isArgument(root)) {
                    return flow_.isAllowed(leaf) ? use(leaf) : useNumber(leaf.expression);
                }
                const auto cone = flow_.coneOf(root.place, at_);
                if (cone && (leaves == TermLeaves::Far || isOfValues(*cone))) {
                    join(*cone);
                    return true;
                }
                return useNumber(leaf.expression);
            });
        }

        void join(const Cone& cone) {
            cone_.statements.insert(cone.statements.begin(), cone.statements.end());
            cone_.variables.insert(cone.variables.begin(), cone.variables.end());
            cone_.leaves.insert(cone_.leaves.end(), cone.leaves.begin(), cone.leaves.end());
        }

        /// Reads an argument of the function.
        bool use(const ReadLeaf& leaf) {
            const ShaderExpression& root = flow_.expressionAt(leaf.root);
            if (!flow_.isValues(root)) {
                return useNumber(leaf.expression);
            }
            int field = leaf.expression;
            while (flow_.expressionAt(field).operands.front() != leaf.root) {
                field = flow_.expressionAt(field).operands.front();
            }
            made_.fields.insert(std::string(flow_.expressionAt(field).sign));
            edits_.push_back({root.first, root.last, "p", {}, -1});
            return flow_.hasText(leaf.root);
        }

        bool useNumber(int index) {
            if (!flow_.isNumber(index) || !flow_.hasText(index)) {
                return false;
            }
            const ShaderExpression& number = flow_.expressionAt(index);
            const std::string text(flow_.syntax_.textOf(number));
            if (std::ranges::find(made_.variables, text, &SlicedTerm::Variable::text) ==
                made_.variables.end()) {
                made_.variables.push_back({text, {}, index});
            }
            numbers_.push_back(index);
            return true;
        }

        /// Names the numbers, and writes the text with these names.
        void write() {
            std::set<std::string> taken{"p"};
            const auto take = [&](std::size_t first, std::size_t last) {
                const std::string text(flow_.syntax_.text.substr(first, last - first));
                taken.merge(namesIn(withoutComments(text)));
            };
            const ShaderExpression& term = flow_.expressionAt(expression_);
            take(term.first, term.last);
            for (const std::size_t i : cone_.statements) {
                take(flow_.statements_[i].first, flow_.statements_[i].last);
            }
            for (SlicedTerm::Variable& variable : made_.variables) {
                const std::string own = lastName(variable.text);
                const bool isFree = !own.empty() && (own == variable.text || !taken.contains(own));
                variable.name = isFree ? own : freeName("x", taken);
                taken.insert(variable.name);
            }
            made_.place = freeName("u", taken);
            for (const int index : numbers_) {
                const ShaderExpression& number = flow_.expressionAt(index);
                const std::string text(flow_.syntax_.textOf(number));
                const auto known =
                    std::ranges::find(made_.variables, text, &SlicedTerm::Variable::text);
                edits_.push_back({number.first, number.last, known->name, {}, -1});
            }
            std::ranges::sort(edits_, {}, &ShaderEdit::first);
            const auto isSame = [](const ShaderEdit& a, const ShaderEdit& b) {
                return a.first == b.first;
            };
            edits_.erase(std::unique(edits_.begin(), edits_.end(), isSame), edits_.end());
            for (const std::size_t i : cone_.statements) {
                const BodyStatement& each = flow_.statements_[i];
                made_.entry +=
                    "    " + editedPart(flow_.syntax_.text, each.first, each.last, edits_) + '\n';
            }
            made_.term = editedPart(flow_.syntax_.text, term.first, term.last, edits_);
        }

        /// Finds the statements that only the term needs.
        void remove() {
            std::set<std::size_t> removed = cone_.statements;
            while (std::erase_if(removed, [&](std::size_t each) {
                       return isNeededBeside(each, removed);
                   }) > 0) {
            }
            for (const std::size_t each : removed) {
                made_.removed.push_back(flow_.statements_[each].statement);
                made_.removedText.push_back(linesOf(flow_.statements_[each]));
            }
        }

        /// Returns where a statement stands, with the line's beginning and end where it is alone.
        std::pair<std::size_t, std::size_t> linesOf(const BodyStatement& statement) const {
            const std::string_view text = flow_.syntax_.text;
            const std::size_t before = text.find_last_not_of(" \t", statement.first - 1);
            const std::size_t behind = text.find_first_not_of(" \t", statement.last);
            const bool isAlone = before != std::string_view::npos && text[before] == '\n' &&
                                 behind != std::string_view::npos && text[behind] == '\n';
            return isAlone ? std::pair(before + 1, behind + 1)
                           : std::pair(statement.first, statement.last);
        }

        bool isNeededBeside(std::size_t index, const std::set<std::size_t>& removed) const {
            const BodyStatement& statement = flow_.statements_[index];
            const auto isHere = [&](const ReadLeaf& leaf) {
                const ShaderExpression& root = flow_.expressionAt(leaf.root);
                return statement.writes.contains(root.place) ||
                       statement.declares.contains(root.sign);
            };
            for (std::size_t i = 0; i < flow_.statements_.size(); ++i) {
                if (i == index || removed.contains(i)) {
                    continue;
                }
                const BodyStatement& other = flow_.statements_[i];
                const bool isWritten = std::ranges::any_of(other.writes, [&](std::size_t place) {
                    return statement.writes.contains(place);
                });
                if (isWritten || std::ranges::any_of(other.reads, [&](const ReadLeaf& leaf) {
                        return isHere(leaf) && !isInTerm(leaf);
                    })) {
                    return true;
                }
            }
            return false;
        }

        /// Tells whether the term reads a variable whose statements are cut out with it.
        bool isInTerm(const ReadLeaf& leaf) const {
            const ShaderExpression& term = flow_.expressionAt(expression_);
            const ShaderExpression& read = flow_.expressionAt(leaf.expression);
            const bool isNumber = std::ranges::any_of(numbers_, [&](int index) {
                const ShaderExpression& number = flow_.expressionAt(index);
                return number.first <= read.first && read.last <= number.last;
            });
            return term.first <= read.first && read.last <= term.last && !isNumber;
        }

        const Flow& flow_;
        int expression_;
        std::size_t at_; ///< is the statement that the term is in
        Cone cone_;
        std::vector<ShaderEdit> edits_;
        std::vector<int> numbers_;
        SlicedTerm made_;
    };

    const ShaderSyntax& syntax_;
    const ParsedFunction& function_;
    Places arguments_;
    std::optional<std::size_t> values_; ///< is the argument that has the block's values
    std::string valuesName_;
    std::vector<BodyStatement> statements_;
    Places written_;
    bool isKnown_ = false;
};

FunctionSlicer::FunctionSlicer(const ShaderSyntax& syntax, std::string parameters)
    : syntax_(syntax), parameters_(std::move(parameters)) {}

FunctionSlicer::~FunctionSlicer() = default;

const FunctionSlicer::Flow& FunctionSlicer::flowOf(int function) {
    std::unique_ptr<Flow>& flow = flows_[function];
    if (flow == nullptr) {
        flow = std::make_unique<Flow>(syntax_, function, parameters_);
    }
    return *flow;
}

std::optional<SlicedTerm> FunctionSlicer::slice(int expression, TermLeaves leaves) {
    const int function = syntax_.expressions[static_cast<std::size_t>(expression)].owner;
    return function < 0 ? std::nullopt : flowOf(function).slice(expression, leaves);
}

} // namespace patina
