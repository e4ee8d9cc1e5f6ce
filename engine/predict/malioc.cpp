// SPDX-License-Identifier: GPL-3.0-or-later
#include "predict/malioc.h"

#include <algorithm>
#include <chrono>
#include <optional>

#include <fmt/format.h>

#include "assets/line_process.h"
#include "assets/program_in_path.h"

namespace patina {
namespace {

using nlohmann::json;

constexpr double lanes = 64.0;
constexpr std::size_t maliocStackBytes = std::size_t(8) << 20;
constexpr int bytesOfRegister = 4;

/// Returns the value of a property of a list such as [{"name": "thread_occupancy", "value": 100}].
json propertyIn(const json& properties, std::string_view name) {
    for (const json& property : properties) {
        if (property.value("name", std::string()) == name) {
            return property.value("value", json());
        }
    }
    return {};
}

int numberIn(const json& properties, std::string_view name) {
    const json value = propertyIn(properties, name);
    return value.is_number() ? value.get<int>() : 0;
}

int spillsIn(const json& properties) {
    const json spills = propertyIn(properties, "has_stack_spilling");
    const int bytes = numberIn(properties, "stack_spill_bytes");
    const bool isSaid = spills.is_boolean() && spills.get<bool>();
    return std::max(bytes / bytesOfRegister, isSaid ? 1 : 0);
}

/// Returns the cycles of the pipeline that takes longest; nothing where none is a number.
std::optional<double> longestIn(const json& cost) {
    std::optional<double> longest;
    for (const json& cycles : cost.value("cycle_count", json::array())) {
        if (cycles.is_number()) {
            longest = std::max(longest.value_or(0.0), cycles.get<double>());
        }
    }
    return longest;
}

std::string errorsIn(const json& report) {
    std::string text;
    for (const json& shader : report.value("shaders", json::array())) {
        for (const json& error : shader.value("errors", json::array())) {
            text += (text.empty() ? "" : "; ") + error.get<std::string>();
        }
    }
    return text;
}

} // namespace

Result<json> maliocReport(MaliocRun run) {
    const std::filesystem::path program = programInPath("malioc");
    if (program.empty()) {
        return failure("malioc is not in the path", "ARM's Mali Offline Compiler");
    }
    run.arguments.insert(run.arguments.begin(), {"--format", "json"});
    auto process = LineProcess::start({.program = program,
                                       .arguments = std::move(run.arguments),
                                       .memoryBytes = run.memoryBytes,
                                       .stackBytes = maliocStackBytes});
    if (!process) {
        return tl::unexpected(process.error());
    }
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(run.seconds);
    std::string text;
    while (!process->hasEnded()) {
        if (const auto line = process->line(std::chrono::milliseconds(50))) {
            text += *line + '\n';
        } else if (Clock::now() > end) {
            return failure("malioc takes too long");
        }
    }
    json report = json::parse(text, nullptr, false);
    if (!report.is_object()) {
        return failure("malioc prints no report");
    }
    return report;
}

std::set<std::string> maliocCores() {
    constexpr double patience = 2.0;
    constexpr std::size_t memory = std::size_t(1) << 30;
    const auto report = maliocReport({{"--list"}, memory, patience});
    std::set<std::string> cores;
    try {
        for (const json& core : report ? report->value("cores", json::array()) : json::array()) {
            cores.insert(core.at("core").get<std::string>());
        }
    } catch (const json::exception&) {
        return {};
    }
    return cores;
}

std::string maliocName(const json& report) {
    std::string version;
    try {
        for (const json& number : report.at("producer").at("version")) {
            version += (version.empty() ? " " : ".") + std::to_string(number.get<int>());
        }
    } catch (const json::exception&) {
        return "Mali Offline Compiler";
    }
    return "Mali Offline Compiler" + version;
}

Result<StageStatistics> maliocStage(const json& report) {
    try {
        if (const std::string errors = errorsIn(report); !errors.empty()) {
            return failure("the shader does not compile for Mali: " + errors);
        }
        const json& variant = report.at("shaders").at(0).at("variants").at(0);
        const json& cost = variant.at("performance");
        const auto longest = longestIn(cost.at("longest_path_cycles"));
        const auto total = longestIn(cost.at("total_cycles"));
        if (!longest && !total) {
            return failure("malioc tells no cycles");
        }
        const json& properties = variant.at("properties");
        StageStatistics stage;
        stage.vectorRegisters = numberIn(properties, "work_registers_used");
        stage.scalarRegisters = numberIn(properties, "uniform_registers_used");
        stage.spilledRegisters = spillsIn(properties);
        stage.loops = longest ? 0 : 1;
        stage.cycles = lanes * longest.value_or(total.value_or(0.0));
        return stage;
    } catch (const json::exception&) {
        return failure("the report of malioc has another form than that of versions 7 and 8");
    }
}

} // namespace patina
