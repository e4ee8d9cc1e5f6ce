// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/interpreter/shader_parser.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "measure/interpreter/shader_builtins.h"
#include "measure/interpreter/shader_lexemes.h"
#include "shading/glsl/text_places.h"
#include "shading/glsl/tokens.h"

namespace patina {
namespace {

using BaseType = ShaderType::Base;
using NodeKind = ShaderExpression::Kind;

/// Limits how deep an expression or a statement may lie in others.
constexpr int maxDepth = 200;

constexpr ShaderType typeOf(BaseType base, int rows = 1, int columns = 1) {
    return {base, rows, columns, -1, 0};
}

const std::map<std::string_view, ShaderType>& namedTypes() {
    static const std::map<std::string_view, ShaderType> types{
        {"void", typeOf(BaseType::Void)},        {"bool", typeOf(BaseType::Bool)},
        {"int", typeOf(BaseType::Int)},          {"float", typeOf(BaseType::Float)},
        {"vec2", typeOf(BaseType::Float, 2)},    {"vec3", typeOf(BaseType::Float, 3)},
        {"vec4", typeOf(BaseType::Float, 4)},    {"ivec2", typeOf(BaseType::Int, 2)},
        {"ivec3", typeOf(BaseType::Int, 3)},     {"ivec4", typeOf(BaseType::Int, 4)},
        {"bvec2", typeOf(BaseType::Bool, 2)},    {"bvec3", typeOf(BaseType::Bool, 3)},
        {"bvec4", typeOf(BaseType::Bool, 4)},    {"mat2", typeOf(BaseType::Float, 2, 2)},
        {"mat3", typeOf(BaseType::Float, 3, 3)}, {"mat4", typeOf(BaseType::Float, 4, 4)}};
    return types;
}

/// Says how strongly the operators between two operands bind; 0 for what is none of them.
int strengthOf(std::string_view sign) {
    static const std::map<std::string_view, int> strengths{
        {"||", 1}, {"^^", 2}, {"&&", 3}, {"==", 4}, {"!=", 4}, {"<", 5}, {">", 5},
        {"<=", 5}, {">=", 5}, {"+", 6},  {"-", 6},  {"*", 7},  {"/", 7}, {"%", 7}};
    const auto found = strengths.find(sign);
    return found == strengths.end() ? 0 : found->second;
}

bool isAssignment(std::string_view sign) {
    return sign == "=" || sign == "+=" || sign == "-=" || sign == "*=" || sign == "/=";
}

class Parser {
  public:
    Parser(const ShaderSource& source, std::vector<ShaderLexeme> lexemes)
        : source_(source), lexemes_(std::move(lexemes)) {
        syntax_.text = source.text;
        lexemes_.push_back({});
        made_.push_back(0);
        for (const ShaderLexeme& lexeme : lexemes_) {
            made_.push_back(made_.back() + (lexeme.isMade ? 1 : 0));
        }
    }

    Result<ShaderSyntax> run(std::string_view root) {
        declareAll();
        const int first = syntax_.functionNamed(root);
        if (first < 0 && !problem_) {
            complain(fmt::format("there is no function {}", root));
        }
        for (wanted_.push_back(first); !wanted_.empty() && !problem_;) {
            const int next = wanted_.back();
            wanted_.pop_back();
            parseBody(next);
        }
        if (problem_) {
            return tl::unexpected(*problem_);
        }
        return std::move(syntax_);
    }

  private:
    // --- lexemes

    const ShaderLexeme& here() const { return lexemes_[std::min(at_, lexemes_.size() - 1)]; }
    std::string_view word(std::size_t ahead = 0) const {
        return lexemes_[std::min(at_ + ahead, lexemes_.size() - 1)].text;
    }
    bool isEnd() const { return at_ + 1 >= lexemes_.size(); }

    bool take(std::string_view text) {
        const bool isIt = !problem_ && word() == text && !isEnd();
        at_ += isIt ? 1 : 0;
        return isIt;
    }

