// SPDX-License-Identifier: GPL-3.0-or-later
// What a preset does not call for changes not a byte of its program.
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "material/preset_file.h"
#include "scene/scene_file.h"
#include "shading_scene.h"

namespace patina::program_texts_test {
namespace {

namespace fs = std::filesystem;

/// Maps presets to the hashes of their programs.
using Hashes = std::map<std::string, std::string>;

class ProgramTexts : public ShadingTest {
  protected:
    /// Returns the hashes of the programs of all shipped presets under three lights.
    static Hashes hashesNow() {
        const fs::path presets = PATINA_SOURCE_DIR "/presets";
        const auto scene = readScene(presets / "three-lights.patina-scene.json", catalog());
        EXPECT_TRUE(scene);
        Hashes hashes;
        for (const auto& entry : fs::recursive_directory_iterator(presets)) {
            if (scene && entry.path().string().ends_with(".patina.json")) {
                const auto preset = readPreset(entry.path(), catalog());
                EXPECT_TRUE(preset) << entry.path();
                const auto text = surfaceProgram(
                    effectSet(preset->material, scene->scene, catalog()), catalog());
                EXPECT_TRUE(text) << entry.path();
                hashes[fs::relative(entry.path(), presets).string()] =
                    text ? text->hash() : std::string();
            }
        }
        return hashes;
    }

    static Hashes recorded() {
        std::ifstream lines(PATINA_SOURCE_DIR "/tests/gpu/program_texts.txt");
        Hashes hashes;
        std::string hash;
        for (std::string preset; lines >> hash >> preset;) {
            hashes[preset] = hash;
        }
        return hashes;
    }
};

/// A term that is off is in no text. One that changes what a preset draws changes its line.
TEST_F(ProgramTexts, OfAllShippedPresets_AreThoseRecorded) {
    const Hashes before = recorded();
    const Hashes now = hashesNow();
    for (const auto& [preset, hash] : now) {
        const auto found = before.find(preset);
        EXPECT_TRUE(found != before.end() && found->second == hash)
            << preset << (found == before.end() ? " is not recorded" : " has another program");
    }
    EXPECT_EQ(now.size(), before.size());
    if (HasFailure()) {
        const fs::path file = fs::path(PATINA_BINARY_DIR) / "program_texts.txt";
        std::ofstream out(file);
        for (const auto& [preset, hash] : now) {
            out << hash << ' ' << preset << '\n';
        }
        ADD_FAILURE() << "If that is meant, copy " << file << " to tests/gpu";
    }
}

} // namespace
} // namespace patina::program_texts_test
