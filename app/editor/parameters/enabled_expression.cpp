// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/enabled_expression.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "core/number_text.h"

namespace patina {

namespace {

/// What a term of an expression is: a truth, a number or a word.
using Term = std::variant<bool, double, std::string>;

struct Token {
    enum class Kind { Word, Quoted, Symbol };
    Kind kind = Kind::Symbol;
    std::string text;
};

bool isWordCharacter(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return std::isalnum(byte) || c == '.' || c == '_' || c == '-';
}

/// Reads the token at `text[at]`, which is not a blank, and moves past it.
Token readToken(std::string_view text, std::size_t& at) {
    const std::size_t start = at;
    if (text[at] == '"' || text[at] == '\'') {
        const std::size_t end = std::min(text.find(text[at], at + 1), text.size());
        at = std::min(end + 1, text.size());
        return {Token::Kind::Quoted, std::string(text.substr(start + 1, end - start - 1))};
    }
    if (isWordCharacter(text[at])) {
        while (at < text.size() && isWordCharacter(text[at])) {
            ++at;
        }
        return {Token::Kind::Word, std::string(text.substr(start, at - start))};
    }
    constexpr std::array<std::string_view, 6> pairs{"==", "!=", "<=", ">=", "&&", "||"};
    const bool isPair = std::find(pairs.begin(), pairs.end(), text.substr(at, 2)) != pairs.end();
    at += isPair ? 2 : 1;
    return {Token::Kind::Symbol, std::string(text.substr(start, at - start))};
}

std::vector<Token> readTokens(std::string_view text) {
    std::vector<Token> tokens;
    for (std::size_t at = 0; at < text.size();) {
        if (std::isspace(static_cast<unsigned char>(text[at]))) {
            ++at;
        } else {
            tokens.push_back(readToken(text, at));
        }
    }
    return tokens;
}

Term termOf(const Value& value) {
    if (const bool* truth = std::get_if<bool>(&value)) {
        return *truth;
    }
    if (const int* whole = std::get_if<int>(&value)) {
        return static_cast<double>(*whole);
    }
    if (const double* number = std::get_if<double>(&value)) {
        return *number;
    }
    if (const auto* text = std::get_if<std::string>(&value)) {
        return *text;
    }
    if (const auto* triple = std::get_if<glm::dvec3>(&value)) {
        return std::max({triple->x, triple->y, triple->z}); // a colour counts as its brightest
    }
    const auto& pair = std::get<glm::dvec2>(value);
    return std::max(pair.x, pair.y);
}

bool isTrue(const Term& term) {
    if (const bool* truth = std::get_if<bool>(&term)) {
        return *truth;
    }
    if (const double* number = std::get_if<double>(&term)) {
        return *number != 0.0;
    }
    return !std::get<std::string>(term).empty();
}

template <class T>
bool compared(const T& left, std::string_view sign, const T& right) {
    if (sign == "==") {
        return left == right;
    }
    if (sign == "!=") {
        return left != right;
    }
    if (sign == "<") {
        return left < right;
    }
    if (sign == "<=") {
        return left <= right;
    }
    return sign == ">" ? left > right : left >= right;
}

bool isComparison(std::string_view text) {
    return text == "==" || text == "!=" || text == "<" || text == "<=" || text == ">" ||
           text == ">=";
}

bool compareTerms(const Term& left, std::string_view sign, const Term& right) {
    if (left.index() != right.index()) {
        return sign == "!=";
    }
    return std::visit(
        [&](const auto& held) {
            using Held = std::decay_t<decltype(held)>;
            return compared(held, sign, std::get<Held>(right));
        },
        left);
}

/// Recursive descent, one function per level of precedence.
class Parser {
  public:
    Parser(std::vector<Token> tokens, const ValueLookup& lookup)
        : tokens_(std::move(tokens)), lookup_(lookup) {}

    std::optional<bool> parse() {
        const bool whole = isTrue(disjunction(0));
        return isGood_ && at_ == tokens_.size() ? std::optional<bool>(whole) : std::nullopt;
    }

  private:
    static constexpr int deepest = 32; // far beyond what a descriptor says; bounds the recursion

    bool accept(std::string_view one, std::string_view other = {}) {
        const bool found = at_ < tokens_.size() && tokens_[at_].kind != Token::Kind::Quoted &&
                           (tokens_[at_].text == one || tokens_[at_].text == other);
        at_ += found ? 1 : 0;
        return found;
    }

    Term fail() {
        isGood_ = false;
        at_ = tokens_.size();
        return false;
    }

    Term disjunction(int depth) {
        Term left = conjunction(depth);
        while (accept("or", "||")) {
            const bool right = isTrue(conjunction(depth));
            left = isTrue(left) || right;
        }
        return left;
    }

    Term conjunction(int depth) {
        Term left = negation(depth);
        while (accept("and", "&&")) {
            const bool right = isTrue(negation(depth));
            left = isTrue(left) && right;
        }
        return left;
    }

    Term negation(int depth) {
        if (depth > deepest) {
            return fail();
        }
        if (accept("not", "!")) {
            return !isTrue(negation(depth + 1));
        }
        return comparison(depth);
    }

    Term comparison(int depth) {
        const Term left = primary(depth);
        if (at_ >= tokens_.size() || !isComparison(tokens_[at_].text)) {
            return left;
        }
        const std::string sign = tokens_[at_++].text;
        return compareTerms(left, sign, primary(depth));
    }

    Term primary(int depth) {
        if (accept("(")) {
            const Term inside = disjunction(depth + 1);
            return accept(")") ? inside : fail();
        }
        if (at_ >= tokens_.size() || tokens_[at_].kind == Token::Kind::Symbol) {
            return fail();
        }
        const Token& token = tokens_[at_++];
        return token.kind == Token::Kind::Quoted ? Term(token.text) : word(token.text);
    }

    Term word(const std::string& text) const {
        if (text == "true" || text == "false") {
            return text == "true";
        }
        if (const std::optional<double> number = parseNumber(text)) {
            return *number;
        }
        const std::optional<Value> value = lookup_(text);
        return value ? termOf(*value) : Term(text);
    }

    std::vector<Token> tokens_;
    const ValueLookup& lookup_;
    std::size_t at_ = 0;
    bool isGood_ = true;
};

} // namespace

std::optional<bool> evaluateEnabled(std::string_view expression, const ValueLookup& lookup) {
    return Parser(readTokens(expression), lookup).parse();
}

std::vector<std::string> tokensOf(std::string_view expression) {
    std::vector<std::string> texts;
    for (Token& token : readTokens(expression)) {
        texts.push_back(std::move(token.text));
    }
    return texts;
}

} // namespace patina
