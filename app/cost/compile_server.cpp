// SPDX-License-Identifier: GPL-3.0-or-later
#include "cost/compile_server.h"

#include <utility>
#include <vector>

#include "predict/compile_request.h"
#include "vulkan/null_device.h"
#include "vulkan/spirv_program.h"

namespace patina {
namespace {

struct FamilyDevice {
    std::string family;
    NullDevice device;
};

int number(const NullDevice::Statistics& statistics, const std::string& name) {
    const auto found = statistics.find(name);
    return found == statistics.end() ? 0 : int(found->second);
}

StageStatistics stageStatistics(const NullDevice::Statistics& numbers) {
    StageStatistics stage;
    stage.instructions = number(numbers, "Instructions");
    stage.vectorRegisters = number(numbers, "VGPRs");
    stage.scalarRegisters = number(numbers, "SGPRs");
    stage.spilledRegisters = number(numbers, "Spilled VGPRs") + number(numbers, "Spilled SGPRs");
    stage.waves = number(numbers, "Subgroups per SIMD");
    stage.lanesOfWave = number(numbers, "Subgroup size");
    stage.loops = number(numbers, "Loops");
    stage.latency = number(numbers, "Latency");
    stage.cycles = number(numbers, "Inverse Throughput");
    return stage;
}

Result<FamilyStatistics> compiled(const ProgramText& text,
                                  const std::vector<FamilyDevice>& devices) {
    const auto program = spirvProgram(text.vertex, text.fragment);
    if (!program) {
        return tl::unexpected(program.error());
    }
    FamilyStatistics answer;
    for (const FamilyDevice& each : devices) {
        auto stages = each.device.compile(*program);
        if (!stages) {
            return tl::unexpected(stages.error());
        }
        answer[each.family] = {stageStatistics((*stages)["vertex"]),
                               stageStatistics((*stages)["fragment"])};
    }
    return answer;
}

} // namespace

int serveCompilation(const std::string& text, const std::function<void(const std::string&)>& tell) {
    const auto tellError = [&](const Error& error) {
        tell(nlohmann::json{{"error", error.text()}}.dump());
        return 1;
    };
    const auto request = compileRequestIn(text);
    if (!request) {
        return tellError(request.error());
    }
    std::vector<FamilyDevice> devices;
    for (const CompileRequest::Family& family : request->families) {
        auto device = NullDevice::create(family.chips);
        if (!device) {
            return tellError(device.error());
        }
        devices.push_back({family.id, std::move(*device)});
    }
    const std::string driver = devices.empty() ? std::string() : devices.front().device.driver();
    tell(nlohmann::json{{"driver", driver}}.dump());
    for (const ProgramText& program : request->programs) {
        tell(toJson(compiled(program, devices)).dump());
    }
    return 0;
}

} // namespace patina
