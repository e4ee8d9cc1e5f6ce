// SPDX-License-Identifier: GPL-3.0-or-later
// What graphics cards are saved that only the code for a scene is in its program, and what a look
// takes that others have by one program with every layer in it.
#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include <sys/resource.h>

#include "benchmarks.h"
#include "material/preset_file.h"
#include "measure/prediction/predicted_subject.h"
#include "predict/family_compiler.h"
#include "statistics.h"
#include "switched_program.h"

namespace patina::benchmarks {
namespace {

constexpr std::size_t rounds = 3;
constexpr double slowCompilation = 5.0; ///< seconds; one round tells of it
constexpr const char* families = "gcn,rdna2,rdna3";
constexpr const char* timedFamily = "rdna2";

/// Is what MaterialX's default OpenPBR material takes under direct lights, by the same driver.
constexpr int instructionsOfOpenPbr = 3144;
constexpr int maxRegisters = 40;
constexpr double maxSeconds = 0.1;

Catalog shippedCatalog() {
    return loadCatalog(std::vector<BlockRoot>{{PATINA_SOURCE_DIR "/shaders", true}});
}

template <typename T>
T orExit(const Checked<T>& made) {
    if (!made) {
        fmt::print(stderr, "{}\n", text(made.error()));
        std::exit(2);
    }
    return *made;
}

ProgramText assembledText(const Scene& scene, const std::shared_ptr<const Catalog>& catalog) {
    const MeshSource none = [](const Object&) { return MeshView{}; };
    return orExit(surfaceText({scene, 0, none, catalog}));
}

/// Returns the processor time of all processes that have ended.
double secondsOfProcesses() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    const auto seconds = [](const timeval& time) {
        return double(time.tv_sec) + 1e-6 * double(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

FamilyStatistics compiled(const ProgramText& program, const char* list) {
    FamilyCompilerOptions options;
    options.memoryBytes = std::size_t(12) << 30;
    options.secondsEach = 3600.0;
    const auto chosen = gpuFamiliesIn(list);
    const auto made = compileForFamilies(*chosen, {program}, options);
    if (!made || !made->programs.front()) {
        const Error& error = made ? made->programs.front().error() : made.error();
        fmt::print(stderr, "{}\n", error.text());
        std::exit(2);
    }
    return *made->programs.front();
}

/// Returns the seconds in which glslang and the driver compile a program, without those in which
/// the driver starts.
double secondsToCompile(const ProgramText& program) {
    const ProgramText nothing{"#version 410 core\nvoid main() { gl_Position = vec4(0.0); }\n",
                              "#version 410 core\nout vec4 color;\nvoid main() { color = "
                              "vec4(0.0); }\n"};
    const auto secondsFor = [](const ProgramText& text) {
        std::vector<double> times;
        while (times.size() < rounds && (times.empty() || times.back() < slowCompilation)) {
            const double before = secondsOfProcesses();
            compiled(text, timedFamily);
            times.push_back(secondsOfProcesses() - before);
        }
        return std::ranges::min(times);
    };
    return secondsFor(program) - secondsFor(nothing);
}

/// Prints what a program takes; returns whether that is at most what it may.
bool isWithin(const std::string& what, const ProgramText& program, bool isBounded) {
    bool isKept = true;
    const auto add = [&](const std::string& where, const std::string& measured, bool isEnough,
                         const std::string& target) {
        report(what + where, measured, isEnough || !isBounded, isBounded ? target : "none");
        isKept = isKept && (isEnough || !isBounded);
    };
    for (const auto& [family, stages] : compiled(program, families)) {
        const StageStatistics& stage = stages.fragment;
        add(", " + family,
            fmt::format("{} instructions, {} VGPRs, {} waves", stage.instructions,
                        stage.vectorRegisters, stage.waves),
            4 * stage.instructions <= instructionsOfOpenPbr &&
                stage.vectorRegisters <= maxRegisters,
            fmt::format("a quarter of {}, {} VGPRs", instructionsOfOpenPbr, maxRegisters));
    }
    const double seconds = secondsToCompile(program);
    add(", compiling", fmt::format("{:.2f} s", seconds), seconds <= maxSeconds,
        fmt::format("{} s", maxSeconds));
    return isKept;
}

} // namespace

bool everythingOn() {
    const auto catalog = std::make_shared<const Catalog>(shippedCatalog());
    Scene scene = plainScene(*catalog);
    isWithin("Phong, assembled", assembledText(scene, catalog), false);
    isWithin("Phong, all effects in it", switchedText(*catalog, {catalog->find("models", "phong")}),
             false);
    isWithin("all models and effects", switchedText(*catalog, modelsByFormula(*catalog)), false);
    const auto preset = readPreset(
        PATINA_SOURCE_DIR "/presets/cook-torrance/openpbr-default.patina.json", *catalog);
    scene.objects.front().material = orExit(preset).material;
    return isWithin("OpenPBR's default look", assembledText(scene, catalog), true);
}

} // namespace patina::benchmarks
