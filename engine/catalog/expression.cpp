// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/expression.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include <fmt/format.h>

#include "core/number_text.h"

namespace patina {
namespace {

constexpr int deepest = 32; ///< limits the levels of parentheses and nots

enum class Operator { Or, And, Not, Truth, Equal, Unequal, Less, LessEqual, Greater, GreaterEqual };

struct Token {
    std::string text; ///< is empty at the end
    std::size_t offset = 0;
    bool quoted = false;

    bool is(std::string_view word) const { return !quoted && text == word; }
};

bool isWord(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '-' ||
           c == '+';
}

/// Splits a text into words, quoted words, and signs of one or two characters.
class Tokens {
  public:
    explicit Tokens(std::string_view text) : text_(text) { advance(); }

    const Token& current() const { return current_; }
    bool atEnd() const { return current_.text.empty() && !current_.quoted; }

    Token take() {
        Token taken = current_;
        advance();
        return taken;
    }

    bool takeIf(std::string_view word) {
        if (!current_.is(word)) {
            return false;
        }
        advance();
        return true;
    }

  private:
    void advance() {
        at_ = std::min(text_.find_first_not_of(" \t", at_), text_.size());
        current_ = {{}, at_, false};
        if (at_ == text_.size()) {
            return;
        }
        if (const char c = text_[at_]; c == '"' || c == '\'') {
            takeQuoted(c);
        } else if (isWord(c)) {
            takeWhile(isWord);
        } else {
            const bool two = at_ + 1 < text_.size() && text_[at_ + 1] == '=';
            takeBytes(two ? 2 : 1);
        }
    }

    void takeBytes(std::size_t count) {
        current_.text = text_.substr(at_, count);
        at_ += count;
    }

    void takeWhile(bool (*belongs)(char)) {
        const auto rest = text_.substr(at_);
        const auto* const end = std::find_if_not(rest.begin(), rest.end(), belongs);
        takeBytes(static_cast<std::size_t>(end - rest.begin()));
    }

    void takeQuoted(char quote) {
        const std::size_t end = text_.find(quote, at_ + 1);
        if (end == std::string_view::npos) {
            return takeBytes(1); // a lone quote is no operand, which the parser says
        }
        current_.text = text_.substr(at_ + 1, end - at_ - 1);
        current_.quoted = true;
        at_ = end + 1;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    Token current_;
};

std::optional<Operator> comparisonOf(const Token& token) {
    using Pair = std::pair<std::string_view, Operator>;
    constexpr std::array<Pair, 6> signs{
        Pair{"==", Operator::Equal}, {"!=", Operator::Unequal}, {"<", Operator::Less},
        {"<=", Operator::LessEqual}, {">", Operator::Greater},  {">=", Operator::GreaterEqual}};
    for (const auto& [sign, meaning] : signs) {
        if (token.is(sign)) {
            return meaning;
        }
    }
    return std::nullopt;
}

bool isOperand(const Token& token) {
    return token.quoted || (!token.text.empty() && isWord(token.text.front()) && !token.is("and") &&
                            !token.is("or") && !token.is("not"));
}

/// Is what an operand stands for: a number (bools are 0 and 1) or a word.
using Meaning = std::variant<double, std::string>;

Meaning meaningOf(const Value& value) {
    if (const auto* flag = std::get_if<bool>(&value)) {
        return *flag ? 1.0 : 0.0;
    }
    if (const auto* whole = std::get_if<int>(&value)) {
        return static_cast<double>(*whole);
    }
    if (const auto* number = std::get_if<double>(&value)) {
        return *number;
    }
    const auto* word = std::get_if<std::string>(&value);
    return word != nullptr ? *word : std::string();
}

Meaning meaningOf(const Token& operand, const Values& values) {
    if (!operand.quoted) {
        if (const auto found = values.find(operand.text); found != values.end()) {
            return meaningOf(found->second);
        }
        if (operand.text == "true" || operand.text == "false") {
            return operand.text == "true" ? 1.0 : 0.0;
        }
        if (const auto number = parseNumber(operand.text)) {
            return *number;
        }
    }
    return operand.text;
}

bool isTrue(const Meaning& meaning) {
    const auto* number = std::get_if<double>(&meaning);
    return number != nullptr ? *number != 0.0 : !std::get<std::string>(meaning).empty();
}

bool holds(double a, double b, Operator sign) {
    switch (sign) {
    case Operator::Less:
        return a < b;
    case Operator::LessEqual:
        return a <= b;
    case Operator::Greater:
        return a > b;
    case Operator::GreaterEqual:
        return a >= b;
    case Operator::Unequal:
        return a != b;
    default:
        return a == b;
    }
}

} // namespace

struct Expression::Node {
    Operator what = Operator::Truth;
    Token left;
    Token right;
    std::shared_ptr<const Node> first;
    std::shared_ptr<const Node> second;

