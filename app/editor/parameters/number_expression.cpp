// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/number_expression.h"

#include <array>
#include <cctype>
#include <cmath>
#include <numbers>
#include <string>

#include "core/number_text.h"

namespace patina {

namespace {

struct Unit {
    std::string_view name;
    char dimension; ///< units of one dimension convert into each other
    double factor;  ///< size in the dimension's base unit (m, deg)
};

constexpr double degreesPerRadian = 180.0 / std::numbers::pi;

constexpr std::array<Unit, 12> units{{{"nm", 'l', 1e-9},
                                      {"um", 'l', 1e-6},
                                      {"\u00b5m", 'l', 1e-6},
                                      {"mm", 'l', 1e-3},
                                      {"cm", 'l', 1e-2},
                                      {"m", 'l', 1.0},
                                      {"km", 'l', 1e3},
                                      {"deg", 'a', 1.0},
                                      {"\u00b0", 'a', 1.0},
                                      {"rad", 'a', degreesPerRadian},
                                      {"EV", 'e', 1.0},
                                      {"ev", 'e', 1.0}}};

const Unit* unitNamed(std::string_view name) {
    for (const Unit& unit : units) {
        if (unit.name == name) {
            return &unit;
        }
    }
    return nullptr;
}

/// Returns how many `wanted` one `typed` is; nothing when they do not measure the same thing.
std::optional<double> conversion(std::string_view typed, std::string_view wanted) {
    if (typed == wanted) {
        return 1.0;
    }
    if (typed == "%") {
        return 0.01;
    }
    const Unit* from = unitNamed(typed);
    const Unit* to = unitNamed(wanted);
    if (!from || !to || from->dimension != to->dimension) {
        return std::nullopt;
    }
    return from->factor / to->factor;
}

/// Parses sums of products of signed numbers with units, by recursive descent.
class Parser {
  public:
    Parser(std::string_view text, std::string_view unit) : text_(text), unit_(unit) {}

    std::optional<double> parse() {
        const std::optional<double> whole = sum(0);
        skipBlanks();
        const bool good = whole && at_ == text_.size() && std::isfinite(*whole);
        return good ? whole : std::nullopt;
    }

  private:
    static constexpr int deepest = 32; // bounds the recursion into parentheses and signs

    void skipBlanks() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) {
            ++at_;
        }
    }

    bool accept(char wanted) {
        skipBlanks();
        const bool found = at_ < text_.size() && text_[at_] == wanted;
        at_ += found ? 1 : 0;
        return found;
    }

    std::optional<double> sum(int depth) {
        std::optional<double> total = product(depth);
        while (total) {
            const bool plus = accept('+');
            if (!plus && !accept('-')) {
                break;
            }
            const std::optional<double> next = product(depth);
            total = next ? std::optional(plus ? *total + *next : *total - *next) : std::nullopt;
        }
        return total;
    }

    std::optional<double> product(int depth) {
        std::optional<double> total = signedTerm(depth);
        while (total) {
            const bool times = accept('*');
            if (!times && !accept('/')) {
                break;
            }
            const std::optional<double> next = signedTerm(depth);
            total = next ? std::optional(times ? *total * *next : *total / *next) : std::nullopt;
        }
        return total;
    }

    std::optional<double> signedTerm(int depth) {
        if (depth > deepest) {
            return std::nullopt;
        }
        if (accept('-')) {
            const std::optional<double> term = signedTerm(depth + 1);
            return term ? std::optional(-*term) : std::nullopt;
        }
        if (accept('+')) {
            return signedTerm(depth + 1);
        }
        if (accept('(')) {
            const std::optional<double> inside = sum(depth + 1);
            return accept(')') ? withUnit(inside) : std::nullopt;
        }
        return withUnit(number());
    }

    std::optional<double> number() {
        skipBlanks();
        const std::size_t start = at_;
        std::string digits;
        while (at_ < text_.size() && belongsToNumber(start)) {
            digits += text_[at_] == ',' ? '.' : text_[at_];
            ++at_;
        }
        return parseNumber(digits); // two decimal marks do not parse
    }

    /// Tells whether the next character belongs to a number: a digit, a decimal mark, or part of an
    /// exponent with its sign ("1e-3", but not the e of "1 ev").
    bool belongsToNumber(std::size_t start) const {
        const char c = text_[at_];
        if (std::isdigit(static_cast<unsigned char>(c)) || c == '.' || c == ',') {
            return true;
        }
        if (at_ == start) {
            return false;
        }
        const char before = text_[at_ - 1];
        if (c == '+' || c == '-') {
            return before == 'e' || before == 'E';
        }
        const std::string_view rest = text_.substr(at_ + 1);
        const bool isExponent =
            !rest.empty() &&
            (std::isdigit(static_cast<unsigned char>(rest[0])) || rest[0] == '-' || rest[0] == '+');
        return (c == 'e' || c == 'E') && isExponent;
    }

    std::optional<double> withUnit(std::optional<double> value) {
        skipBlanks();
        const std::size_t start = at_;
        while (at_ < text_.size() && belongsToUnit(text_[at_])) {
            ++at_;
        }
        if (!value || start == at_) {
            return value;
        }
        const std::optional<double> factor = conversion(text_.substr(start, at_ - start), unit_);
        return factor ? std::optional(*value * *factor) : std::nullopt;
    }

    static bool belongsToUnit(char c) {
        const auto byte = static_cast<unsigned char>(c);
        return std::isalpha(byte) || c == '%' || byte >= 0x80; // a byte of UTF-8
    }

    std::string_view text_;
    std::string_view unit_;
    std::size_t at_ = 0;
};

} // namespace

std::optional<double> evaluateNumber(std::string_view text, std::string_view unit) {
    return Parser(text, unit).parse();
}

} // namespace patina