    void expect(std::string_view text) {
        if (!take(text)) {
            complain(
                fmt::format("{} stands where {} is expected", isEnd() ? "the end" : word(), text));
        }
    }

    void complain(std::string problem) {
        if (problem_) {
            return;
        }
        // The last lexeme is the end, which stands nowhere.
        const std::size_t place =
            isEnd() && at_ > 0 ? lexemes_[lexemes_.size() - 2].first : here().first;
        problem_ = errorAt(source_, place, std::move(problem));
        at_ = lexemes_.size() - 1;
    }

    /// Moves behind the bracket that closes the one at the current place.
    void skipBrackets() {
        const std::size_t first = at_;
        std::string closing; // those that close what is open
        do {
            const std::string_view text = word();
            if (text == "(" || text == "{" || text == "[") {
                closing += text == "(" ? ')' : text == "{" ? '}' : ']';
            } else if (!closing.empty() && (text == ")" || text == "}" || text == "]")) {
                if (closing.back() != text.front()) {
                    return expect(closing.substr(closing.size() - 1));
                }
                closing.pop_back();
            }
            ++at_;
        } while (!closing.empty() && !isEnd());
        if (!closing.empty()) {
            at_ = first;
            complain(fmt::format("{} is not closed", word()));
        }
    }

    // --- types and declarations

    std::optional<ShaderType> typeNamed(std::string_view name) const {
        if (const auto found = namedTypes().find(name); found != namedTypes().end()) {
            return found->second;
        }
        for (std::size_t i = 0; i < syntax_.structs.size(); ++i) {
            if (syntax_.structs[i].name == name) {
                return ShaderType{BaseType::Struct, 1, 1, static_cast<int>(i), 0};
            }
        }
        return std::nullopt;
    }

    std::size_t sizeOf(const ShaderType& type) const {
        const std::size_t one =
            type.base == BaseType::Struct
                ? syntax_.structs[static_cast<std::size_t>(type.structure)].size
                : static_cast<std::size_t>(type.rows) * static_cast<std::size_t>(type.columns);
        return one * static_cast<std::size_t>(std::max(type.length, 1));
    }

    void skipQualifiers() {
        while (isQualifier(word()) || word() == "inout" || word() == "out" || word() == "flat") {
            ++at_;
        }
    }

    /// Reads "[8]" behind a name or a type, if there is one; "[]" only where `isOpen`.
    void readLength(ShaderType& type, bool isOpen = false) {
        if (!take("[") || (isOpen && take("]"))) {
            return;
        }
        int length = 0;
        std::from_chars(word().data(), word().data() + word().size(), length);
        ++at_;
        expect("]");
        if (length < 1 || length > 4096) {
            complain("an array needs a length that is a number");
        }
        type.length = std::max(length, 1);
    }

    /// Reads everything outside of functions, and where functions are.
    void declareAll() {
        while (!isEnd() && !problem_) {
            const std::size_t start = at_;
            if (word() == "struct") {
                readStruct();
            } else if (word() == "layout" || word() == "uniform") {
                skipDeclaration();
            } else if (word() == "const") {
                readConstant();
            } else if (!readFunction()) {
                at_ = start;
                skipDeclaration();
            }
            if (at_ == start) {
                ++at_;
            }
        }
    }

    /// Skips a declaration that no function of interest reads.
    void skipDeclaration() {
        while (!isEnd() && word() != ";") {
            if (word() == "(" || word() == "{" || word() == "[") {
                skipBrackets();
            } else {
                ++at_;
            }
        }
        ++at_;
    }

