// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/half_check.h"

#include <cmath>

#include <fmt/format.h>

namespace patina {
namespace {

constexpr double largestHalf = 65504.0;

/// Says why a line breaks; empty where it holds.
std::string whyNot(const HalfLine& line, double limit) {
    if (line.holds(limit)) {
        return {};
    }
    if (line.largest > largestHalf) {
        return fmt::format("it reaches {:.2g}, more than 65504", line.largest);
    }
    return line.error.isSafe ? "its digits are too few"
                             : "the value is not finite or negative in edge cases";
}

std::string offText(const TextError& error) {
    return std::isfinite(error.worst) ? fmt::format("{:.2g}", error.worst) : "-";
}

std::string verdictText(const TextError& error, double limit) {
    return fmt::format("at most {} off, {}", offText(error),
                       !error.isSafe           ? "not finite or negative in edge cases"
                       : error.isWithin(limit) ? "which holds"
                                               : "which is too far");
}

nlohmann::json errorJson(const TextError& error, double limit) {
    return {{"atMost", error.worst},
            {"mean", error.mean},
            {"finite", error.isSafe},
            {"holds", error.isWithin(limit)}};
}

} // namespace

std::string halfText(const HalfReport& report, const std::string& name) {
    std::string text = fmt::format("{}: floats of 16 bits, each line by itself\n"
                                   "         at most off  line\n",
                                   name);
    std::string file;
    for (const HalfLine& line : report.lines) {
        if (line.file != file) {
            file = line.file;
            text += file + '\n';
        }
        const std::string why = whyNot(line, report.limit);
        text += fmt::format("{:<7}  {:>11}  {}: {}\n", why.empty() ? "holds" : "breaks",
                            offText(line.error), line.line, line.code);
        if (!why.empty()) {
            text += fmt::format("{:22}{}\n", "", why);
        }
    }
    return text + fmt::format("all lines: {}\n{} of {} lines, together: {}\n"
                              "where white is 1, {:.2g} holds; {} cases\n",
                              verdictText(report.whole, report.limit), report.together.size(),
                              report.lines.size(), verdictText(report.mixed, report.limit),
                              report.limit, report.cases);
}

nlohmann::json halfJson(const HalfReport& report, const std::string& name) {
    nlohmann::json lines = nlohmann::json::array();
    for (const HalfLine& line : report.lines) {
        nlohmann::json each = errorJson(line.error, report.limit);
        each["file"] = line.file;
        each["line"] = line.line;
        each["code"] = line.code;
        each["largest"] = line.largest;
        each["why"] = whyNot(line, report.limit);
        lines.push_back(std::move(each));
    }
    return {{"subject", name},
            {"precision", "half"},
            {"lines", lines},
            {"whole", errorJson(report.whole, report.limit)},
            {"mixed", errorJson(report.mixed, report.limit)},
            {"together", report.together},
            {"limit", report.limit},
            {"cases", report.cases}};
}

} // namespace patina
