// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/patina_program.h"

namespace patina::tests::models_test {
namespace {

std::vector<std::filesystem::path> shippedDescriptors() {
    std::vector<std::filesystem::path> files;
    for (const char* folder : {"shaders", "engine/catalog/settings"}) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(shipped(folder))) {
            if (entry.path().extension() == ".json") {
                files.push_back(entry.path());
            }
        }
    }
    return files;
}

TEST(ModelsCommand, Text_NamesEveryShippedBlock) {
    const Outcome outcome = patina({"models"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    for (const auto& file : shippedDescriptors()) {
        EXPECT_NE(outcome.out.find(file.stem().string()), std::string::npos) << file;
    }
}

TEST(ModelsCommand, Text_LeavesStandardErrorEmpty) {
    EXPECT_EQ(patina({"models"}).err, "");
}

TEST(ModelsCommand, Table_IsTheOneInTheDocuments) {
    const Outcome outcome = patina({"models", "--table"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const std::string page = readFile(shipped("docs/models.md"));
    EXPECT_NE(page.find(outcome.out), std::string::npos)
        << "docs/models.md has another table; `patina models --table` prints this one:\n"
        << outcome.out;
}

TEST(ModelsCommand, Json_HasOneObjectPerShippedBlockAndThePicture) {
    const auto list = nlohmann::json::parse(patina({"models", "--json"}).out);
    EXPECT_EQ(list.size(), shippedDescriptors().size() + 1);
    EXPECT_EQ(list.back()["id"], "picture");
    EXPECT_EQ(list.back()["accuracy"][0]["id"], "samples");
}

TEST(ModelsCommand, Json_HasTheDescriptorFieldsAndTheKind) {
    for (const auto& block : nlohmann::json::parse(patina({"models", "--json"}).out)) {
        for (const char* field : {"kind", "id", "version", "label", "summary", "parameters"}) {
            EXPECT_TRUE(block.contains(field)) << block["id"] << " lacks " << field;
        }
    }
}

TEST(ModelsCommand, Json_ListsTheSwitchesOfObjectsAndLights) {
    std::map<std::string, std::string> firstSettings;
    for (const auto& block : nlohmann::json::parse(patina({"models", "--json"}).out)) {
        if (block["kind"] == "settings" && !block["parameters"].empty()) {
            firstSettings[block["id"]] = block["parameters"][0]["id"];
        }
    }
    EXPECT_EQ(firstSettings["object"], "visible");
    EXPECT_EQ(firstSettings["light"], "enabled");
}

TEST(ModelsCommand, Json_IsTheSameUnderAGermanLocale) {
    const Start german{.arguments = {"models", "--json"},
                       .environment = {{"LC_ALL", "de_DE.UTF-8"}, {"LOCPATH", localeFolder()}},
                       .input = {}};
    EXPECT_EQ(patina(german).out, patina({"models", "--json"}).out);
}

TEST(ModelsCommand, MissingShaderFolder_ExitsWithOneAndNamesIt) {
    const TemporaryFolder folder;
    const Outcome outcome = patina(Start{
        .arguments = {"models"}, .environment = {{"PATINA_DATA_DIR", folder.path()}}, .input = {}});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find((folder / "shaders").string()), std::string::npos) << outcome.err;
}

TEST(ModelsCommand, ShaderFolderThatIsAFile_ExitsWithOneAndNamesIt) {
    const TemporaryFolder folder;
    writeFile(folder / "shaders", "not a folder");
    const Outcome outcome = patina(Start{
        .arguments = {"models"}, .environment = {{"PATINA_DATA_DIR", folder.path()}}, .input = {}});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find((folder / "shaders").string()), std::string::npos) << outcome.err;
}

TEST(ModelsCommand, BrokenUserBlock_IsReportedWithItsPlace) {
    const TemporaryFolder data;
    writeFile(data / "patina/shaders/models/broken.json", "{\n  \"id\": 5\n}\n");
    const Outcome outcome = patina(Start{
        .arguments = {"models"}, .environment = {{"XDG_DATA_HOME", data.path()}}, .input = {}});
    EXPECT_NE(outcome.err.find("broken.json:2:"), std::string::npos) << outcome.err;
}

TEST(ModelsCommand, BrokenUserBlock_LeavesTheShippedOnes) {
    const TemporaryFolder data;
    writeFile(data / "patina/shaders/models/broken.json", "{");
    const Outcome outcome = patina(Start{.arguments = {"models", "--json"},
                                         .environment = {{"XDG_DATA_HOME", data.path()}},
                                         .input = {}});
    EXPECT_EQ(nlohmann::json::parse(outcome.out).size(), shippedDescriptors().size() + 1);
}

} // namespace
} // namespace patina::tests::models_test
