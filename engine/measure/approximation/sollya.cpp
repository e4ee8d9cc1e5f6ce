// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/sollya.h"

#include <charconv>
#include <chrono>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "assets/line_process.h"
#include "assets/program_in_path.h"

namespace patina {
namespace {

/// Writes "begin N", the coefficients and the bound of each wish, each on a line of its own.
std::string scriptFor(std::span<const PolynomialWish> wishes) {
    std::string script = "verbosity = 0!; roundingwarnings = off!; prec = 100!; "
                         "display = decimal!;\n";
    for (std::size_t i = 0; i < wishes.size(); ++i) {
        const PolynomialWish& wish = wishes[i];
        script += fmt::format("print(\"begin\", {});\n"
                              "f = {};\n"
                              "d = [{:.17g}; {:.17g}];\n"
                              "p = fpminimax(f, {}, [|SG...|], d, absolute);\n"
                              "for k from 0 to {} do print(\"c\", single(coeff(p, k)));\n"
                              "b = supnorm(p, f, d, absolute, 2^(-8));\n"
                              "print(\"b\", sup(b));\n",
                              i, wish.function, wish.low, wish.high, wish.degree, wish.degree);
    }
    return script + "print(\"end\");\nquit;\n";
}

std::optional<double> numberBehind(std::string_view line, std::string_view word) {
    if (!line.starts_with(word)) {
        return std::nullopt;
    }
    line.remove_prefix(word.size());
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    double x = 0.0;
    const auto read = std::from_chars(line.data(), line.data() + line.size(), x);
    return read.ec == std::errc() && std::isfinite(x) ? std::optional(x) : std::nullopt;
}

/// Puts the lines of Sollya's answer together.
class AnswerReader {
  public:
    explicit AnswerReader(std::span<const PolynomialWish> wishes)
        : wishes_(wishes), found_(wishes.size()) {}

    /// Returns whether the answer goes on.
    bool take(std::string_view line) {
        if (line.starts_with("end")) {
            return false;
        }
        if (const auto begin = numberBehind(line, "begin")) {
            at_ = static_cast<std::size_t>(*begin);
            coefficients_.clear();
        } else if (const auto coefficient = numberBehind(line, "c ")) {
            coefficients_.push_back(*coefficient);
        } else if (const auto bound = numberBehind(line, "b "); bound && at_ < found_.size()) {
            const auto wanted = static_cast<std::size_t>(wishes_[at_].degree) + 1;
            if (coefficients_.size() == wanted) {
                found_[at_] = FittedPolynomial{coefficients_, *bound};
            }
        }
        return true;
    }

    std::vector<std::optional<FittedPolynomial>> found() { return std::move(found_); }

  private:
    std::span<const PolynomialWish> wishes_;
    std::vector<std::optional<FittedPolynomial>> found_;
    std::vector<double> coefficients_;
    std::size_t at_ = 0;
};

} // namespace

Result<std::vector<std::optional<FittedPolynomial>>>
fittedPolynomials(std::span<const PolynomialWish> wishes, double seconds,
                  const std::function<bool()>& isStopped) {
    const std::filesystem::path program = programInPath("sollya");
    if (program.empty()) {
        return failure("Sollya is not installed, which fits polynomials", installSollya);
    }
    auto process = LineProcess::start({.program = program,
                                       .input = scriptFor(wishes),
                                       .memoryBytes = std::size_t(1) << 30,
                                       .stackBytes = std::size_t(64) << 20});
    if (!process) {
        return tl::unexpected(process.error());
    }
    AnswerReader reader(wishes);
    const auto began = std::chrono::steady_clock::now();
    while (true) {
        if (const auto line = process->line(std::chrono::milliseconds(50))) {
            if (!reader.take(*line)) {
                break;
            }
        } else if (process->hasEnded()) {
            break;
        }
        const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - began;
        if (waited.count() > seconds || isStopped()) {
            break; // what it has by now is used
        }
    }
    process->end();
    return reader.found();
}

} // namespace patina
