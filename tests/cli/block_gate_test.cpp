// SPDX-License-Identifier: GPL-3.0-or-later
// What users add to the blocks is compiled in a process of its own before it is in this one.
#include <gtest/gtest.h>

#include "cli/patina_program.h"
#include "gl/headless_context.h"
#include "shading/effects/block_trial.h"
#include "trial/trial_gate.h"

namespace patina::tests::block_gate_test {
namespace {

constexpr const char* good = "    return p.tint * d.nl;\n";

/// 2^36 sums, in 36 lines.
std::string macroBomb() {
    std::string text = "#define M0 d.nl\n";
    for (int i = 1; i <= 36; ++i) {
        const std::string before = "M" + std::to_string(i - 1);
        text += "#define M" + std::to_string(i) + " " + before + " + " + before + "\n";
    }
    return text + "    return vec3(M36);\n";
}

constexpr const char* hugeArray = "    float kept[500000000];\n"
                                  "    for (int i = 0; i < 500000000; ++i) {\n"
                                  "        kept[i] = d.nl * float(i);\n"
                                  "    }\n"
                                  "    return vec3(kept[int(d.nl * 1.0e8)]);\n";

constexpr const char* endlessLoop = "    float sum = d.nl;\n"
                                    "    while (sum > -1.0) {\n"
                                    "        sum = abs(sin(sum)) + d.nl * d.nl;\n"
                                    "    }\n"
                                    "    return vec3(sum);\n";

class TrialGateTest : public testing::Test {
  protected:
    void write(const std::string& id, const std::string& body) {
        std::filesystem::create_directories(own_ / "models");
        writeFile(own_ / ("models/" + id + ".json"), R"({
            "id": ")" + id + R"(", "version": 1, "label": ")" +
                                                         id + R"(", "summary": "For tests.",
            "applications": "Tests.", "source": "None", "doc": "For tests.",
            "parameters": [{"id": "tint", "label": "Tint", "type": "color", "default": [1, 0, 0],
                            "min": 0, "max": 1, "doc": "Its colour."}],
            "claims": ["finite"]})");
        writeFile(own_ / ("models/" + id + ".glsl"),
                  "// SPDX-License-"
                  "Identifier: MIT-0\n#include \"lib/directions.glsl\"\nvec3 " +
                      id + "(Directions d, " + char(std::toupper(id.front())) + id.substr(1) +
                      " p) {\n" + body + "}\n");
    }

    /// The user's blocks as they stand in programs.
    std::vector<StrangerBlock> strangers() const {
        const std::vector<BlockRoot> roots{{shipped("shaders"), true}, {own_.path(), false}};
        const Catalog catalog = loadCatalog(roots);
        EXPECT_EQ(text(catalog.errors), "");
        std::vector<StrangerBlock> blocks;
        for (const Block& block : catalog.blocks) {
            if (!block.shipped) {
                const auto source = trialProgram(block, catalog);
                EXPECT_TRUE(source) << (source ? "" : text(source.error()));
                blocks.insert(blocks.end(), source->fragment.strangers.begin(),
                              source->fragment.strangers.end());
            }
        }
        return blocks;
    }

    TrialGate::Options options(TrialLimits limits = {}) const {
        return {patinaProgram(), kept_.path(), limits};
    }

    std::string answerOf(TrialGate& gate) { return text(gate.ask(strangers(), true).mistakes); }

