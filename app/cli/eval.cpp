// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <iostream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/command.h"
#include "cli/eval_gpu.h"
#include "cli/eval_reference.h"
#include "core/number_text.h"
#include "reference/reference.h"

namespace patina {
namespace {

std::string jsonList(std::span<const double> numbers) {
    std::string text = "[";
    for (const double number : numbers) {
        text += (text.size() > 1 ? ", " : "") + fullText(number);
    }
    return text + ']';
}

std::string errorLine(const nlohmann::json& id, const Error& error) {
    using Json = nlohmann::json;
    const Json text = error.text();
    return fmt::format("{{\"id\": {}, \"error\": {}}}\n", id.dump(-1, ' ', true),
                       text.dump(-1, ' ', true, Json::error_handler_t::replace));
}

bool allFinite(std::span<const double> numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

/// A light answers with its direction as well.
std::string valueLine(const EvalCase& request, std::span<const double> numbers) {
    const std::string id = request.id.dump(-1, ' ', true);
    if (request.subject == EvalCase::Subject::Light) {
        return fmt::format("{{\"id\": {}, \"l\": {}, \"value\": {}}}\n", id,
                           jsonList(numbers.first(3)), jsonList(numbers.subspan(3)));
    }
    return fmt::format("{{\"id\": {}, \"value\": {}}}\n", id, jsonList(numbers));
}

/// Answers lines in their order. Cases for the GPU are kept back, and what follows them with
/// them, until there are many or no more lines.
class Evaluation {
  public:
    explicit Evaluation(const Catalog& catalog) : catalog_(catalog) {}

    void take(std::string_view line) {
        EvalLine read = readEvalLine(line, catalog_);
        if (read.request && read.request->gpu) {
            answers_.emplace_back();
            waiting_.push_back(std::move(*read.request));
            places_.push_back(answers_.size() - 1);
        } else {
            answers_.push_back(read.request
                                   ? answer(*read.request, evaluatedInDouble(*read.request))
                                   : failed(read.id, read.request.error()));
        }
        if (waiting_.empty() || waiting_.size() >= enough) {
            finish();
        }
    }

    /// Writes everything that is known or can now be found out.
    void finish() {
        const auto results = gpu_.evaluate(waiting_, catalog_);
        for (std::size_t i = 0; i < results.size(); ++i) {
            answers_[places_[i]] = answer(waiting_[i], results[i]);
        }
        for (const std::string& line : answers_) {
            std::cout << line;
        }
        answers_.clear();
        waiting_.clear();
        places_.clear();
    }

    bool failedOnce() const { return failedOnce_; }

  private:
    static constexpr std::size_t enough = 1u << 17; ///< GPU cases kept in memory at a time

    std::string failed(const nlohmann::json& id, const Error& error) {
        failedOnce_ = true;
        return errorLine(id, error);
    }

    std::string answer(const EvalCase& request, const Result<std::vector<double>>& numbers) {
        if (!numbers) {
            return failed(request.id, numbers.error());
        }
        if (!allFinite(*numbers)) {
            return failed(request.id, Error{{}, 0, 0, "the result is not finite", {}});
        }
        return valueLine(request, *numbers);
    }

    const Catalog& catalog_;
    EvalGpu gpu_;
    std::vector<std::string> answers_;
    std::vector<EvalCase> waiting_;
    std::vector<std::size_t> places_;
    bool failedOnce_ = false;
};

bool isBlank(std::string_view line) {
    return line.find_first_not_of(" \t\r") == std::string_view::npos;
}

/// True when every line had a value.
bool evaluateAll(const Catalog& catalog) {
    std::ios::sync_with_stdio(false);
    std::cin.tie(nullptr);
    Evaluation evaluation(catalog);
    std::string line;
    while (std::getline(std::cin, line)) {
        if (isBlank(line)) {
            continue;
        }
        evaluation.take(line);
        if (std::cin.rdbuf()->in_avail() <= 0) {
            std::cout.flush(); // whoever wrote the line may be waiting for its answer
        }
    }
    evaluation.finish();
    return !evaluation.failedOnce();
}

void listFunctions() {
    for (const reference::Function& function : reference::functions()) {
        std::cout << function.signature << '\n';
    }
}

} // namespace

void addEval(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand(
        "eval", "Evaluate models, Fresnel blocks, lights, fog and shader functions:\n"
                "one JSON case per line on standard input, one result per line on standard output");
    auto functions = std::make_shared<bool>(false);
    command->add_flag("--functions", *functions, "List the shader library's functions instead");
    command->callback([functions, &status] {
        if (*functions) {
            listFunctions();
            return;
        }
        const Catalog catalog = loadCatalog(standardBlockRoots());
        report(catalog.errors);
        status = evaluateAll(catalog) ? 0 : 1;
    });
}

} // namespace patina