    void readStruct() {
        ShaderStruct made;
        ++at_;
        made.name = word();
        ++at_;
        expect("{");
        while (!take("}") && !problem_) {
            skipQualifiers();
            const auto type = typeNamed(word());
            if (!type) {
                complain(fmt::format("{} is no type that is known here", word()));
                break;
            }
            ++at_;
            do {
                ShaderVariable field{*type, word(), made.size, 0, false};
                ++at_;
                readLength(field.type);
                field.size = sizeOf(field.type);
                made.size += field.size;
                made.fields.push_back(field);
            } while (take(","));
            expect(";");
        }
        expect(";");
        syntax_.structs.push_back(std::move(made));
    }

    void readConstant() {
        ++at_;
        skipQualifiers();
        auto type = typeNamed(word());
        if (!type) {
            skipDeclaration();
            return;
        }
        ++at_;
        readLength(*type);
        const std::string_view name = word();
        ++at_;
        readLength(*type);
        if (!take("=")) {
            skipDeclaration();
            return;
        }
        owner_ = -1;
        const int value = expression();
        if (problem_) {
            return;
        }
        const std::size_t size = sizeOf(*type);
        syntax_.constants.push_back({name, *type, syntax_.constantNumbers, size, value});
        syntax_.constantNumbers += size;
        expect(";");
    }

    /// Reads "type name(arguments) {...}" or a declaration without a body.
    bool readFunction() {
        const std::size_t start = at_;
        skipQualifiers();
        const auto type = typeNamed(word());
        if (!type || word(2) != "(") {
            return false;
        }
        ParsedFunction made;
        made.result = *type;
        made.resultSize = sizeOf(*type);
        made.name = word(1);
        made.file = here().file;
        made.first = lexemes_[start].first;
        at_ += 2;
        const std::size_t open = at_;
        skipBrackets();
        const std::size_t behind = at_;
        if (take(";")) {
            return true;
        }
        if (word() != "{") {
            return false;
        }
        const std::size_t body = at_;
        skipBrackets();
        const std::size_t end = at_;
        made.last = lexemes_[end - 1].last;
        at_ = open + 1;
        const bool isKnown = readArguments(made);
        at_ = end;
        if (isKnown) {
            bodies_.push_back(body);
            syntax_.functions.push_back(std::move(made));
        }
        static_cast<void>(behind);
        return true;
    }

    bool readArguments(ParsedFunction& function) {
        while (!take(")")) {
            bool isOut = false;
            while (isQualifier(word()) || word() == "inout" || word() == "out") {
                isOut = isOut || word() == "inout" || word() == "out";
                ++at_;
            }
            if (word() == "void" && word(1) == ")") {
                ++at_;
                continue;
            }
            const auto type = typeNamed(word());
            if (!type) {
                return false;
            }
            ++at_;
            ShaderVariable argument{*type, {}, function.frame, 0, isOut};
            if (word() != "," && word() != ")") {
                argument.name = word();
                ++at_;
                readLength(argument.type);
            }
            argument.size = sizeOf(argument.type);
            function.frame += argument.size;
            function.arguments.push_back(argument);
            take(",");
            if (isEnd() || problem_) {
                return false;
            }
        }
        return true;
    }

    // --- statements

    void parseBody(int index) {
        const auto place = static_cast<std::size_t>(index);
        if (!parsed_.insert(index).second) {
            return;
        }
        at_ = bodies_[place];
        owner_ = index;
        scopes_ = {{}};
        for (const ShaderVariable& argument : syntax_.functions[place].arguments) {
            scopes_.back().push_back(argument);
        }
        const int body = statement();
        syntax_.functions[place].body = body;
    }

    int add(ShaderStatement statement) {
        syntax_.statements.push_back(std::move(statement));
        return static_cast<int>(syntax_.statements.size()) - 1;
    }

    int statement() {
        if (++depth_ > maxDepth) {
            complain("statements lie too deep in each other");
        }
        const std::size_t start = at_;
        const int made = problem_ ? -1 : anyStatement();
        if (!problem_) {
            auto& whole = syntax_.statements[static_cast<std::size_t>(made)];
            whole.first = lexemes_[start].first;
            whole.last = lexemes_[at_ - 1].last;
        }
        --depth_;
        return made;
    }

