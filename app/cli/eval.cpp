// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/command.h"
#include "cli/eval_line.h"
#include "core/number_text.h"
#include "core/text.h"
#include "measure/error/parallel.h"
#include "measure/eval/eval_gpu.h"
#include "measure/eval/eval_reference.h"
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

/// Writes the answer of a case; a light's also has the direction to it.
std::string valueLine(const EvalCase& request, std::span<const double> numbers) {
    const std::string id = request.id.dump(-1, ' ', true);
    const bool isLibrary = request.subject == EvalCase::Subject::Function;
    if (!isLibrary && calledFunction(request).result == "Illumination") {
        return fmt::format("{{\"id\": {}, \"l\": {}, \"value\": {}}}\n", id,
                           jsonList(numbers.first(3)), jsonList(numbers.subspan(3)));
    }
    return fmt::format("{{\"id\": {}, \"value\": {}}}\n", id, jsonList(numbers));
}

/// Holds the answer to a line, or the case that waits for the GPU.
struct Answer {
    std::string text;
    std::optional<EvalCase> waiting;
    bool failed = false;
};

Answer failed(const nlohmann::json& id, const Error& error) {
    return {errorLine(id, error), {}, true};
}

Answer answered(const EvalCase& request, const Result<std::vector<double>>& numbers) {
    if (!numbers) {
        return failed(request.id, numbers.error());
    }
    if (!allFinite(*numbers)) {
        return failed(request.id, Error{{}, 0, 0, "the result is not finite", {}});
    }
    return {valueLine(request, *numbers), {}, false};
}

Answer answerTo(std::string_view line, const Catalog& catalog) {
    EvalLine read = readEvalLine(line, catalog);
    if (!read.request) {
        return failed(read.id, read.request.error());
    }
    if (read.request->gpu) {
        return {{}, std::move(*read.request), false};
    }
    return answered(*read.request, evaluatedInDouble(*read.request));
}

/// Answers lines in their order, many at a time. Cases for the GPU, and all answers after them,
/// wait until there are many or no more lines.
class Evaluation {
  public:
    explicit Evaluation(const Catalog& catalog) : catalog_(catalog) {}

    /// Takes a line; its answer comes with a later call of answer() or finish().
    void take(std::string line) {
        bytes_ += line.size();
        lines_.push_back(std::move(line));
        if (lines_.size() >= maxLines || bytes_ >= maxBytes) {
            answer();
        }
    }

    /// Computes the lines that were taken, and writes the answers unless cases wait for the GPU.
    void answer() {
        const std::size_t before = answers_.size();
        answers_.resize(before + lines_.size());
        const auto work = [this, before](std::size_t, std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                answers_[before + i] = answerTo(lines_[i], catalog_);
            }
        };
        lines_.size() < worthThreads ? work(0, 0, lines_.size()) : inParallel(lines_.size(), work);
        const auto isWaiting = [](const Answer& answer) { return answer.waiting.has_value(); };
        waiting_ +=
            std::count_if(answers_.begin() + std::ptrdiff_t(before), answers_.end(), isWaiting);
        lines_.clear();
        bytes_ = 0;
        if (waiting_ == 0 || waiting_ >= enough) {
            write();
        }
    }

    /// Writes all answers that are left.
    void finish() {
        answer();
        write();
    }

    bool failedOnce() const { return failedOnce_; }

  private:
    static constexpr std::ptrdiff_t enough = 1 << 17;  ///< GPU cases kept in memory at a time
    static constexpr std::size_t worthThreads = 256;   ///< fewer lines are quicker on one
    static constexpr std::size_t maxLines = 1u << 14;  ///< lines answered at a time
    static constexpr std::size_t maxBytes = 16u << 20; ///< bytes of the lines answered at a time

    void write() {
        answerWaiting();
        for (const Answer& answer : answers_) {
            std::cout << answer.text;
            failedOnce_ = failedOnce_ || answer.failed;
        }
        answers_.clear();
    }

    void answerWaiting() {
        std::vector<EvalCase> cases;
        std::vector<Answer*> places;
        for (Answer& answer : answers_) {
            if (answer.waiting) {
                cases.push_back(std::move(*answer.waiting));
                places.push_back(&answer);
            }
        }
        const auto results = gpu_.evaluate(cases, catalog_);
        for (std::size_t i = 0; i < results.size(); ++i) {
            *places[i] = answered(cases[i], results[i]);
        }
        waiting_ = 0;
    }

    const Catalog& catalog_;
    EvalGpu gpu_;
    std::vector<std::string> lines_;
    std::size_t bytes_ = 0;
    std::vector<Answer> answers_;
    std::ptrdiff_t waiting_ = 0;
    bool failedOnce_ = false;
};

