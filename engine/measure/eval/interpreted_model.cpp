// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/eval/interpreted_model.h"

#include <algorithm>
#include <array>
#include <deque>
#include <iterator>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "measure/eval/eval_source.h"
#include "measure/interpreter/shader_parser.h"

namespace patina {
namespace {

constexpr const char* rootFunction = "evaluated";

/// Keeps the last few programs: a fit asks for the same one again and again.
class ParsedPrograms {
  public:
    using Program = std::shared_ptr<const InterpretedModel>;

    Program find(const std::string& text) {
        const std::scoped_lock lock(guard_);
        const auto found = std::ranges::find(last_, text, &std::pair<std::string, Program>::first);
        return found == last_.end() ? nullptr : found->second;
    }

    void keep(const std::string& text, const Program& program) {
        constexpr std::size_t kept = 16;
        const std::scoped_lock lock(guard_);
        last_.emplace_front(text, program);
        last_.resize(std::min(last_.size(), kept));
    }

  private:
    std::mutex guard_;
    std::deque<std::pair<std::string, Program>> last_;
};

ParsedPrograms& parsedPrograms() {
    static ParsedPrograms programs;
    return programs;
}

} // namespace

Error endlessError(const Block& model) {
    return failure(fmt::format("\"{}\" does not end", model.id), "loops of fewer rounds").value();
}

InterpretedModel::InterpretedModel(std::unique_ptr<const ShaderSource> source, ShaderSyntax syntax)
    : source_(std::move(source)), syntax_(std::move(syntax)),
      function_(syntax_.functionNamed(rootFunction)) {}

Result<std::shared_ptr<const InterpretedModel>>
InterpretedModel::of(const EvalCase& model, const std::filesystem::path& shaders) {
    const Result<EvalShape> shape = evalShape(model);
    if (!shape) {
        return tl::unexpected(shape.error());
    }
    Checked<ShaderSource> written = evalSource(model, *shape, shaders);
    if (!written) {
        return tl::unexpected(written.error().front());
    }
    const auto known = parsedPrograms().find(written->text);
    if (known != nullptr) {
        return known->ends(model) ? Result<std::shared_ptr<const InterpretedModel>>(known)
                                  : tl::unexpected(endlessError(*model.block.block));
    }
    auto source = std::make_unique<const ShaderSource>(std::move(*written));
    auto syntax = parsedShader(*source, rootFunction);
    if (!syntax) {
        return tl::unexpected(syntax.error());
    }
    const std::string text = source->text;
    const std::shared_ptr<const InterpretedModel> made(
        new InterpretedModel(std::move(source), std::move(*syntax)));
    if (!made->ends(model)) {
        return tl::unexpected(endlessError(*model.block.block));
    }
    parsedPrograms().keep(text, made);
    return made;
}

bool InterpretedModel::ends(EvalCase model) const {
    for (const glm::dvec3& l : {glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.6, 0.0, 0.8)}) {
        for (const glm::dvec3& v : {l, glm::dvec3(0.0, 0.8, 0.6)}) {
            model.l = l;
            model.v = v;
            std::vector<double> numbers = placeNumbers(model);
            std::ranges::copy(valueNumbers(model), std::back_inserter(numbers));
            if (!evaluate(numbers)) {
                return false;
            }
        }
    }
    return true;
}

std::optional<glm::dvec3> InterpretedModel::evaluate(std::span<const double> numbers) const {
    std::unique_ptr<ShaderEvaluator> evaluator;
    {
        const std::scoped_lock lock(guard_);
        if (!idle_.empty()) {
            evaluator = std::move(idle_.back());
            idle_.pop_back();
        }
    }
    if (evaluator == nullptr) {
        evaluator = std::make_unique<ShaderEvaluator>(syntax_, ShaderPrecision::Double);
    }
    constexpr double firstPart = 0.0;
    std::array<double, 3> result{};
    evaluator->call(function_, {&firstPart, 1}, numbers, result);
    const bool hasEnded = !evaluator->gaveUp();
    const std::scoped_lock lock(guard_);
    idle_.push_back(std::move(evaluator));
    return hasEnded ? std::optional(glm::dvec3(result[0], result[1], result[2])) : std::nullopt;
}

} // namespace patina