    int anyStatement() {
        if (take("{")) {
            return group();
        }
        if (take("if")) {
            return branch();
        }
        if (take("for")) {
            return forLoop();
        }
        if (take("while")) {
            ShaderStatement loop{.kind = ShaderStatement::Kind::Loop};
            expect("(");
            loop.expression = expression();
            expect(")");
            loop.statements = {statement()};
            return add(std::move(loop));
        }
        if (take("return")) {
            ShaderStatement made{.kind = ShaderStatement::Kind::Return};
            made.expression = word() == ";" ? -1 : expression();
            expect(";");
            return add(std::move(made));
        }
        if (take("break")) {
            expect(";");
            return add({.kind = ShaderStatement::Kind::Break});
        }
        if (take("continue")) {
            expect(";");
            return add({.kind = ShaderStatement::Kind::Continue});
        }
        return simpleStatement();
    }

    int group() {
        ShaderStatement made{.isBlock = true};
        scopes_.emplace_back();
        while (!take("}") && !problem_) {
            const int next = statement();
            made.statements.push_back(next);
        }
        scopes_.pop_back();
        return add(std::move(made));
    }

    int branch() {
        ShaderStatement made{.kind = ShaderStatement::Kind::If};
        expect("(");
        made.expression = expression();
        expect(")");
        made.statements.push_back(scoped());
        if (take("else")) {
            made.statements.push_back(scoped());
        }
        return add(std::move(made));
    }

    int scoped() {
        scopes_.emplace_back();
        const int made = statement();
        scopes_.pop_back();
        return made;
    }

    int forLoop() {
        scopes_.emplace_back();
        expect("(");
        ShaderStatement whole;
        whole.statements.push_back(simpleStatement());
        ShaderStatement loop{.kind = ShaderStatement::Kind::Loop};
        loop.expression = word() == ";" ? -1 : expression();
        expect(";");
        loop.step = word() == ")" ? -1 : expression();
        expect(")");
        loop.statements = {statement()};
        whole.statements.push_back(add(std::move(loop)));
        scopes_.pop_back();
        return add(std::move(whole));
    }

    /// Reads an expression or a declaration, up to its semicolon.
    int simpleStatement() {
        if (take(";")) {
            return add({});
        }
        const bool isConstant = take("const");
        skipQualifiers();
        const auto type = typeNamed(word());
        if (type && (isConstant || word(1) != "(")) {
            ++at_;
            return declaration(*type);
        }
        ShaderStatement made{.kind = ShaderStatement::Kind::Expression};
        made.expression = expression();
        expect(";");
        return add(std::move(made));
    }

    int declaration(ShaderType type) {
        ShaderStatement whole;
        readLength(type);
        do {
            auto& function = syntax_.functions[static_cast<std::size_t>(owner_)];
            ShaderVariable made{type, word(), function.frame, 0, false};
            ++at_;
            readLength(made.type);
            made.size = sizeOf(made.type);
            function.frame += made.size;
            whole.declares.push_back(made.place);
            const ShaderLexeme name = lexemes_[at_ - 1];
            if (take("=")) {
                const int value = expression();
                if (problem_) {
                    return -1;
                }
                scopes_.back().push_back(made);
                ShaderExpression target{
                    .kind = NodeKind::Local, .type = made.type, .size = made.size};
                target.sign = made.name;
                target.place = made.place;
                target.owner = owner_;
                target.first = target.last = name.first;
                ShaderExpression assign{
                    .kind = NodeKind::Assign, .type = made.type, .size = made.size};
                assign.sign = "=";
                assign.operands = {addExpression(std::move(target)), value};
                assign.owner = owner_;
                assign.first = assign.last = name.first;
                const int index = addExpression(std::move(assign));
                whole.statements.push_back(
                    add({.kind = ShaderStatement::Kind::Expression, .expression = index}));
            } else {
                scopes_.back().push_back(made);
            }
        } while (take(","));
        expect(";");
        return add(std::move(whole));
    }

