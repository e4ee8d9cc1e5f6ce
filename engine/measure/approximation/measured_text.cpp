// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/measured_text.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "measure/error/parallel.h"
#include "measure/interpreter/shader_parser.h"
#include "measure/time/instruction_count.h"

namespace patina {
namespace {

constexpr const char* rootFunction = "evaluated";

bool isOver(const EvaluationEnd& isEnded) {
    return isEnded && isEnded();
}

/// Finds the functions whose text is a block's own or the library's, as far as nothing else calls
/// them: what other blocks and the program call as well stays as it is.
class OwnFunctions {
  public:
    OwnFunctions(const EvalCase& subject, const ShaderSource& source, const ShaderSyntax& syntax)
        : source_(source), syntax_(syntax),
          blockFile_(subject.block.block->shaderFile.lexically_normal()),
          main_(syntax.functionNamed(functionName(*subject.block.block) +
                                     std::string(calledFunction(subject).suffix))) {
        addOthers(syntax.functionNamed(rootFunction));
        addOwn(main_);
        std::erase_if(own_, [this](int function) { return others_.contains(function); });
    }

    std::set<int> take() { return std::move(own_); }

  private:
    const ParsedFunction& at(int function) const {
        return syntax_.functions[static_cast<std::size_t>(function)];
    }

    bool isOwn(int function) const {
        const auto file = static_cast<std::size_t>(at(function).file);
        if (file == 0 || file >= source_.files.size()) {
            return false; // it was generated
        }
        const std::filesystem::path path = source_.files[file];
        return path.lexically_normal() == blockFile_ || path.parent_path().filename() == "lib";
    }

    void addOthers(int function) {
        if (function >= 0 && function != main_ && others_.insert(function).second) {
            std::ranges::for_each(at(function).calls, [this](int each) { addOthers(each); });
        }
    }

    void addOwn(int function) {
        if (function < 0) {
            return;
        }
        if (!isOwn(function)) {
            addOthers(function);
        } else if (own_.insert(function).second) {
            std::ranges::for_each(at(function).calls, [this](int each) { addOwn(each); });
        }
    }

    const ShaderSource& source_;
    const ShaderSyntax& syntax_;
    std::filesystem::path blockFile_;
    int main_;
    std::set<int> others_;
    std::set<int> own_;
};

/// Makes the directions of a case unit in double precision. As floats they are a little longer or
/// shorter, which is part of what a text in floats loses, and much of it next to the normal.
std::vector<double> withUnitDirections(std::vector<double> texels) {
    constexpr std::size_t directions = 4; // n, t, l and v, each at the front of a vec4
    for (std::size_t i = 0; i < directions && 4 * i + 2 < texels.size(); ++i) {
        const auto vector = std::span(texels).subspan(4 * i, 3);
        const double length = std::hypot(vector[0], vector[1], vector[2]);
        for (double& component : vector) {
            component = length > 0.0 && std::isfinite(length) ? component / length : component;
        }
    }
    return texels;
}

} // namespace

Checked<MeasuredText> MeasuredText::of(const EvalCase& subject,
                                       const std::filesystem::path& shaders) {
    MeasuredText made;
    const Result<EvalShape> shape = evalShape(subject);
    if (!shape) {
        return tl::unexpected(oneError(shape.error()));
    }
    made.shape_ = *shape;
    Checked<ShaderSource> source = evalSource(subject, *shape, shaders);
    if (!source) {
        return tl::unexpected(source.error());
    }
    made.source_ = std::make_unique<ShaderSource>(std::move(*source));
    if (Errors mistakes = compilerMistakes(*made.source_); !mistakes.empty()) {
        return tl::unexpected(std::move(mistakes));
    }
    auto syntax = parsedShader(*made.source_, rootFunction);
    if (!syntax) {
        return tl::unexpected(oneError(syntax.error()));
    }
    made.syntax_ = std::make_unique<ShaderSyntax>(std::move(*syntax));
    made.signed_ = signedResultsOf(subject);
    made.isCut_ = subject.subject == EvalCase::Subject::Model;
    made.own_ = OwnFunctions(subject, *made.source_, *made.syntax_).take();
    return made;
}

void MeasuredText::evaluate(ShaderEvaluator& evaluator, int function,
                            const std::vector<double>& texels, std::span<double> results) const {
    const auto parts = static_cast<std::size_t>(shape_.resultPixels);
    const std::size_t perPart = shape_.results == 3 * parts ? 3 : 4;
    for (std::size_t part = 0; part < parts; ++part) {
        const auto argument = static_cast<double>(part);
        const std::size_t first = part * perPart;
        evaluator.call(function, {&argument, 1}, texels,
                       results.subspan(first, std::min(perPart, results.size() - first)));
    }
}

JudgedCases MeasuredText::judged(CaseTexels texels, const EvaluationEnd& isEnded) const {
    JudgedCases cases{std::move(texels), {}};
    cases.exact.resize(cases.texels.size() * shape_.results);
    const int function = syntax_->functionNamed(rootFunction);
    inParallel(cases.texels.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
        ShaderEvaluator evaluator(*syntax_, ShaderPrecision::Double);
        for (std::size_t i = begin; i < end && !isOver(isEnded); ++i) {
            evaluate(evaluator, function,
                     isCut_ ? withUnitDirections(cases.texels[i]) : cases.texels[i],
                     std::span(cases.exact).subspan(i * shape_.results, shape_.results));
        }
    });
    return isOver(isEnded) ? JudgedCases() : cases;
}

