// SPDX-License-Identifier: GPL-3.0-or-later
// Presets worked on in shards: what is merged is what one process writes, and nothing is done
// twice.
#include <algorithm>
#include <filesystem>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/patina_program.h"

namespace patina::tests::job_test {
namespace {

namespace fs = std::filesystem;

using Arguments = std::vector<std::string>;

/// A folder with six presets of two models.
class Job : public testing::Test {
  protected:
    Job() {
        for (int i = 0; i < 6; ++i) {
            writePreset(i, 0.1 * i);
        }
    }

    void writePreset(int i, double grey) const {
        const std::string model = i % 2 == 0 ? "lambert" : "minnaert";
        writeFile(preset(i), nlohmann::json{{"format", "patina.preset"},
                                            {"version", 1},
                                            {"name", "Test"},
                                            {"model", {{"id", model}, {"version", 1}}},
                                            {"parameters", {{"diffuse.color", {grey, grey, 0.5}}}}}
                                 .dump());
    }

    std::string preset(int i) const {
        return folder_ / ("preset" + std::to_string(i) + ".patina.json");
    }

    std::string file(const std::string& name) const { return folder_ / name; }

    /// A command with all presets and with `more`.
    Arguments command(const std::string& name, const Arguments& more) const {
        Arguments arguments{name};
        for (int i = 0; i < 6; ++i) {
            arguments.push_back(preset(i));
        }
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }

    /// Checks all presets, or a shard of them, into a file of results.
    Outcome check(const std::string& results, Arguments more = {}) const {
        more.insert(more.end(), {"--cases", "40", "--results", file(results)});
        return patina(command("check", more));
    }

    /// Draws all presets, or a shard of them, into a folder.
    Outcome render(const std::string& pictures, const std::string& results,
                   Arguments more = {}) const {
        more.insert(more.end(), {"--mesh", "builtin:sphere", "--size", "16x16", "-o",
                                 file(pictures) + "/", "--results", file(results)});
        return patina(command("render", more));
    }

    Outcome merge(const Arguments& results) const {
        Arguments arguments{"merge", "-o", file("merged")};
        for (const std::string& each : results) {
            arguments.push_back(file(each));
        }
        return patina(arguments);
    }

    std::string textOf(const std::string& name) const { return readFile(folder_ / name); }

    std::vector<std::string> linesOf(const std::string& name) const {
        std::vector<std::string> lines;
        std::istringstream stream(textOf(name));
        for (std::string line; std::getline(stream, line);) {
            lines.push_back(line);
        }
        return lines;
    }

    /// Writes results whose presets have the numbers as results.
    void writeResults(const std::string& name, int shard, const std::vector<int>& numbers,
                      const std::string& option = "a") const {
        std::string text = nlohmann::json{{"format", "patina.results"},
                                          {"version", 1},
                                          {"command", "check"},
                                          {"presets", 4},
                                          {"shard", shard},
                                          {"shards", 2},
                                          {"options", option}}
                               .dump() +
                           '\n';
        for (const int number : numbers) {
            text += resultOf(number, number);
        }
        writeFile(folder_ / name, text);
    }

    static std::string resultOf(int number, int result) {
        return nlohmann::json{{"number", number},
                              {"preset", "p" + std::to_string(number)},
                              {"content", "c"},
                              {"result", {{"is", result}}}}
                   .dump() +
               '\n';
    }

    /// Expects that a merge fails with a message that has all of these, and writes nothing.
    void expectRefused(const Arguments& results, const Arguments& messages) const {
        const Outcome outcome = merge(results);
        EXPECT_EQ(outcome.exitCode, 1);
        for (const std::string& message : messages) {
            EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
        }
        EXPECT_FALSE(fs::exists(folder_ / "merged"));
    }

