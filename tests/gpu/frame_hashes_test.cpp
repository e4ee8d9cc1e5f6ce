// SPDX-License-Identifier: GPL-3.0-or-later
// Frames to the last bit. PATINA_FRAME_HASHES=<file> writes a line for every shipped preset and for
// 200 random scenes: two versions of the program that draw the same write the same file.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "gpu_fixture.h"
#include "material/preset_file.h"
#include "random_scenes.h"
#include "render/lights/environment_image.h"

namespace patina::tests::frame_hashes_test {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t allScenes = 200;
constexpr std::uint64_t fewScenes = 4;
constexpr std::size_t fewPresets = 2;
constexpr std::size_t scenesPerContext = 50; ///< drivers keep what they have compiled
constexpr int size = 64;

/// FNV-1a over the pixels' bytes.
std::uint64_t hashOf(const Image& image) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const float value : image.pixels) {
        std::uint32_t bits = 0;
        std::memcpy(&bits, &value, sizeof(bits));
        hash = (hash ^ bits) * 0x100000001b3u;
    }
    return hash;
}

std::shared_ptr<const TexturePicture> picture(float shade) {
    FileImage image{{4, 4, 4, {}}, 8};
    for (int i = 0; i < 16; ++i) {
        const float x = float(i % 5) / 4.0f;
        image.image.pixels.insert(image.image.pixels.end(), {x, shade, 1.0f - x, 0.5f + 0.5f * x});
    }
    return std::make_shared<const TexturePicture>(madeTexture(image, TextureDecoding::Linear));
}

using NamedScene = std::pair<std::string, Scene>;

class FrameHashes : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        begin();
    }

    /// A new renderer in a new context.
    void begin() {
        renderer.reset();
        debug.reset();
        context.reset();
        GpuTest::SetUp();
        makeRenderer();
        renderer->setTextures([this](const TextureUse&, TextureDecoding) -> TextureLookup {
            return {picture_, false};
        });
    }

    std::vector<NamedScene> presetScenes(std::size_t maxPresets) {
        std::vector<fs::path> files;
        for (const auto& entry : fs::recursive_directory_iterator(PATINA_SOURCE_DIR "/presets")) {
            if (entry.path().string().ends_with(".patina.json")) {
                files.push_back(entry.path());
            }
        }
        std::ranges::sort(files);
        files.resize(std::min(files.size(), maxPresets));
        std::vector<NamedScene> scenes;
        for (const fs::path& file : files) {
            auto preset = readPreset(file, *catalog);
            EXPECT_TRUE(preset) << file;
            Scene scene = simpleScene();
            scene.objects[0].material = preset->material;
            scene.lights.push_back(light("point"));
            scene.lights[1].setPart(kinds::shadows, block("shadows", "filtered"));
            scene.ground.mode = GroundMode::Plane;
            scenes.emplace_back(file.filename().string(), std::move(scene));
        }
        return scenes;
    }

    std::vector<NamedScene> randomScenes(std::uint64_t count) {
        std::vector<NamedScene> scenes;
        for (std::uint64_t i = 0; i < count; ++i) {
            scenes.emplace_back(fmt::format("random {}", i), RandomScenes(*catalog).scene(i));
        }
        return scenes;
    }

    /// A line with the hashes of the linear and of the displayed picture.
    std::string lineOf(const NamedScene& named) {
        View view = viewOf(named.second, size);
        view.environmentImage = panorama_;
        view.environmentSamples = 8;
        std::string line = named.first;
        for (const bool display : {false, true}) {
            const auto image = renderer->capture(named.second, view, meshSource(), display);
            EXPECT_TRUE(image) << named.first;
            line += fmt::format(" {:016x}", image ? hashOf(*image) : 0);
        }
        return line;
    }

    std::vector<std::string> linesOf(const std::vector<NamedScene>& scenes) {
        std::vector<std::string> lines;
        for (const NamedScene& named : scenes) {
            if (lines.size() % scenesPerContext == scenesPerContext - 1) {
                begin();
            }
            lines.push_back(lineOf(named));
        }
        return lines;
    }

    std::vector<NamedScene> scenes(std::size_t presets, std::uint64_t random) {
        std::vector<NamedScene> all = presetScenes(presets);
        for (NamedScene& each : randomScenes(random)) {
            all.push_back(std::move(each));
        }
        return all;
    }

  private:
    std::shared_ptr<const TexturePicture> picture_ = picture(0.5f);
    std::shared_ptr<const EnvironmentImage> panorama_ =
        EnvironmentImage::from({4, 2, 1, {0.1f, 0.5f, 8.0f, 1.0f, 0.0f, 0.2f, 0.3f, 0.4f}});
};

TEST_F(FrameHashes, OfASecondRenderer_AreTheSame) {
    if (const char* file = std::getenv("PATINA_FRAME_HASHES")) {
        std::ofstream out(file);
        for (const std::string& line : linesOf(scenes(SIZE_MAX, allScenes))) {
            out << line << '\n';
        }
        return;
    }
    const std::vector<NamedScene> few = scenes(fewPresets, fewScenes);
    const std::vector<std::string> first = linesOf(few);
    begin();
    EXPECT_EQ(linesOf(few), first);
}

} // namespace
} // namespace patina::tests::frame_hashes_test