    // --- expressions

    int addExpression(ShaderExpression expression) {
        syntax_.expressions.push_back(std::move(expression));
        return static_cast<int>(syntax_.expressions.size()) - 1;
    }

    ShaderExpression& at(int index) { return syntax_.expressions[static_cast<std::size_t>(index)]; }

    /// Finishes an expression whose lexemes begin at `start` and end before the current one.
    int finish(ShaderExpression made, std::size_t start) {
        if (problem_) {
            return -1;
        }
        made.size = sizeOf(made.type);
        made.owner = owner_;
        const bool isMade = made_[at_] > made_[start];
        made.first = lexemes_[start].first;
        made.last = isMade ? made.first : lexemes_[at_ - 1].last;
        return addExpression(std::move(made));
    }

    int expression() {
        if (++depth_ > maxDepth) {
            complain("expressions lie too deep in each other");
        }
        const int made = problem_ ? -1 : assignment();
        --depth_;
        return made;
    }

    int assignment() {
        const std::size_t start = at_;
        const int target = choice();
        if (problem_ || !isAssignment(word())) {
            return target;
        }
        ShaderExpression made{.kind = NodeKind::Assign};
        made.sign = word();
        ++at_;
        const int value = expression();
        if (problem_) {
            return -1;
        }
        made.type = at(target).type;
        made.operands = {target, value};
        return finish(std::move(made), start);
    }

    int choice() {
        const std::size_t start = at_;
        const int condition = binary(1);
        if (problem_ || !take("?")) {
            return condition;
        }
        const int yes = expression();
        expect(":");
        const int no = problem_ ? -1 : expression();
        if (problem_) {
            return -1;
        }
        ShaderExpression made{.kind = NodeKind::Choice};
        made.type = at(yes).type;
        if (at(no).type.base == BaseType::Float) {
            made.type = at(no).type;
        }
        made.operands = {condition, yes, no};
        return finish(std::move(made), start);
    }

    int binary(int minStrength) {
        const std::size_t start = at_;
        int left = unary();
        while (!problem_ && strengthOf(word()) >= minStrength) {
            const std::string_view sign = word();
            ++at_;
            const int right = binary(strengthOf(sign) + 1);
            if (problem_) {
                return -1;
            }
            ShaderExpression made{.kind = NodeKind::Binary};
            made.sign = sign;
            made.type = resultOf(sign, at(left).type, at(right).type);
            made.operands = {left, right};
            left = finish(std::move(made), start);
        }
        return left;
    }

    ShaderType resultOf(std::string_view sign, const ShaderType& a, const ShaderType& b) {
        const int strength = strengthOf(sign);
        if (strength <= 5) {
            return typeOf(BaseType::Bool);
        }
        if (a.base == BaseType::Struct || b.base == BaseType::Struct || a.length > 0 ||
            b.length > 0 || a.base == BaseType::Bool || b.base == BaseType::Bool) {
            complain(fmt::format("{} has no meaning between these", sign));
        }
        const BaseType base =
            a.base == BaseType::Int && b.base == BaseType::Int ? BaseType::Int : BaseType::Float;
        if (sign == "*" && a.columns > 1 && b.columns == 1 && b.rows > 1) {
            return typeOf(base, a.rows);
        }
        if (sign == "*" && b.columns > 1 && a.columns == 1 && a.rows > 1) {
            return typeOf(base, b.columns);
        }
        const bool isFirst = a.rows * a.columns >= b.rows * b.columns;
        const bool fits =
            a.isScalar() || b.isScalar() || (a.rows == b.rows && a.columns == b.columns);
        if (!fits) {
            complain(fmt::format("{} has operands of different sizes", sign));
        }
        return isFirst ? typeOf(base, a.rows, a.columns) : typeOf(base, b.rows, b.columns);
    }

