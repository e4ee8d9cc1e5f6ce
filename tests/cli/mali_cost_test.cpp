// SPDX-License-Identifier: GPL-3.0-or-later
// Costs on Mali cores, told by a script in the place of ARM's `malioc`.
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/patina_program.h"

namespace patina::tests::mali_cost_test {
namespace {

/// Answers as malioc does: it lists two cores, of which Patina knows one, and reports of a file of
/// SPIR-V a thousandth of its bytes as cycles. ANSWER in the environment is what it compiles to.
constexpr const char* maliocScript = R"sh(#!/bin/sh
producer='"producer": {"name": "Mali Offline Compiler", "version": [8, 5, 0], "build": "x"}'
case "$*" in
*--list*)
    echo "{\"schema\": {\"name\": \"list\", \"version\": 1}, $producer,"
    echo '"cores": [{"core": "Mali-G78", "apis": ["Vulkan"]}, {"core": "Mali-T600", "apis": []}]}'
    exit;;
esac
for file; do :; done
[ "$*" = "--format json --vulkan --core Mali-G78 $file" ] || exit 1
[ "$(od -A n -t x4 -N 4 "$file")" = " 07230203" ] || exit 1
case "$file" in "$TMPDIR"/*.frag.spv) ;; *) exit 1;; esac
cycles=$(wc -c < "$file" | awk '{ print $1 / 1000 }')
longest="[0.25, $cycles, 0.5, 0.0]"
[ "$ANSWER" != loop ] || longest='[null, null, null, null]'
if [ "$ANSWER" = error ]; then
    echo "{$producer, \"shaders\": [{\"errors\": [\"too odd\"], \"warnings\": []}]}"
    exit 1
fi
[ "$ANSWER" != nonsense ] || { echo '{"shaders": 7}'; exit; }
cat <<report
{"schema": {"name": "performance", "version": 1}, $producer,
 "shaders": [{"driver": "r40p0", "hardware": {"core": "Mali-G78"}, "notes": [], "warnings": [],
  "properties": [{"name": "has_uniform_computation", "value": true}],
  "variants": [{"name": "Main",
   "properties": [{"name": "work_registers_used", "value": 32},
                  {"name": "uniform_registers_used", "value": 40},
                  {"name": "thread_occupancy", "value": 100},
                  {"name": "has_stack_spilling", "value": true},
                  {"name": "stack_spill_bytes", "value": 12}],
   "performance": {"pipelines": ["arith_total", "arith_fma", "load_store", "texture"],
    "longest_path_cycles": {"bound_pipelines": ["arith_fma"], "cycle_count": $longest},
    "shortest_path_cycles": {"bound_pipelines": ["texture"], "cycle_count": [0, 0, 0, 1]},
    "total_cycles": {"bound_pipelines": ["arith_fma"], "cycle_count": [0, 77.5, 0, 0]}}}]}]}
report
)sh";

class MaliCost : public testing::Test {
  protected:
    MaliCost() {
        writeFile(folder_ / "malioc", maliocScript);
        std::filesystem::permissions(folder_ / "malioc", std::filesystem::perms::owner_all);
    }

    Outcome patinaWithMalioc(const std::vector<std::string>& arguments,
                             const std::string& answer = "cycles") const {
        return patina(Start{.arguments = arguments,
                            .environment = {{"PATH", folder_.path().string() + ":/usr/bin:/bin"},
                                            {"ANSWER", answer},
                                            {"TMPDIR", folder_.path().string()}},
                            .input = {}});
    }

    nlohmann::json stageOf(const std::string& model, const std::string& answer = "cycles") const {
        const Outcome outcome =
            patinaWithMalioc({"cost", "--model", model, "--mesh", "builtin:sphere", "--gpu",
                              "mali-g78,rdna2", "--as-it-is", "--json"},
                             answer);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        const auto json = nlohmann::json::parse(outcome.out);
        EXPECT_NE(json.at("driver").get<std::string>().find("Mali Offline Compiler 8.5.0 and Mesa"),
                  std::string::npos)
            << json.at("driver");
        const auto& families = json.at("presets").at(0).at("ways").at(0).at("families");
        EXPECT_GT(families.at("rdna2").at("instructions"), 100);
        return families.at("mali-g78");
    }

    TemporaryFolder folder_;
};

TEST_F(MaliCost, OfACore_IsTheLongestPipelineOfItsLongestPath) {
    const nlohmann::json lambert = stageOf("lambert");
    EXPECT_GT(stageOf("strauss").at("cycles"), lambert.at("cycles"));
    EXPECT_GT(lambert.at("cycles"), 64.0 * 1.0);
    EXPECT_EQ(lambert.at("vgprs"), 32);
    EXPECT_EQ(lambert.at("sgprs"), 40);
    EXPECT_EQ(lambert.at("spills"), 3) << "of 12 bytes";
    EXPECT_EQ(lambert.at("loops"), 0);
    EXPECT_FALSE(lambert.contains("instructions")) << "malioc does not count them";
    EXPECT_NEAR(lambert.at("milliseconds").at("Google Pixel 6").get<double>(),
                lambert.at("cycles").get<double>() * 32400.0 / (20.0 * 848.0 * 1e3), 1e-5);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()),
                            std::filesystem::directory_iterator()),
              1)
        << "temporary files are gone";
}

TEST_F(MaliCost, OfLoopsThatRunUnknownTimes_CountsEachInstructionOnce) {
    const nlohmann::json stage = stageOf("lambert", "loop");
    EXPECT_EQ(stage.at("cycles"), 64.0 * 77.5);
    EXPECT_EQ(stage.at("loops"), 1);
}

TEST_F(MaliCost, TextOfACore_SaysWhatIsCounted) {
    const Outcome outcome =
        patinaWithMalioc({"cost", gold, "--mesh", "builtin:sphere", "--gpu", "mali-g78"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    for (const char* word : {"Mali-G78", "Google Pixel 6", "20 compute units at 848 MHz",
                             "Mali Offline Compiler 8.5.0", "cycles of a core"}) {
        EXPECT_NE(outcome.out.find(word), std::string::npos) << word << '\n' << outcome.out;
    }
}

TEST_F(MaliCost, WhatMaliocRefusesOrGarbles_IsSaid) {
    const std::vector<std::string> command{"cost",  gold,       "--mesh",    "builtin:sphere",
                                           "--gpu", "mali-g78", "--as-it-is"};
    for (const auto& [answer, words] :
         {std::pair("error", "too odd"), {"nonsense", "another form"}}) {
        const Outcome outcome = patinaWithMalioc(command, answer);
        EXPECT_NE((outcome.out + outcome.err).find(words), std::string::npos)
            << outcome.out << outcome.err;
    }
}

TEST_F(MaliCost, CoreThatMaliocDoesNotKnow_IsNoFamily) {
    const Outcome outcome = patinaWithMalioc({"cost", gold, "--gpu", "mali-g710"});
    EXPECT_NE(outcome.exitCode, 0);
    EXPECT_NE(outcome.err.find("mali-g78"), std::string::npos) << outcome.err;
}

TEST_F(MaliCost, WithoutMalioc_SaysThatItIsNeeded) {
    const Outcome outcome = patina({"cost", gold, "--mesh", "builtin:sphere", "--gpu", "mali-g78"});
    EXPECT_NE(outcome.exitCode, 0);
    EXPECT_NE(outcome.err.find("need malioc in the path"), std::string::npos) << outcome.err;
}

} // namespace
} // namespace patina::tests::mali_cost_test
