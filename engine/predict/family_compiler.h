// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/error.h"
#include "predict/compile_request.h"
#include "predict/gpu_family.h"

namespace patina {

/// Keeps what programs were compiled to for the same families, for commands that compile many.
struct CompiledBefore {
    std::string driver;
    std::map<ProgramText, Result<FamilyStatistics>> programs;
};

/// Says how programs are compiled for other graphics cards.
struct FamilyCompilerOptions {
    std::filesystem::path program{};                ///< is `patina-cost`; empty: beside this one
    std::size_t memoryBytes = std::size_t(2) << 30; ///< limits its data
    double secondsEach = 30.0;                      ///< limits its work on one program, CPU time
    std::function<bool()> isStopped = [] { return false; }; ///< ends it when that is true
    std::function<void(double)> onProgress = [](double) {}; ///< is told the share that is done
    std::size_t processes = 1;        ///< are at work side by side, at most; not for few programs
    CompiledBefore* before = nullptr; ///< is not compiled again, and gets what is compiled now
};

/// Holds what a driver made of programs.
struct CompiledForFamilies {
    std::string driver;                             ///< is its version, such as "Mesa 22.3.6"
    std::vector<Result<FamilyStatistics>> programs; ///< are in the order that they were given in
};

/// Compiles programs for families of graphics cards in a process of its own, and again in a new one
/// after a program that ended it. It is an error, of all programs, where the process or the driver
/// is missing or does not know a family, or it is stopped.
Result<CompiledForFamilies> compileForFamilies(std::span<const GpuFamily* const> families,
                                               std::vector<ProgramText> programs,
                                               const FamilyCompilerOptions& options = {});

} // namespace patina