    int unary() {
        const std::size_t start = at_;
        const std::string_view sign = word();
        if (sign == "-" || sign == "!" || sign == "+") {
            if (++depth_ > maxDepth) {
                complain("expressions lie too deep in each other");
            }
            ++at_;
            const int operand = problem_ ? -1 : unary();
            --depth_;
            if (problem_) {
                return -1;
            }
            ShaderExpression made{.kind = NodeKind::Unary};
            made.sign = sign;
            made.type = sign == "!" ? typeOf(BaseType::Bool) : at(operand).type;
            made.operands = {operand};
            return finish(std::move(made), start);
        }
        if (sign == "++" || sign == "--") {
            ++at_;
            const int operand = unary();
            return problem_ ? -1 : step(operand, sign, true, start);
        }
        return postfix();
    }

    int step(int operand, std::string_view sign, bool isPrefix, std::size_t start) {
        ShaderExpression made{.kind = NodeKind::Step};
        made.sign = sign;
        made.type = at(operand).type;
        made.operands = {operand};
        made.isPrefix = isPrefix;
        return finish(std::move(made), start);
    }

    int postfix() {
        const std::size_t start = at_;
        int made = primary();
        while (!problem_) {
            if (take(".")) {
                made = member(made, start);
            } else if (take("[")) {
                made = element(made, start);
            } else if (word() == "++" || word() == "--") {
                const std::string_view sign = word();
                ++at_;
                made = step(made, sign, false, start);
            } else {
                return made;
            }
        }
        return -1;
    }

    int member(int of, std::size_t start) {
        const ShaderType type = at(of).type;
        ShaderExpression made{.kind = NodeKind::Field};
        made.sign = word();
        made.operands = {of};
        if (type.base == BaseType::Struct && type.length == 0) {
            const auto& fields = syntax_.structs[static_cast<std::size_t>(type.structure)].fields;
            const auto found = std::ranges::find(fields, word(), &ShaderVariable::name);
            if (found == fields.end()) {
                complain(fmt::format("there is no field {}", word()));
                return -1;
            }
            made.type = found->type;
            made.place = found->place;
        } else {
            made.kind = NodeKind::Swizzle;
            const auto places = swizzle(word(), type);
            if (places.empty() || places.size() > 4) {
                complain(fmt::format("there is no component {}", word()));
                return -1;
            }
            std::ranges::copy(places, made.components.begin());
            made.type = typeOf(type.base, static_cast<int>(places.size()));
        }
        ++at_;
        return finish(std::move(made), start);
    }

    static std::vector<int> swizzle(std::string_view names, const ShaderType& type) {
        std::vector<int> places;
        for (const char name : names) {
            std::size_t found = std::string_view::npos;
            for (const std::string_view set : {"xyzw", "rgba", "stpq"}) {
                found = found == std::string_view::npos ? set.find(name) : found;
            }
            if (found >= static_cast<std::size_t>(type.rows) || type.columns > 1 ||
                type.length > 0) {
                return {};
            }
            places.push_back(static_cast<int>(found));
        }
        return places;
    }

    int element(int of, std::size_t start) {
        const int index = expression();
        expect("]");
        if (problem_) {
            return -1;
        }
        ShaderExpression made{.kind = NodeKind::Index};
        made.type = at(of).type;
        if (made.type.length > 0) {
            made.type.length = 0;
        } else if (made.type.columns > 1) {
            made.type.columns = 1;
        } else if (made.type.rows > 1) {
            made.type.rows = 1;
        } else {
            complain("[ ] stands behind what has no elements");
        }
        made.operands = {of, index};
        return finish(std::move(made), start);
    }

