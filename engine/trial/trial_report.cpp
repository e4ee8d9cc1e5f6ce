// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/trial_report.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace patina {
namespace {

using Json = nlohmann::json;

constexpr std::size_t maxMistakes = 20;
constexpr std::size_t maxBytes = 2000;

std::string shortened(const std::string& text) {
    return text.substr(0, maxBytes);
}

Json toJson(const Error& error) {
    return {{"file", error.file},
            {"line", error.line},
            {"column", error.column},
            {"problem", shortened(error.problem)},
            {"expected", shortened(error.expected)}};
}

/// Throws Json::exception where a member is missing or of another type.
Error errorFrom(const Json& json) {
    return {json.at("file"), json.at("line"), json.at("column"), json.at("problem"),
            json.at("expected")};
}

TrialReport reportFrom(const Json& json) {
    TrialReport report{json.at("block"), json.at("done"), json.at("hash")};
    for (const Json& mistake : json.at("mistakes")) {
        report.mistakes.push_back(errorFrom(mistake));
    }
    return report;
}

} // namespace

std::string toLine(const TrialReport& report) {
    Json mistakes = Json::array();
    for (std::size_t i = 0; i < std::min(report.mistakes.size(), maxMistakes); ++i) {
        mistakes.push_back(toJson(report.mistakes[i]));
    }
    const Json json{{"block", report.block},
                    {"done", report.isDone},
                    {"hash", report.hash},
                    {"mistakes", std::move(mistakes)}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<TrialReport> trialReport(std::string_view line) {
    const Json json = Json::parse(line, nullptr, false);
    if (!json.is_object()) {
        return std::nullopt;
    }
    try {
        return reportFrom(json);
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

} // namespace patina