    bool evaluate(const Values& values) const;
    void collect(std::vector<Comparison>& into) const;

    /// Compares the meanings of the two operands; words (an enum value may look like a number) are
    /// compared as text.
    bool compare(const Values& values) const {
        const Meaning a = meaningOf(left, values);
        const Meaning b = meaningOf(right, values);
        const auto* x = std::get_if<double>(&a);
        const auto* y = std::get_if<double>(&b);
        if (x != nullptr && y != nullptr) {
            return holds(*x, *y, what);
        }
        const std::string& wordA = x != nullptr ? left.text : std::get<std::string>(a);
        const std::string& wordB = y != nullptr ? right.text : std::get<std::string>(b);
        return (wordA == wordB) == (what == Operator::Equal) &&
               (what == Operator::Equal || what == Operator::Unequal);
    }

    /// Parses by recursive descent: `or` binds least, then `and`, then `not`.
    struct Parser {
        using Pointer = std::shared_ptr<const Node>;

        Tokens tokens;
        int depth = 0;

        Error unexpected(std::string expected) const {
            const Token& token = tokens.current();
            const std::string found = tokens.atEnd() ? "the expression ends here"
                                                     : fmt::format("'{}' stands here", token.text);
            return {{}, 1, static_cast<int>(token.offset) + 1, found, std::move(expected)};
        }

        Result<Pointer> chain(std::string_view word, Operator joined,
                              Result<Pointer> (Parser::*next)()) {
            Result<Pointer> operand = (this->*next)();
            while (operand && tokens.takeIf(word)) {
                Result<Pointer> other = (this->*next)();
                if (!other) {
                    return other;
                }
                operand = std::make_shared<const Node>(Node{joined, {}, {}, *operand, *other});
            }
            return operand;
        }

        Result<Pointer> disjunction() { return chain("or", Operator::Or, &Parser::conjunction); }
        Result<Pointer> conjunction() { return chain("and", Operator::And, &Parser::negation); }

        Result<Pointer> negation() {
            if (++depth > deepest) {
                return tl::unexpected(unexpected("a simpler expression"));
            }
            Result<Pointer> result = negated();
            --depth;
            return result;
        }

        Result<Pointer> negated() {
            if (tokens.takeIf("not")) {
                return negation().map([](const Pointer& inner) -> Pointer {
                    return std::make_shared<const Node>(Node{Operator::Not, {}, {}, inner, {}});
                });
            }
            return tokens.takeIf("(") ? parenthesised() : comparison();
        }

        Result<Pointer> parenthesised() {
            Result<Pointer> inner = disjunction();
            if (inner && !tokens.takeIf(")")) {
                return tl::unexpected(unexpected("')', 'and' or 'or'"));
            }
            return inner;
        }

        Result<Pointer> comparison() {
            if (!isOperand(tokens.current())) {
                return tl::unexpected(unexpected("a parameter, a number or a choice"));
            }
            Node node;
            node.left = tokens.take();
            if (const auto sign = comparisonOf(tokens.current())) {
                node.what = *sign;
                tokens.take();
                if (!isOperand(tokens.current())) {
                    return tl::unexpected(unexpected("a parameter, a number or a choice"));
                }
                node.right = tokens.take();
            }
            return std::make_shared<const Node>(std::move(node));
        }
    };
};

bool Expression::Node::evaluate(const Values& values) const {
    switch (what) {
    case Operator::Or:
        return first->evaluate(values) || second->evaluate(values);
    case Operator::And:
        return first->evaluate(values) && second->evaluate(values);
    case Operator::Not:
        return !first->evaluate(values);
    case Operator::Truth:
        return isTrue(meaningOf(left, values));
    default:
        return compare(values);
    }
}

void Expression::Node::collect(std::vector<Comparison>& into) const {
    if (first == nullptr) {
        into.push_back({left.text, right.text});
        return;
    }
    first->collect(into);
    if (second != nullptr) {
        second->collect(into);
    }
}

Result<Expression> Expression::parse(std::string_view text) {
    Expression expression;
    Node::Parser parser{Tokens(text)};
    if (parser.tokens.atEnd()) {
        return expression;
    }
    Result<std::shared_ptr<const Node>> root = parser.disjunction();
    if (!root) {
        return tl::unexpected(root.error());
    }
    if (!parser.tokens.atEnd()) {
        return tl::unexpected(parser.unexpected("'and', 'or' or the end"));
    }
    expression.root_ = *root;
    return expression;
}

bool Expression::evaluate(const Values& values) const {
    return root_ == nullptr || root_->evaluate(values);
}

std::vector<Expression::Comparison> Expression::comparisons() const {
    std::vector<Comparison> all;
    if (root_ != nullptr) {
        root_->collect(all);
    }
    return all;
}

} // namespace patina