    TemporaryFolder own_;
    TemporaryFolder kept_;
    std::unique_ptr<gl::HeadlessContext> context_ = gl::HeadlessContext::create().value();
};

TEST_F(TrialGateTest, GoodBlock_IsTriedOnceForAll) {
    write("homemade", good);
    TrialGate first(options());
    EXPECT_EQ(answerOf(first), "");
    EXPECT_EQ(answerOf(first), "");
    EXPECT_EQ(first.startedCount(), 1);
    TrialGate later(options());
    EXPECT_EQ(answerOf(later), "");
    EXPECT_EQ(later.startedCount(), 0);
}

TEST_F(TrialGateTest, GoodBlocks_AreTriedInOneProcess) {
    write("homemade", good);
    write("another", good);
    TrialGate gate(options());
    EXPECT_EQ(answerOf(gate), "");
    EXPECT_EQ(gate.startedCount(), 1);
}

TEST_F(TrialGateTest, MacroBomb_IsRefusedWithItsNameAndTheOthersAreNot) {
    write("abomb", macroBomb());
    write("homemade", good);
    TrialGate gate(options({.memoryBytes = std::size_t(400) << 20}));
    const std::string mistakes = answerOf(gate);
    EXPECT_NE(mistakes.find("models/abomb.glsl"), std::string::npos) << mistakes;
    EXPECT_NE(mistakes.find("\"abomb\" was not let in"), std::string::npos) << mistakes;
    EXPECT_NE(mistakes.find("more than 400 MiB of memory"), std::string::npos) << mistakes;
    EXPECT_EQ(mistakes.find("homemade"), std::string::npos) << mistakes;
}

TEST_F(TrialGateTest, HugeArray_IsRefused) {
    write("wide", hugeArray);
    TrialGate gate(options({.seconds = 2.0, .memoryBytes = std::size_t(400) << 20}));
    EXPECT_NE(answerOf(gate).find("\"wide\" was not let in"), std::string::npos);
}

TEST_F(TrialGateTest, EndlessLoop_IsRefusedWhenItsTimeIsOver) {
    write("endless", endlessLoop);
    TrialGate gate(options({.seconds = 1.0}));
    const std::string mistakes = answerOf(gate);
    EXPECT_NE(mistakes.find("takes more than 1 s of work"), std::string::npos) << mistakes;
}

TEST_F(TrialGateTest, ChangedFile_IsTriedAgain) {
    write("homemade", "    return vec3(undeclared);\n");
    TrialGate gate(options());
    EXPECT_NE(answerOf(gate).find("homemade.glsl:4:"), std::string::npos);
    EXPECT_NE(answerOf(gate).find("homemade.glsl:4:"), std::string::npos);
    EXPECT_EQ(gate.startedCount(), 1);
    write("homemade", good);
    EXPECT_EQ(answerOf(gate), "");
    EXPECT_EQ(gate.startedCount(), 2);
}

/// The process reads the files for itself, and they may be others by then.
TEST_F(TrialGateTest, HarmOfAFileThatTookAnothersPlace_IsNotHeldAgainstTheOther) {
    write("homemade", good);
    const std::vector<StrangerBlock> asked = strangers();
    write("homemade", endlessLoop);
    TrialGate gate(options({.seconds = 2.0}));
    EXPECT_FALSE(gate.ask(asked, true).isFinal);
    write("homemade", good);
    EXPECT_EQ(answerOf(gate), "");
}

TEST_F(TrialGateTest, ThreadThatMayNotWait_IsToldOfACheck) {
    write("homemade", good);
    TrialGate gate(options());
    const BlockGate::Answer answer = gate.ask(strangers(), false);
    EXPECT_FALSE(answer.isFinal);
    EXPECT_NE(text(answer.mistakes).find("\"homemade\" is being checked"), std::string::npos);
    EXPECT_EQ(gate.startedCount(), 0);
}

TEST_F(TrialGateTest, MissingProgram_RefusesTheBlock) {
    write("homemade", good);
    TrialGate gate({"/nowhere/patina", kept_.path(), {}});
    EXPECT_NE(answerOf(gate).find("cannot start /nowhere/patina"), std::string::npos);
}

TEST_F(TrialGateTest, Render_RefusesABombAndLivesOn) {
    write("abomb", macroBomb());
    const TemporaryFolder data;
    std::filesystem::create_directory(data / "patina");
    std::filesystem::copy(own_.path(), data / "patina/shaders",
                          std::filesystem::copy_options::recursive);
    const Outcome outcome =
        run("/bin/bash", // which gives it less memory than it would take, so that it ends sooner
            Start{.arguments = {"-c", "ulimit -d 500000 && exec " + patinaProgram().string() +
                                          " render --model abomb --size 16x16 -o -"},
                  .environment = {{"XDG_DATA_HOME", data.path()},
                                  {"XDG_CACHE_HOME", kept_.path()},
                                  {"DISPLAY", ""},
                                  {"WAYLAND_DISPLAY", ""}},
                  .input = {}});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("\"abomb\" was not let in"), std::string::npos) << outcome.err;
}

} // namespace
} // namespace patina::tests::block_gate_test