    int primary() {
        const std::size_t start = at_;
        if (take("(")) {
            const int inside = expression();
            expect(")");
            if (problem_) {
                return -1;
            }
            // The parentheses count as part of what they hold, so that it can be replaced whole.
            const bool isMade = made_[at_] > made_[start];
            if (!isMade && at(inside).last > at(inside).first) {
                at(inside).first = lexemes_[start].first;
                at(inside).last = lexemes_[at_ - 1].last;
            }
            return inside;
        }
        if (here().isNumber) {
            return literal();
        }
        if (word() == "true" || word() == "false") {
            ShaderExpression made{.kind = NodeKind::Literal, .type = typeOf(BaseType::Bool)};
            made.number = word() == "true" ? 1.0 : 0.0;
            ++at_;
            return finish(std::move(made), start);
        }
        if (word(1) == "(") {
            return call();
        }
        return word(1) == "[" && typeNamed(word()) ? arrayOf() : variable();
    }

    /// Reads "float[3](a, b, c)", whose length may be left out.
    int arrayOf() {
        const std::size_t start = at_;
        ShaderExpression made{.kind = NodeKind::Construct, .type = *typeNamed(word())};
        made.sign = word();
        ++at_;
        readLength(made.type, true);
        expect("(");
        made.operands = arguments();
        made.type.length = made.type.length > 0
                               ? made.type.length
                               : std::max(static_cast<int>(made.operands.size()), 1);
        if (problem_) {
            return -1;
        }
        checkConstructor(made);
        return finish(std::move(made), start);
    }

    /// Reads the arguments of a call, and its end.
    std::vector<int> arguments() {
        std::vector<int> all;
        while (!take(")") && !problem_) {
            all.push_back(expression());
            if (!take(",") && word() != ")") {
                complain(fmt::format("{} stands where , or ) is expected", word()));
            }
        }
        return all;
    }

    int literal() {
        const std::size_t start = at_;
        const std::string_view text = word();
        ShaderExpression made{.kind = NodeKind::Literal};
        const bool isFloat = text.find_first_of(".eE") != std::string_view::npos;
        if (text.find_first_of("uUxX") != std::string_view::npos) {
            complain(fmt::format("{} is an unsigned number, which is not evaluated", text));
        }
        made.type = typeOf(isFloat ? BaseType::Float : BaseType::Int);
        std::from_chars(text.data(), text.data() + text.size(), made.number);
        ++at_;
        return finish(std::move(made), start);
    }

    int variable() {
        const std::size_t start = at_;
        const std::string_view name = word();
        for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope) {
            for (auto it = scope->rbegin(); it != scope->rend() && owner_ >= 0; ++it) {
                if (it->name == name) {
                    ShaderExpression made{.kind = NodeKind::Local, .type = it->type};
                    made.sign = name;
                    made.place = it->place;
                    ++at_;
                    return finish(std::move(made), start);
                }
            }
        }
        const auto found = std::ranges::find(syntax_.constants, name, &ShaderConstant::name);
        if (found == syntax_.constants.end()) {
            complain(fmt::format("\"{}\" is nothing that can be evaluated", name));
            return -1;
        }
        ShaderExpression made{.kind = NodeKind::Global, .type = found->type};
        made.sign = name;
        made.place = found->place;
        ++at_;
        return finish(std::move(made), start);
    }

    int call() {
        const std::size_t start = at_;
        const std::string_view name = word();
        at_ += 2;
        const std::vector<int> arguments = this->arguments();
        if (problem_) {
            return -1;
        }
        ShaderExpression made;
        made.sign = name;
        made.operands = arguments;
        if (const auto type = typeNamed(name)) {
            made.kind = NodeKind::Construct;
            made.type = *type;
            checkConstructor(made);
        } else if (const int function = overload(name, arguments); function >= 0) {
            made.kind = NodeKind::Call;
            made.function = function;
            made.type = syntax_.functions[static_cast<std::size_t>(function)].result;
            if (owner_ >= 0) {
                auto& calls = syntax_.functions[static_cast<std::size_t>(owner_)].calls;
                if (std::ranges::find(calls, function) == calls.end()) {
                    calls.push_back(function);
                }
            }
            wanted_.push_back(function);
        } else if (const auto* builtin = findShaderBuiltin(name, arguments.size())) {
            made.kind = NodeKind::Builtin;
            made.builtin = builtin;
            made.type = resultOf(*builtin, arguments);
        } else {
            complain(fmt::format("{}() cannot be evaluated", name));
        }
        return finish(std::move(made), start);
    }

