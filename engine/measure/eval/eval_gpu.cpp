// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/eval/eval_gpu.h"

#include <algorithm>
#include <map>

#include "gl/headless_context.h"
#include "measure/eval/eval_program.h"

namespace patina {
namespace {

/// Returns a number of the answer. A model's value below 0 becomes 0, as lights are summed; a NaN
/// stays one.
double answerOf(const EvalCase& request, float x) {
    return request.subject == EvalCase::Subject::Model && x < 0.0F ? 0.0 : static_cast<double>(x);
}

std::vector<float> texelsOf(std::span<const EvalCase* const> cases, const EvalShape& shape) {
    const auto numbers = static_cast<std::size_t>(shape.caseTexels) * 4;
    std::vector<float> texels;
    texels.reserve(cases.size() * numbers);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        for (const auto& part : {placeTexels(*cases[i]), valueTexels(*cases[i])}) {
            texels.insert(texels.end(), part.begin(), part.end());
        }
        texels.resize((i + 1) * numbers);
    }
    return texels;
}

} // namespace

/// Holds the context and the programs that were linked in it.
class EvalGpu::Device {
  public:
    explicit Device(std::unique_ptr<gl::HeadlessContext> context) : context_(std::move(context)) {}

    /// Returns the results of cases with the same key, or why there are none.
    Result<std::vector<std::vector<double>>> draw(std::span<const EvalCase* const> cases,
                                                  const std::filesystem::path& shaders) {
        const Result<const EvalProgram*> program = programFor(*cases.front(), shaders);
        if (!program) {
            return tl::unexpected(program.error());
        }
        std::vector<std::vector<double>> answers;
        EvalProgram::bindMeasured(measured_, *cases.front());
        while (!cases.empty()) {
            const auto part = cases.first(std::min(cases.size(), EvalProgram::largestDraw));
            if (const auto done = drawPart(part, **program, answers); !done) {
                return tl::unexpected(done.error());
            }
            cases = cases.subspan(part.size());
        }
        return answers;
    }

  private:
    Result<const EvalProgram*> programFor(const EvalCase& request,
                                          const std::filesystem::path& shaders) {
        const std::string key = evalKey(request);
        if (const auto found = programs_.find(key); found != programs_.end()) {
            return &found->second;
        }
        Result<EvalProgram> program = EvalProgram::link(request, shaders);
        if (!program) {
            return tl::unexpected(program.error());
        }
        return &programs_.emplace(key, std::move(*program)).first->second;
    }

    static Result<void> drawPart(std::span<const EvalCase* const> cases, const EvalProgram& program,
                                 std::vector<std::vector<double>>& answers) {
        const auto read = program.draw(texelsOf(cases, program.shape()), cases.size());
        if (!read) {
            return tl::unexpected(read.error());
        }
        const std::size_t results = program.shape().results;
        for (std::size_t i = 0; i < cases.size(); ++i) {
            std::vector<double>& answer = answers.emplace_back();
            for (std::size_t k = 0; k < results; ++k) {
                answer.push_back(answerOf(*cases[i], (*read)[i * results + k]));
            }
        }
        return {};
    }

    std::unique_ptr<gl::HeadlessContext> context_;
    std::map<std::string, EvalProgram> programs_;
    MeasuredStore measured_;
};

EvalGpu::EvalGpu() = default;
EvalGpu::~EvalGpu() = default;

Result<EvalGpu::Device*> EvalGpu::device() {
    if (device_ == nullptr) {
        auto context = gl::HeadlessContext::create();
        if (!context) {
            return tl::unexpected(context.error());
        }
        device_ = std::make_unique<Device>(std::move(*context));
    }
    return device_.get();
}

std::vector<Result<std::vector<double>>> EvalGpu::evaluate(std::span<const EvalCase> cases,
                                                           const Catalog& catalog) {
    std::map<std::string, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        groups[evalKey(cases[i])].push_back(i);
    }
    std::vector<Result<std::vector<double>>> results(cases.size());
    for (const auto& [key, members] : groups) {
        std::vector<const EvalCase*> group;
        for (const std::size_t i : members) {
            group.push_back(&cases[i]);
        }
        const Result<Device*> ready = device();
        const auto answers = ready ? (*ready)->draw(group, catalog.roots.front().folder)
                                   : tl::unexpected(ready.error());
        for (std::size_t k = 0; k < members.size(); ++k) {
            if (answers) {
                results[members[k]] = (*answers)[k];
            } else {
                results[members[k]] = tl::unexpected(answers.error());
            }
        }
    }
    return results;
}

} // namespace patina