/// Answers all lines of standard input; returns true when every line had a value.
bool evaluateAll(const Catalog& catalog) {
    std::ios::sync_with_stdio(false);
    std::cin.tie(nullptr);
    Evaluation evaluation(catalog);
    std::string line;
    while (std::getline(std::cin, line)) {
        if (isBlank(line)) {
            continue;
        }
        evaluation.take(std::move(line));
        if (std::cin.rdbuf()->in_avail() <= 0) { // the writer may be waiting for its answer
            evaluation.answer();
            std::cout.flush();
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

constexpr const char* caseKeys =
    R"(A case is one of these. Vectors are arrays of 3 numbers; directions point away from the
surface and need not be unit; parameters that are not named have their defaults.
  {"model": ID, "l": to the light, "v": to the viewer, "n": normal, "t": tangent,
   "pixel": [X, Y], "parameters": {ID: VALUE, ...}, "accuracy": {ID: LEVEL, ...},
   and for its slot "fresnel": BLOCK or "specular": BLOCK}
                              pi f cos(theta_l), R G B
  {"specular": BLOCK, "l": ..., "v": ...}
                              on the scale of a model
  {"fresnel": BLOCK, "cos": -1 .. 1}
                              the reflectance, R G B
  {"light": BLOCK, "x": point}
                              E/pi, R G B, and "l", the direction to the light
  {"fog": BLOCK, "distance": metres, "eye": point, "direction": vector}
                              the share of the surface's light that is left
  {"environment": BLOCK, "direction": where one looks, "picture": [R, G, B]}
                              what comes from there, E/pi, R G B; the picture's colour is white
                              unless it is given
  {"refraction": BLOCK, "l": where the ray comes from, "n": normal on that side,
   "channel": 0 .. 2 (1), "leaves": true or false (false)}
                              the direction in which it goes on; 0 where all is reflected
  {"outline": BLOCK, "silhouette": true or false, "open": true or false, "dihedral": 0 .. pi}
                              how wide an edge's lines are, outside the shape and on it
  {"shells": BLOCK, "l": ..., "v": ..., "t": along the strand}
                              the light of a strand, on the scale of a model
  {"shells": BLOCK, "call": "Offset", "height": 0 .. 1, "n": normal, "nl": 0 .. 1,
   "size": 0 .. 1, "shade": 0 .. 1, "phase": 0 .. 1}
                              where a strand is beside its root; "Radius", "Curl", "Tint" likewise
  {"strokes": BLOCK, "along": 0 .. 1, "across": 0 .. 1, "n": normal, "t": tangent,
   "v": to the viewer, "radiance": [R, G, B], "order": 0 .. 1, "pixel": width of one (0.1),
   "aspect": 0 .. 64, "size": 0 .. 1, "shade": 0 .. 1, "phase": 0 .. 1}
                              the colour of a mark; "Share", "Size", "Along", "Shape", "Opacity"
                              and "Under" likewise
  {"transparency": BLOCK, "depth": 0 .. 1, "opacity": 0 .. 1}
                              how much a surface counts
  {"tone": BLOCK, "radiance": [R, G, B]}
                              what a screen shows of that light, before its own curve
  {"function": NAME, "arguments": [NUMBER, ...]}
                              what the function of the shader library gives
BLOCK is an id, or {"id": ID, "parameters": {...}, "accuracy": {...}}. Every case may have
an "id", which its answer repeats, and a "precision": "double" (the default) or "gpu".
An answer is {"id": ..., "value": ...}, or has an "error" in place of the value.
  echo '{"function": "sqr", "arguments": [3]}' | patina eval
)";

/// Returns the arguments of a function as keys of a line.
std::string keysText(const BlockFunction& function) {
    std::string text;
    const auto add = [&text](std::string_view key) { text += fmt::format(", \"{}\": ...", key); };
    if (subjectOf(function) == EvalCase::Subject::Fresnel) {
        add("cos");
    }
    for (const ArgumentField& field : function.fields) {
        add(field.key);
    }
    return text;
}

/// Returns a case of each kind that the help above does not know.
std::string otherKindsText() {
    std::string text;
    for (const BlockKind& kind : blockKinds()) {
        const std::string start = fmt::format("  {{\"{}\":", kind.singular);
        const auto functions = evaluatedFunctions(kind);
        if (!functions.empty() &&
            std::string_view(caseKeys).find(start) == std::string_view::npos) {
            text += fmt::format("{} BLOCK{}}}\n", start, keysText(*functions.front()));
        }
    }
    return text.empty() ? text : "A case may also be one of these:\n" + text;
}

/// Returns help on the functions of each kind after its first one.
std::string callsText() {
    std::string text = "Some blocks have more functions, which a case names by its key \"call\":\n";
    for (const BlockKind& kind : blockKinds()) {
        for (const BlockFunction* function : evaluatedFunctions(kind)) {
            if (!function->suffix.empty()) {
                text += fmt::format("  {{\"{}\": BLOCK, \"call\": \"{}\"{}}}\n", kind.singular,
                                    function->suffix, keysText(*function));
            }
        }
    }
    return text;
}

} // namespace

void addEval(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand(
        "eval", "Evaluate models and other blocks, and shader functions:\n"
                "one JSON case per line on standard input, one result per line on standard output");
    auto functions = std::make_shared<bool>(false);
    command->footer(caseKeys + otherKindsText() + callsText());
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