std::vector<ObservedValues> MeasuredText::observed(const CaseTexels& texels) const {
    std::vector<ObservedValues> values;
    std::vector<double> ignored(shape_.results);
    ShaderEvaluator evaluator(*syntax_, ShaderPrecision::Double);
    evaluator.observe(&values);
    for (const std::vector<double>& each : texels) {
        evaluate(evaluator, syntax_->functionNamed(rootFunction), each, ignored);
    }
    return values;
}

double MeasuredText::errorOf(std::span<const double> exact, std::span<const double> got) const {
    double worst = 0.0;
    double scale = 1.0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const double right = isCut_ ? std::max(exact[i], 0.0) : exact[i];
        const double off = std::abs((isCut_ ? std::max(got[i], 0.0) : got[i]) - right);
        if (std::isnan(off)) {
            return std::numeric_limits<double>::infinity();
        }
        worst = std::max(worst, off);
        scale = std::max(scale, std::abs(right));
    }
    return worst / scale;
}

bool MeasuredText::isSafe(std::span<const double> exact, std::span<const double> got) const {
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const bool wasFinite = std::isfinite(exact[i]);
        const bool isNegative = i >= signed_ && got[i] < 0.0 && !(exact[i] < 0.0);
        if ((wasFinite && !std::isfinite(got[i])) || isNegative) {
            return false;
        }
    }
    return true;
}

TextError MeasuredText::error(std::span<const ShaderEdit> edits, const JudgedCases& cases,
                              double limit, const EvaluationEnd& isEnded) const {
    const ShaderSource source = editedSource(*source_, *syntax_, edits);
    const auto syntax = parsedShader(source, rootFunction);
    if (!syntax) {
        return {std::numeric_limits<double>::infinity(), 0.0, false};
    }
    ShaderEvaluator evaluator(*syntax, ShaderPrecision::Float);
    return compared(evaluator, syntax->functionNamed(rootFunction), cases, limit, isEnded);
}

std::vector<double> MeasuredText::errors(std::span<const ShaderEdit> edits,
                                         const JudgedCases& cases,
                                         const EvaluationEnd& isEnded) const {
    std::vector<double> all(cases.texels.size(), std::numeric_limits<double>::infinity());
    const ShaderSource source = editedSource(*source_, *syntax_, edits);
    const auto syntax = parsedShader(source, rootFunction);
    if (!syntax) {
        return all;
    }
    const int function = syntax->functionNamed(rootFunction);
    inParallel(all.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
        ShaderEvaluator evaluator(*syntax, ShaderPrecision::Float);
        std::vector<double> got(shape_.results);
        for (std::size_t i = begin; i < end && !isOver(isEnded); ++i) {
            evaluate(evaluator, function, cases.texels[i], got);
            const auto exact = std::span(cases.exact).subspan(i * shape_.results, shape_.results);
            if (isSafe(exact, got)) {
                all[i] = errorOf(exact, got);
            }
        }
    });
    return all;
}

TextError MeasuredText::errorInHalf(const std::vector<bool>& halved, const JudgedCases& cases,
                                    double limit) const {
    ShaderEvaluator evaluator(*syntax_, ShaderPrecision::Float);
    evaluator.halve(&halved);
    return compared(evaluator, syntax_->functionNamed(rootFunction), cases, limit, {});
}

std::vector<double> MeasuredText::valuesInHalf(const std::vector<bool>& halved,
                                               const CaseTexels& texels) const {
    ShaderEvaluator evaluator(*syntax_, ShaderPrecision::Float);
    evaluator.halve(&halved);
    const int function = syntax_->functionNamed(rootFunction);
    std::vector<double> values(texels.size() * shape_.results);
    for (std::size_t i = 0; i < texels.size(); ++i) {
        evaluate(evaluator, function, texels[i],
                 std::span(values).subspan(i * shape_.results, shape_.results));
    }
    return values;
}

std::vector<bool> MeasuredText::ownFloats() const {
    std::vector<bool> own(syntax_->expressions.size());
    for (std::size_t i = 0; i < own.size(); ++i) {
        const ShaderExpression& each = syntax_->expressions[i];
        own[i] = own_.contains(each.owner) && each.type.isFloat() && each.first != each.last;
    }
    return own;
}

TextError MeasuredText::compared(ShaderEvaluator& evaluator, int function, const JudgedCases& cases,
                                 double limit, const EvaluationEnd& isEnded) const {
    TextError error;
    std::vector<double> got(shape_.results);
    const std::size_t count = cases.texels.size();
    for (std::size_t i = 0; i < count && error.isWithin(limit) && !isOver(isEnded); ++i) {
        evaluate(evaluator, function, cases.texels[i], got);
        const auto exact = std::span(cases.exact).subspan(i * shape_.results, shape_.results);
        const double off = errorOf(exact, got);
        error.isSafe = isSafe(exact, got);
        error.worst = std::max(error.worst, off);
        error.mean += off / static_cast<double>(cases.texels.size());
    }
    return error;
}

bool MeasuredText::isSafe(std::span<const ShaderEdit> edits, const JudgedCases& cases,
                          const EvaluationEnd& isEnded) const {
    return error(edits, cases, std::numeric_limits<double>::infinity(), isEnded).isSafe;
}

} // namespace patina
