// SPDX-License-Identifier: GPL-3.0-or-later
#include "predict/compile_request.h"

namespace patina {
namespace {

using nlohmann::json;

StageStatistics stageIn(const json& value) {
    StageStatistics stage;
    stage.instructions = value.at("instructions");
    stage.vectorRegisters = value.at("vgprs");
    stage.scalarRegisters = value.at("sgprs");
    stage.spilledRegisters = value.at("spills");
    stage.waves = value.at("waves");
    stage.lanesOfWave = value.at("lanes");
    stage.loops = value.at("loops");
    stage.latency = value.at("latency");
    stage.cycles = value.at("cycles");
    return stage;
}

} // namespace

json toJson(const CompileRequest& request) {
    json families = json::array();
    for (const CompileRequest::Family& family : request.families) {
        families.push_back({{"id", family.id}, {"chips", family.chips}, {"isMali", family.isMali}});
    }
    json programs = json::array();
    for (const ProgramText& program : request.programs) {
        programs.push_back({{"vertex", program.vertex}, {"fragment", program.fragment}});
    }
    return {{"families", families}, {"programs", programs}};
}

Result<CompileRequest> compileRequestIn(std::string_view text) {
    try {
        const json value = json::parse(text);
        CompileRequest request;
        for (const json& family : value.at("families")) {
            request.families.push_back({family.at("id"), family.at("chips"), family.at("isMali")});
        }
        for (const json& program : value.at("programs")) {
            request.programs.push_back({program.at("vertex"), program.at("fragment")});
        }
        return request;
    } catch (const json::exception& problem) {
        return failure(std::string("the request is not one: ") + problem.what());
    }
}

json toJson(const StageStatistics& statistics) {
    return {{"instructions", statistics.instructions},
            {"vgprs", statistics.vectorRegisters},
            {"sgprs", statistics.scalarRegisters},
            {"spills", statistics.spilledRegisters},
            {"waves", statistics.waves},
            {"lanes", statistics.lanesOfWave},
            {"loops", statistics.loops},
            {"latency", statistics.latency},
            {"cycles", statistics.cycles}};
}

json toJson(const Result<FamilyStatistics>& answer) {
    if (!answer) {
        return {{"error", answer.error().problem}};
    }
    json families = json::object();
    for (const auto& [family, statistics] : *answer) {
        families[family] = {{"vertex", toJson(statistics.vertex)},
                            {"fragment", toJson(statistics.fragment)}};
    }
    return {{"families", families}};
}

Result<FamilyStatistics> familyStatisticsIn(std::string_view line) {
    try {
        const json value = json::parse(line);
        if (value.contains("error")) {
            return failure(value.at("error").get<std::string>());
        }
        FamilyStatistics answer;
        for (const auto& [family, stages] : value.at("families").items()) {
            answer[family] = {stageIn(stages.at("vertex")), stageIn(stages.at("fragment"))};
        }
        return answer;
    } catch (const json::exception&) {
        return failure("the process that compiles for other graphics cards answers nonsense");
    }
}

} // namespace patina