    TemporaryFolder folder_;
};

TEST_F(Job, MergedChecksOfShards_AreThoseOfOneProcess) {
    ASSERT_EQ(check("whole").exitCode, 0);
    for (const std::string shard : {"1", "2", "3"}) {
        const Outcome outcome = check(shard, {"--shard", shard + "/3"});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_EQ(linesOf(shard).size(), 3u) << textOf(shard);
    }
    ASSERT_EQ(merge({"3", "1", "2"}).exitCode, 0);
    EXPECT_EQ(textOf("merged"), textOf("whole"));
}

TEST_F(Job, MergedPicturesOfShards_AreThoseOfOneProcess) {
    ASSERT_EQ(render("a", "whole").exitCode, 0);
    for (const std::string shard : {"1", "2"}) {
        const Outcome outcome = render("b", shard, {"--shard", shard + "/2"});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    }
    ASSERT_EQ(merge({"1", "2"}).exitCode, 0);
    EXPECT_EQ(textOf("merged"), textOf("whole"));
    for (int i = 0; i < 6; ++i) {
        const std::string name = "/preset" + std::to_string(i) + ".png";
        ASSERT_FALSE(textOf("a" + name).empty());
        EXPECT_EQ(textOf("a" + name), textOf("b" + name)) << name;
    }
}

TEST_F(Job, MergedExportsOfShards_AreThoseOfOneProcess) {
    const auto exported = [this](const std::string& folder, const std::string& results,
                                 Arguments more) {
        more.insert(more.end(),
                    {"--no-pictures", "-o", file(folder) + "/", "--results", file(results)});
        return patina(command("export", more));
    };
    ASSERT_EQ(exported("a", "whole", {}).exitCode, 0);
    for (const std::string shard : {"1", "2"}) {
        const Outcome outcome = exported("b", shard, {"--shard", shard + "/2"});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    }
    ASSERT_EQ(merge({"1", "2"}).exitCode, 0);
    EXPECT_EQ(textOf("merged"), textOf("whole"));
    for (int i = 0; i < 6; ++i) {
        const std::string name = "/preset" + std::to_string(i) + ".zip";
        ASSERT_FALSE(textOf("a" + name).empty());
        EXPECT_EQ(textOf("a" + name), textOf("b" + name)) << name;
    }
    fs::remove(folder_ / "a/preset3.zip");
    EXPECT_NE(exported("a", "whole", {}).out.find("1 done now, 5 before"), std::string::npos);
    ASSERT_EQ(patina({"import", file("a/preset3.zip"), "--into", file("out")}).exitCode, 0);
    EXPECT_TRUE(fs::exists(folder_ / "out/preset3/preset3.patina.json"));
}

TEST_F(Job, MergedPredictionsOfShards_AreThoseOfOneProcessAndWithoutAJob) {
    const auto predicted = [this](const std::string& results, Arguments more) {
        more.insert(more.end(), {"--gpu", "rdna2", "--as-it-is", "--results", file(results)});
        return patina(command("cost", more));
    };
    const Outcome outcome = predicted("whole", {});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    ASSERT_EQ(predicted("1", {"--shard", "1/2"}).exitCode, 0);
    ASSERT_EQ(predicted("2", {"--shard", "2/2"}).exitCode, 0);
    ASSERT_EQ(merge({"1", "2"}).exitCode, 0);
    EXPECT_EQ(textOf("merged"), textOf("whole"));
    const Outcome alone = patina({"cost", preset(1), "--gpu", "rdna2", "--as-it-is", "--json"});
    EXPECT_EQ(nlohmann::json::parse(linesOf("whole").at(2)).at("result").at("ways"),
              nlohmann::json::parse(alone.out).at("presets").at(0).at("ways"));
}

TEST_F(Job, MergedPlotsOfShards_AreThoseOfOneProcessAndWithoutAJob) {
    const auto plotted = [this](const std::string& folder, const std::string& results,
                                Arguments more) {
        more.insert(more.end(), {"-o", file(folder) + "/", "--results", file(results)});
        return patina(command("lobe", more));
    };
    const Outcome outcome = plotted("a", "whole", {});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    ASSERT_EQ(plotted("b", "1", {"--shard", "1/2"}).exitCode, 0);
    ASSERT_EQ(plotted("b", "2", {"--shard", "2/2"}).exitCode, 0);
    ASSERT_EQ(merge({"1", "2"}).exitCode, 0);
    EXPECT_EQ(textOf("merged"), textOf("whole"));
    ASSERT_EQ(patina({"lobe", preset(3), "-o", file("alone.svg")}).exitCode, 0);
    EXPECT_EQ(textOf("b/preset3.svg"), textOf("alone.svg"));
    fs::remove(folder_ / "a/preset3.svg");
    EXPECT_NE(plotted("a", "whole", {}).out.find("1 done now, 5 before"), std::string::npos);
}

TEST_F(Job, NumbersOfPlots_AreThoseWithoutAJob) {
    ASSERT_EQ(patina(command("lobe", {"--results", file("whole")})).exitCode, 0);
    EXPECT_EQ(nlohmann::json::parse(linesOf("whole").at(2)).at("result").at("csv"),
              patina({"lobe", preset(1)}).out);
    const Outcome together =
        patina(command("lobe", {"-o", file("all.svg"), "--results", file("other")}));
    EXPECT_EQ(together.exitCode, 1);
    EXPECT_NE(together.err.find("FOLDER/"), std::string::npos) << together.err;
}

TEST_F(Job, MergedMistakesOfShards_AreThoseOfOneProcess) {
    writeFile(preset(4), "{");
    const auto validated = [this](const std::string& results, Arguments more) {
        more.insert(more.end(), {"--results", file(results)});
        return patina(command("validate", more));
    };
    const Outcome whole = validated("whole", {});
    EXPECT_EQ(whole.exitCode, 1);
    EXPECT_NE(whole.out.find("0 failed, 1 found wanting"), std::string::npos) << whole.out;
    EXPECT_EQ(validated("1", {"--shard", "1/2"}).exitCode, 1);
    EXPECT_EQ(validated("2", {"--shard", "2/2"}).exitCode, 0);
    ASSERT_EQ(merge({"1", "2"}).exitCode, 0);
    EXPECT_EQ(textOf("merged"), textOf("whole"));
}

TEST_F(Job, SecondStart_LeavesWholeLinesAloneAndDoesTheCutOne) {
    ASSERT_EQ(check("whole").exitCode, 0);
    std::vector<std::string> lines = linesOf("whole");
    ASSERT_EQ(lines.size(), 7u);
    nlohmann::json marked = nlohmann::json::parse(lines[1]);
    marked["result"]["mark"] = "from the first start";
    lines[1] = marked.dump();
    const std::string kept = lines[0] + '\n' + lines[1] + '\n' + lines[2] + '\n';
    writeFile(folder_ / "cut", kept + lines[3].substr(0, lines[3].size() / 2));
    const Outcome outcome = check("cut");
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("4 done now, 2 before"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.err.find("was cut off"), std::string::npos) << outcome.err;
    std::string expected = kept;
    for (std::size_t i = 3; i < lines.size(); ++i) {
        expected += lines[i] + '\n';
    }
    EXPECT_EQ(textOf("cut"), expected);
}

TEST_F(Job, KilledProcess_LosesNoFinishedWork) {
    constexpr const char* script = R"sh(
results=$1; shift
"$@" & program=$!
for try in $(seq 600); do
    [ -f "$results" ] && [ "$(wc -l < "$results")" -ge 3 ] && break
    sleep 0.02
done
kill -KILL "$program"
wait "$program"
)sh";
    Arguments arguments = command("check", {"--cases", "40", "--results", file("killed")});
    arguments.insert(arguments.begin(),
                     {"-c", script, "sh", file("killed"), patinaProgram().string()});
    run("/bin/sh",
        Start{.arguments = arguments,
              .environment = {{"XDG_DATA_HOME", file("data")}, {"XDG_CACHE_HOME", file("cache")}},
              .input = {}});
    const std::string before = textOf("killed");
    const std::string whole = before.substr(0, before.rfind('\n') + 1);
    ASSERT_GE(std::ranges::count(whole, '\n'), 3);
    ASSERT_EQ(check("killed").exitCode, 0);
    EXPECT_TRUE(textOf("killed").starts_with(whole));
    ASSERT_EQ(check("whole").exitCode, 0);
    EXPECT_EQ(textOf("killed"), textOf("whole"));
}

TEST_F(Job, ChangedPreset_IsDoneAgainAlone) {
    ASSERT_EQ(check("results").exitCode, 0);
    writePreset(2, 0.9);
    const Outcome outcome = check("results");
    EXPECT_NE(outcome.out.find("1 done now, 5 before"), std::string::npos) << outcome.out;
    EXPECT_EQ(linesOf("results").size(), 8u);
    ASSERT_EQ(check("fresh").exitCode, 0);
    ASSERT_EQ(merge({"results"}).exitCode, 0);
    EXPECT_EQ(textOf("merged"), textOf("fresh"));
}

TEST_F(Job, PictureThatIsGone_IsDrawnAgain) {
    ASSERT_EQ(render("a", "results").exitCode, 0);
    fs::remove(folder_ / "a/preset3.png");
    const Outcome outcome = render("a", "results");
    EXPECT_NE(outcome.out.find("1 done now, 5 before"), std::string::npos) << outcome.out;
    EXPECT_TRUE(fs::exists(folder_ / "a/preset3.png"));
    EXPECT_EQ(linesOf("results").size(), 7u) << "the same result is not written twice";
}

TEST_F(Job, PresetThatCannotBeRead_FailsAloneAndIsTriedAgain) {
    fs::remove(preset(1));
    const Outcome failed = check("results");
    EXPECT_EQ(failed.exitCode, 1);
    EXPECT_NE(failed.out.find("6 done now, 0 before; 1 failed"), std::string::npos) << failed.out;
    EXPECT_NE(failed.err.find("preset1.patina.json"), std::string::npos) << failed.err;
    const Outcome merged = merge({"results"});
    EXPECT_NE(merged.err.find("1 failed, the first is " + preset(1)), std::string::npos)
        << merged.err;
    writePreset(1, 0.1);
    EXPECT_EQ(check("results").exitCode, 0);
    ASSERT_EQ(check("fresh").exitCode, 0);
    ASSERT_EQ(merge({"results"}).exitCode, 0);
    EXPECT_EQ(textOf("merged"), textOf("fresh"));
}

TEST_F(Job, ShareWithoutPresets_HasNoResults) {
    const Outcome outcome = check("results", {"--shard", "9/9"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(linesOf("results").size(), 1u);
}

TEST_F(Job, ShardThatIsNone_IsRefusedBeforeAnythingIsWritten) {
    for (const std::string shard : {"0/4", "5/4", "a/b", "-1/4", "1/-4", "1e9/1e9", "3", "3/", "/4",
                                    "1/4/2", "", " 1/2", "1/99999999999999999999999"}) {
        const Outcome outcome = check("results", {"--shard=" + shard});
        EXPECT_EQ(outcome.exitCode, 1) << shard;
        EXPECT_NE(outcome.err.find("--shard"), std::string::npos) << shard << outcome.err;
        EXPECT_FALSE(fs::exists(folder_ / "results")) << shard;
    }
}

TEST_F(Job, ShardWithoutAFileOfResults_IsRefused) {
    const Outcome outcome = patina(command("check", {"--shard", "1/2"}));
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("--results"), std::string::npos) << outcome.err;
}

TEST_F(Job, ResultsOfOtherOptions_AreKept) {
    ASSERT_EQ(check("results", {"--shard", "1/6"}).exitCode, 0);
    const std::string before = textOf("results");
    const Outcome options =
        patina(command("check", {"--cases", "41", "--shard", "1/6", "--results", file("results")}));
    EXPECT_EQ(options.exitCode, 1);
    EXPECT_NE(options.err.find("results:1:1: these are results of other work, which differs in: "
                               "options"),
              std::string::npos)
        << options.err;
    EXPECT_NE(check("results", {"--shard", "2/6"}).err.find("differs in: shard"),
              std::string::npos);
    EXPECT_EQ(textOf("results"), before);
}

TEST_F(Job, FileOfAnythingElse_IsKept) {
    const std::string before = readFile(preset(0));
    const Outcome outcome = check("preset0.patina.json");
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("this is no file of results"), std::string::npos) << outcome.err;
    EXPECT_EQ(readFile(preset(0)), before);
}

TEST_F(Job, DamagedLine_IsNamedByItsNumber) {
    ASSERT_EQ(check("results", {"--shard", "1/3"}).exitCode, 0);
    const std::vector<std::string> lines = linesOf("results");
    const std::string damaged = lines[0] + "\n{\"number\": 1, \n" + lines[2] + '\n';
    writeFile(folder_ / "results", damaged);
    const Outcome outcome = check("results", {"--shard", "1/3"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("results:2:"), std::string::npos) << outcome.err;
    EXPECT_EQ(textOf("results"), damaged);
}

TEST_F(Job, PlaceThatTakesNoFile_IsSaid) {
    for (const std::string place : {"none/results", "."}) {
        const Outcome outcome = check(place);
        EXPECT_EQ(outcome.exitCode, 1);
        EXPECT_NE(outcome.err.find("cannot be written"), std::string::npos) << outcome.err;
    }
    EXPECT_NE(check("/../../../../../../dev/null").err.find("is not an ordinary file"),
              std::string::npos);
}

TEST_F(Job, FileThatAnotherProcessWrites_IsLeftToIt) {
    writeFile(folder_ / "results", "");
    Arguments arguments = command("check", {"--cases", "40", "--results", file("results")});
    arguments.insert(arguments.begin(), {file("results"), patinaProgram().string()});
    const Outcome outcome =
        run("/usr/bin/flock", Start{.arguments = arguments,
                                    .environment = {{"XDG_CACHE_HOME", file("cache")}},
                                    .input = {}});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("another process is writing"), std::string::npos) << outcome.err;
    EXPECT_EQ(textOf("results"), "");
}

TEST_F(Job, MergeOfOneShardTwice_TakesItOnce) {
    writeResults("1", 1, {1, 3});
    writeResults("2", 2, {4, 2});
    ASSERT_EQ(merge({"1", "2", "1"}).exitCode, 0);
    EXPECT_EQ(linesOf("merged").size(), 5u);
    EXPECT_EQ(linesOf("merged")[2] + '\n', resultOf(2, 2));
}

TEST_F(Job, MergeWithoutAShard_SaysWhichIsMissing) {
    writeResults("1", 1, {1, 3});
    expectRefused({"1"}, {"shard 2/2 is missing"});
}

TEST_F(Job, MergeOfAnUnfinishedShard_SaysWhatIsMissing) {
    writeResults("1", 1, {1, 3});
    writeResults("2", 2, {2});
    expectRefused({"1", "2"}, {"shard 2/2 has no result of preset 4 of 4"});
}

TEST_F(Job, MergeOfOtherOptions_IsRefused) {
    writeResults("1", 1, {1, 3});
    writeResults("2", 2, {2, 4}, "b");
    expectRefused({"1", "2"}, {file("2") + ":1:1: ", "differ in: options"});
}

TEST_F(Job, MergeOfTwoResultsOfAPreset_NamesBothPlaces) {
    writeResults("1", 1, {1, 3});
    writeResults("2", 2, {2, 4});
    writeResults("again", 1, {1});
    writeFile(folder_ / "again", textOf("again") + resultOf(3, 7));
    expectRefused({"1", "2", "again"},
                  {file("again") + ":3:1: p3 has another result at " + file("1") + ":3"});
}

TEST_F(Job, MergeOfACutLine_IsRefused) {
    writeResults("1", 1, {1, 3});
    writeResults("2", 2, {2});
    writeFile(folder_ / "2", textOf("2") + resultOf(4, 4).substr(0, 20));
    expectRefused({"1", "2"}, {file("2") + ":3:1: the line is cut off"});
}

TEST_F(Job, MergeOfAPresetOfAnotherShard_IsRefused) {
    writeResults("1", 1, {1, 2});
    expectRefused({"1"}, {file("1") + ":3:1: preset 2 is none of shard 1/2"});
}

TEST_F(Job, MergeOfNoFileOfResults_IsRefused) {
    writeFile(folder_ / "1", "{}\n");
    expectRefused({"1"}, {file("1") + ":1:1: this is no file of results"});
    expectRefused({"2"}, {file("2")});
}

TEST_F(Job, CostsOfShards_AreMergedIntoOneFileOfCharts) {
    const auto cost = [this](const std::string& shard) {
        return patina({"cost", preset(0), preset(1), "--seconds", "1", "--size", "32x32", "--mesh",
                       "builtin:sphere", "--singles", "--results", file(shard), "--shard",
                       shard + "/2"});
    };
    for (const std::string shard : {"1", "2"}) {
        const Outcome outcome = cost(shard);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    }
    EXPECT_NE(cost("2").out.find("0 done now, 1 before"), std::string::npos);
    ASSERT_EQ(merge({"1", "2"}).exitCode, 0);
    const std::vector<std::string> lines = linesOf("merged");
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_FALSE(nlohmann::json::parse(lines[2])["result"]["points"].empty()) << lines[2];
}

TEST_F(Job, PresetsWhosePicturesHaveOneName_AreRefused) {
    fs::create_directory(folder_ / "more");
    fs::copy(preset(0), folder_ / "more");
    const Outcome outcome = patina(
        {"render", preset(0), folder_ / "more/preset0.patina.json", "-o", file("pictures") + "/"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("preset0.png would take the place"), std::string::npos)
        << outcome.err;
    EXPECT_FALSE(fs::exists(folder_ / "pictures"));
}

TEST_F(Job, SeveralPresetsIntoOneFile_AreRefused) {
    const Outcome outcome = patina({"render", preset(0), preset(1), "-o", file("a.png")});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("-o FOLDER/"), std::string::npos) << outcome.err;
}

TEST_F(Job, ResultsOfAnExportIntoOneFile_AreRefused) {
    const Outcome outcome =
        patina({"export", preset(0), "-o", file("a.zip"), "--results", file("results")});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("-o FOLDER/"), std::string::npos) << outcome.err;
}

TEST_F(Job, PicturesInAFolder_AreThoseOfSinglePresets) {
    const Arguments how{"--mesh", "builtin:sphere", "--size", "16x16", "-o"};
    const auto render = [&](Arguments arguments, const std::string& output) {
        arguments.insert(arguments.begin(), "render");
        arguments.insert(arguments.end(), how.begin(), how.end());
        arguments.push_back(output);
        return patina(arguments).exitCode;
    };
    ASSERT_EQ(render({preset(0), preset(5)}, file("pictures") + "/"), 0);
    ASSERT_EQ(render({preset(5)}, file("single.png")), 0);
    EXPECT_TRUE(fs::exists(folder_ / "pictures/preset0.png"));
    EXPECT_EQ(textOf("pictures/preset5.png"), textOf("single.png"));
}

TEST_F(Job, ChecksOfSeveralSubjects_ArePrintedOneByOne) {
    const Outcome outcome = patina({"check", preset(0), "phong", "--cases", "40", "--json"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    const nlohmann::json found = nlohmann::json::parse(outcome.out);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[1]["subject"], "phong");
}

} // namespace
} // namespace patina::tests::job_test
