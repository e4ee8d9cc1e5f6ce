// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/prediction/varying_loops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

#include "measure/eval/eval_source.h"
#include "measure/interpreter/shader_evaluator.h"
#include "measure/interpreter/shader_parser.h"
#include "measure/stability/edge_case_directions.h"
#include "measure/stability/sweep_cases.h"
#include "shading/glsl/glsl_declarations.h"

namespace patina {
namespace {

constexpr std::size_t pairsOfDirections = 256;
constexpr const char* evaluatedFunction = "evaluated";

/// Counts how often a loop was begun, and its rounds.
struct LoopTally {
    double runs = 0.0;
    double rounds = 0.0;
};

/// Evaluates a model's text at places, and counts the rounds of its loops.
class RoundsCounter {
  public:
    RoundsCounter(const ShaderSource& source, const ShaderSyntax& syntax)
        : source_(source), syntax_(syntax), evaluator_(syntax, ShaderPrecision::Double) {
        evaluator_.observe(&seen_);
        for (const ShaderStatement& statement : syntax.statements) {
            if (statement.kind == ShaderStatement::Kind::Loop && statement.expression >= 0 &&
                statement.step >= 0) {
                loops_.push_back({&statement, {}, {}, readsField(statement.expression)});
            }
        }
    }

    bool hasLoops() const { return !loops_.empty(); }

    void count(const EvalCase& request) {
        const std::vector<float> place = placeTexels(request);
        const std::vector<float> values = valueTexels(request);
        std::vector<double> texels(place.begin(), place.end());
        texels.insert(texels.end(), values.begin(), values.end());
        const double part = 0.0;
        std::array<double, 3> ignored{};
        evaluator_.call(syntax_.functionNamed(evaluatedFunction), {&part, 1}, texels, ignored);
        for (Counted& loop : loops_) {
            const LoopTally all = tallyOf(*loop.statement);
            const LoopTally now{all.runs - loop.all.runs, all.rounds - loop.all.rounds};
            if (now.runs > 0.0) {
                loop.isVarying = loop.isVarying ||
                                 (loop.first.runs > 0.0 &&
                                  now.rounds * loop.first.runs != loop.first.rounds * now.runs);
                loop.first = loop.first.runs > 0.0 ? loop.first : now;
            }
            loop.all = all;
        }
    }

    std::vector<VaryingLoop> found() const {
        std::vector<VaryingLoop> found;
        for (const Counted& loop : loops_) {
            const bool isVarying = loop.isVarying && hasText(loop);
            if (isVarying || isAroundVarying(loop)) {
                const ShaderExpression& condition = expression(loop.statement->expression);
                const ParsedFunction& function = functionAt(condition.owner);
                found.push_back({std::string(function.name), loopsBefore(function, condition.first),
                                 loop.all.rounds / loop.all.runs, isVarying});
            }
        }
        return found;
    }

  private:
    struct Counted {
        const ShaderStatement* statement;
        LoopTally all;
        LoopTally first;        ///< is of the first case that ran it
        bool isVarying = false; ///< or of values, which the compiler does not know either
    };

    const ShaderExpression& expression(int index) const {
        return syntax_.expressions[static_cast<std::size_t>(index)];
    }
    const ParsedFunction& functionAt(int index) const {
        return syntax_.functions[static_cast<std::size_t>(index)];
    }

    /// Tells whether an expression reads a field, as a block's value is one: a compiler does not
    /// know it, even where it is the same in all cases.
    bool readsField(int index) const {
        const ShaderExpression& each = expression(index);
        return each.kind == ShaderExpression::Kind::Field ||
               std::ranges::any_of(each.operands,
                                   [this](int operand) { return readsField(operand); });
    }

    bool hasText(const Counted& loop) const {
        const ShaderExpression& condition = expression(loop.statement->expression);
        return condition.owner >= 0 && condition.first < condition.last && loop.all.runs > 0.0;
    }

    /// Tells whether a loop that always has the same few rounds holds one that varies, or calls a
    /// function that does.
    bool isAroundVarying(const Counted& loop) const {
        constexpr double maxRounds = 16.0;
        const double rounds = hasText(loop) ? loop.all.rounds / loop.all.runs : 0.0;
        return !loop.isVarying && rounds >= 1.0 && rounds <= maxRounds &&
               rounds == std::floor(rounds) && holdsVarying(loop.statement->statements.front());
    }

    bool holdsVarying(int index) const {
        const ShaderStatement& each = syntax_.statements[static_cast<std::size_t>(index)];
        return std::ranges::any_of(loops_,
                                   [&each](const Counted& loop) {
                                       return loop.isVarying && loop.statement == &each;
                                   }) ||
               callsVarying(each.expression) || callsVarying(each.step) ||
               std::ranges::any_of(each.statements,
                                   [this](int inner) { return holdsVarying(inner); });
    }

    bool callsVarying(int index) const {
        if (index < 0) {
            return false;
        }
        const ShaderExpression& each = expression(index);
        return (each.kind == ShaderExpression::Kind::Call &&
                holdsVarying(functionAt(each.function).body)) ||
               std::ranges::any_of(each.operands,
                                   [this](int operand) { return callsVarying(operand); });
    }

    /// The step is evaluated once in each round, the condition once more in each run.
    LoopTally tallyOf(const ShaderStatement& loop) const {
        const auto times = [this](int index) {
            return static_cast<double>(seen_[static_cast<std::size_t>(index)].count);
        };
        return {times(loop.expression) - times(loop.step), times(loop.step)};
    }

