// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "material/measured_preset.h"
#include "material/preset_file.h"

namespace patina::shipped_presets_test {
namespace {

const Catalog& shippedCatalog() {
    static const Catalog shipped = loadCatalog(
        std::vector{BlockRoot{std::filesystem::path(PATINA_SOURCE_DIR) / "shaders", true}});
    return shipped;
}

std::vector<std::filesystem::path> shippedPresets() {
    std::vector<std::filesystem::path> files;
    const std::filesystem::path folder = std::filesystem::path(PATINA_SOURCE_DIR) / "presets";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.path().string().ends_with(".patina.json")) {
            files.push_back(entry.path());
        }
    }
    return files;
}

TEST(ShippedPresets, EveryOne_ReadsWithoutANote) {
    for (const auto& file : shippedPresets()) {
        const auto reading = readPreset(file, shippedCatalog());
        ASSERT_TRUE(reading) << text(reading.error());
        EXPECT_EQ(text(reading->notes), "") << file;
    }
}

TEST(ShippedPresets, EveryOne_IsWrittenAsPatinaWritesIt) {
    for (const auto& file : shippedPresets()) {
        std::ostringstream bytes;
        bytes << std::ifstream(file).rdbuf();
        EXPECT_EQ(bytes.str(), writeJson(toJson(readPreset(file, shippedCatalog())->material,
                                                file.parent_path())))
            << file;
    }
}

/// Levels that were there until nothing was found that they are better for.
TEST(ShippedModels, LevelThatIsGone_OpensExactAndSaysSo) {
    struct Gone {
        const char* model;
        const char* choice;
        const char* level;
    };
    for (const Gone& gone :
         {Gone{"phong", "power", "squaring"}, Gone{"cook-torrance", "shadowing", "hammon"}}) {
        const nlohmann::json preset{{"format", "patina.preset"},
                                    {"version", 1},
                                    {"model", {{"id", gone.model}, {"version", 1}}},
                                    {"accuracy", {{gone.choice, gone.level}}}};
        const auto reading =
            materialFromJson(parseJson(writeJson(preset), "old").value(), "", shippedCatalog());
        ASSERT_TRUE(reading) << text(reading.error());
        EXPECT_EQ(reading->material.accuracy.at(gone.choice), "exact");
        EXPECT_NE(text(reading->notes).find(std::string(gone.level) + "\" is no level of"),
                  std::string::npos)
            << text(reading->notes);
    }
}

TEST(ShippedPresets, EveryOne_LiesInItsModelsFolder) {
    for (const auto& file : shippedPresets()) {
        const Material material = readPreset(file, shippedCatalog())->material;
        EXPECT_EQ(file.parent_path().filename().string(), material.model.id) << file;
    }
}

TEST(ShippedPresets, EveryOne_GivesAReasonForItsValues) {
    for (const auto& file : shippedPresets()) {
        EXPECT_GT(readPreset(file, shippedCatalog())->material.description.size(), 60u) << file;
    }
}

const std::filesystem::path imageFolder =
    std::filesystem::path(PATINA_SOURCE_DIR) / "presets/images";

TEST(ShippedPresets, EveryImage_IsThereAndIsUsed) {
    std::set<std::string> used;
    for (const auto& file : shippedPresets()) {
        const Material material = readPreset(file, shippedCatalog())->material;
        for (const auto& [key, image] : material.textures) {
            EXPECT_TRUE(std::filesystem::exists(image.file)) << file << " " << key;
            used.insert(std::filesystem::path(image.file).filename().string());
        }
    }
    for (const auto& entry : std::filesystem::directory_iterator(imageFolder)) {
        const std::string name = entry.path().filename().string();
        EXPECT_TRUE(name == "make_images.py" || used.contains(name)) << name;
    }
}

TEST(ShippedPresets, Images_TakeAtMostSixMegabytes) {
    std::uintmax_t size = 0;
    for (const auto& entry : std::filesystem::directory_iterator(imageFolder)) {
        size += entry.file_size();
    }
    EXPECT_LE(size, 6'000'000u);
}

TEST(ShippedPresets, EveryModel_HasAtLeastThree) {
    std::map<std::string, int> count;
    for (const auto& file : shippedPresets()) {
        ++count[file.parent_path().filename().string()];
    }
    for (const Block* model : shippedCatalog().ofKind("models")) {
        // Measured surfaces are brought along by who uses them.
        EXPECT_TRUE(count[model->id] >= 3 || tableParameter(*model) != nullptr) << model->id;
    }
}

} // namespace
} // namespace patina::shipped_presets_test