    void checkConstructor(const ShaderExpression& made) {
        std::size_t given = 0;
        for (const int argument : made.operands) {
            given += at(argument).size;
        }
        const bool isDiagonal = made.type.columns > 1 && given == 1;
        const bool spreads = given == 1 && made.type.base != BaseType::Struct;
        if (given < sizeOf(made.type) && !isDiagonal && !spreads) {
            complain(fmt::format("{}() has too few numbers", made.sign));
        }
    }

    ShaderType resultOf(const ShaderBuiltin& builtin, const std::vector<int>& arguments) {
        using Form = ShaderBuiltin::Form;
        ShaderType largest = arguments.empty() ? ShaderType() : at(arguments.front()).type;
        for (const int argument : arguments) {
            const ShaderType& type = at(argument).type;
            if (type.base == BaseType::Struct || type.length > 0 || type.base == BaseType::Void ||
                type.columns > 1) {
                complain(fmt::format("{}() cannot be evaluated on these", builtin.name));
            }
            if (type.rows > largest.rows) {
                largest.rows = type.rows;
            }
            if (type.base == BaseType::Float) {
                largest.base = BaseType::Float;
            }
        }
        switch (builtin.form) {
        case Form::Length:
        case Form::Dot:
        case Form::Distance:
            return typeOf(BaseType::Float);
        case Form::Any:
        case Form::All:
            return typeOf(BaseType::Bool);
        case Form::Compared:
        case Form::Inverted:
            largest.base = BaseType::Bool;
            return largest;
        case Form::CaseData:
            return typeOf(BaseType::Float, 4);
        default:
            return largest;
        }
    }

    /// Returns the function of that name that takes these arguments; -1 where there is none.
    int overload(std::string_view name, const std::vector<int>& arguments) {
        if (name == "caseData") {
            return -1;
        }
        for (const bool converts : {false, true}) {
            for (std::size_t i = 0; i < syntax_.functions.size(); ++i) {
                const ParsedFunction& function = syntax_.functions[i];
                bool fits = function.name == name && function.arguments.size() == arguments.size();
                for (std::size_t k = 0; fits && k < arguments.size(); ++k) {
                    ShaderType given = at(arguments[k]).type;
                    if (converts && given.base == BaseType::Int) {
                        given.base = BaseType::Float;
                    }
                    fits = given == function.arguments[k].type;
                }
                if (fits) {
                    return static_cast<int>(i);
                }
            }
        }
        return -1;
    }

    const ShaderSource& source_;
    std::vector<ShaderLexeme> lexemes_;
    std::vector<int> made_; ///< counts, before each lexeme, those that macros made
    ShaderSyntax syntax_;
    std::vector<std::size_t> bodies_; ///< are the lexemes where functions' bodies begin
    std::vector<int> wanted_;
    std::set<int> parsed_;
    std::vector<std::vector<ShaderVariable>> scopes_;
    std::size_t at_ = 0;
    int owner_ = -1;
    int depth_ = 0;
    std::optional<Error> problem_;
};

} // namespace

int ShaderSyntax::functionNamed(std::string_view name) const {
    const auto found = std::ranges::find(functions, name, &ParsedFunction::name);
    return found == functions.end() ? -1 : static_cast<int>(found - functions.begin());
}

Result<ShaderSyntax> parsedShader(const ShaderSource& source, std::string_view root) {
    auto lexemes = shaderLexemes(source);
    if (!lexemes) {
        return tl::unexpected(lexemes.error());
    }
    return Parser(source, std::move(*lexemes)).run(root);
}

} // namespace patina