    std::size_t loopsBefore(const ParsedFunction& function, std::size_t offset) const {
        const std::string code =
            withoutComments(source_.text.substr(function.first, offset - function.first));
        const auto loops = std::ranges::count(glslTokens(code), "for", &GlslToken::text);
        return loops > 0 ? static_cast<std::size_t>(loops - 1) : 0;
    }

    const ShaderSource& source_;
    const ShaderSyntax& syntax_;
    ShaderEvaluator evaluator_;
    std::vector<ObservedValues> seen_;
    std::vector<Counted> loops_;
};

/// Is the text of one `for` in a stage: offsets of its parts.
struct ForText {
    std::size_t first = 0; ///< is the keyword
    std::size_t last = 0;  ///< is behind the body
    std::string begin;
    std::string step;
    std::string body;
};

/// Finds a loop of a function in a text without comments.
class ForFinder {
  public:
    explicit ForFinder(const std::string& code) : code_(code), tokens_(glslTokens(code)) {}

    std::optional<ForText> find(const VaryingLoop& loop) const {
        for (const GlslFunction& function : functionsIn(tokens_)) {
            if (function.name.text == loop.function) {
                return forIn(indexOf(function.name), loop.place);
            }
        }
        return std::nullopt;
    }

  private:
    std::size_t offset(std::size_t token) const {
        return static_cast<std::size_t>(tokens_[token].text.data() - code_.data());
    }
    std::size_t indexOf(const GlslToken& token) const {
        return static_cast<std::size_t>(
            std::ranges::find(tokens_, token.text.data(),
                              [](const GlslToken& each) { return each.text.data(); }) -
            tokens_.begin());
    }
    bool is(std::size_t token, std::string_view text) const {
        return token < tokens_.size() && tokens_[token].text == text;
    }

    /// Returns the token that closes what a token opens; the number of tokens where none does.
    std::size_t closing(std::size_t token, std::string_view open, std::string_view close) const {
        for (int depth = 0; token < tokens_.size(); ++token) {
            depth += is(token, open) ? 1 : is(token, close) ? -1 : 0;
            if (depth == 0) {
                break;
            }
        }
        return token;
    }

    std::size_t next(std::size_t token, std::string_view text) const {
        while (token < tokens_.size() && !is(token, text)) {
            ++token;
        }
        return token;
    }

    std::string between(std::size_t first, std::size_t last) const {
        return code_.substr(offset(first), offset(last) - offset(first));
    }

    std::optional<ForText> forIn(std::size_t name, std::size_t place) const {
        const std::size_t end = closing(next(name, "{"), "{", "}");
        std::size_t token = next(name, "for");
        for (; place > 0; --place) {
            token = next(token + 1, "for");
        }
        const std::size_t header = token + 1;
        if (end >= tokens_.size() || token > end || !is(header, "(")) {
            return std::nullopt;
        }
        const std::size_t close = closing(header, "(", ")");
        const std::size_t condition = next(header, ";");
        const std::size_t step = next(condition + 1, ";");
        const std::size_t body = close + 1;
        const std::size_t last = is(body, "{") ? closing(body, "{", "}") : next(body, ";");
        if (step >= close || last >= end || hasJump(body, last)) {
            return std::nullopt;
        }
        return ForText{offset(token), offset(last) + 1, between(header + 1, condition),
                       between(step + 1, close),
                       code_.substr(offset(body), offset(last) + 1 - offset(body))};
    }

    bool hasJump(std::size_t first, std::size_t last) const {
        return std::any_of(tokens_.begin() + static_cast<std::ptrdiff_t>(first),
                           tokens_.begin() + static_cast<std::ptrdiff_t>(last),
                           [](const GlslToken& token) {
                               return token.text == "break" || token.text == "continue";
                           });
    }

    const std::string& code_;
    GlslTokens tokens_;
};

std::string writtenOut(const ForText& loop, int rounds) {
    std::string text = "{ " + loop.begin + "; ";
    for (int i = 0; i < rounds; ++i) {
        text += (i > 0 ? loop.step + "; " : "") + loop.body + ' ';
    }
    return text + '}';
}

} // namespace

std::vector<VaryingLoop> varyingLoops(const Material& material, const Catalog& catalog) {
    auto request = sweepVariant(catalog, material);
    if (!request || request->subject != EvalCase::Subject::Model) {
        return {};
    }
    const auto shape = evalShape(*request);
    if (!shape) {
        return {};
    }
    const auto source = evalSource(*request, *shape, catalog.roots.front().folder);
    if (!source) {
        return {};
    }
    const auto syntax = parsedShader(*source, evaluatedFunction);
    if (!syntax) {
        return {};
    }
    RoundsCounter counter(*source, *syntax);
    if (!counter.hasLoops()) {
        return {};
    }
    for (const EvalPlace& place : ordinaryPlaces(request->subject, pairsOfDirections)) {
        static_cast<EvalPlace&>(*request) = place;
        counter.count(*request);
    }
    return counter.found();
}

std::optional<std::string> withRounds(const std::string& glsl, std::span<const VaryingLoop> loops,
                                      std::span<const int> rounds) {
    std::string code = withoutComments(glsl);
    std::vector<std::size_t> backwards(loops.size()); // so that places before stay what they are
    std::iota(backwards.begin(), backwards.end(), std::size_t(0));
    std::ranges::sort(backwards, std::ranges::greater(),
                      [&loops](std::size_t i) { return loops[i].place; });
    for (const std::size_t i : backwards) {
        const auto found = ForFinder(code).find(loops[i]);
        if (!found) {
            return std::nullopt;
        }
        code.replace(found->first, found->last - found->first, writtenOut(*found, rounds[i]));
    }
    return code;
}

} // namespace patina
