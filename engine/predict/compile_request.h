// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/error.h"

namespace patina {

/// Holds the text of a program's stages, in GLSL.
struct ProgramText {
    std::string vertex;
    std::string fragment;

    friend auto operator<=>(const ProgramText&, const ProgramText&) = default;
};

/// Is what `patina-cost` reads on its standard input, as JSON: programs, each to be compiled for
/// each family. It answers with lines of JSON: its driver's version, then each program's answer.
struct CompileRequest {
    struct Family {
        std::string id;
        std::vector<std::string> chips; ///< are names of RADV, of which the first known one is used
        bool isMali = false;            ///< `malioc` compiles for it; its core is the one chip
    };
    std::vector<Family> families;
    std::vector<ProgramText> programs;
};

/// Holds what a driver says of one compiled stage. malioc says nothing of instructions, waves,
/// lanes and latency; those are 0.
struct StageStatistics {
    int instructions = 0;
    int vectorRegisters = 0;
    int scalarRegisters = 0;
    int spilledRegisters = 0;
    int waves = 0;        ///< counts those that a SIMD unit holds at a time
    int lanesOfWave = 0;  ///< is 32 or 64
    int loops = 0;        ///< counts those that run as often as the compiler guesses
    double latency = 0.0; ///< cycles from the first instruction of a wave to its last
    double cycles = 0.0;  ///< is the inverse throughput: cycles of a SIMD unit for 64 lanes
    /// Is the mean number of rounds of loops that run a different number of times in each pixel,
    /// which are not among the guessed ones; 0 where there are none.
    double countedRounds = 0.0;

    friend bool operator==(const StageStatistics&, const StageStatistics&) = default;
};

struct PipelineStatistics {
    StageStatistics vertex;
    StageStatistics fragment;

    friend bool operator==(const PipelineStatistics&, const PipelineStatistics&) = default;
};

/// Maps the id of a family to what a program is there.
using FamilyStatistics = std::map<std::string, PipelineStatistics>;

/// Return requests and answers as JSON, and read them; what is none is an error.
nlohmann::json toJson(const CompileRequest& request);
Result<CompileRequest> compileRequestIn(std::string_view text);
nlohmann::json toJson(const StageStatistics& statistics);
nlohmann::json toJson(const Result<FamilyStatistics>& answer);
Result<FamilyStatistics> familyStatisticsIn(std::string_view line);

} // namespace patina
