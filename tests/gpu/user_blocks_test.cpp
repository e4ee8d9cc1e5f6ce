// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks of the user's folder in the renderer, also while they do not compile.
#include <fmt/format.h>

#include "gpu_fixture.h"
#include "shading/effects/effect_set.h"
#include "support/program.h"

namespace patina::user_blocks_test {
namespace {

using tests::TemporaryFolder;
using tests::writeFile;

class UserBlockTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        writeFile(folder_ / "models/velvet-test.json", R"({
  "id": "velvet-test", "version": 1, "label": "Velvet", "summary": "s", "applications": "a",
  "source": "a test", "doc": "d",
  "parameters": [
    {"id": "glow", "label": "Glow", "type": "float", "default": 0.5, "min": 0, "max": 1,
     "softMin": 0, "softMax": 1, "step": 0.01, "decimals": 2, "group": "g", "doc": "d"}
  ],
  "claims": []
})");
        writeShader("return vec3(p.glow, 0.0, 0.0);");
        load();
        makeRenderer();
    }

    /// The body starts in line 3 of the file.
    void writeShader(const std::string& body) {
        writeFile(shader(), "// SPDX-License-"
                            "Identifier: MIT-0\n"
                            "vec3 velvetTest(Directions d, VelvetTest p) {\n    " +
                                body + "\n}\n");
    }

    std::filesystem::path shader() const { return folder_ / "models/velvet-test.glsl"; }

    void load() {
        const std::array roots{BlockRoot{PATINA_SOURCE_DIR "/shaders", true},
                               BlockRoot{folder_.path(), false}};
        catalog = std::make_shared<const Catalog>(loadCatalog(roots));
        ASSERT_TRUE(catalog->errors.empty()) << text(catalog->errors);
    }

    /// Reads the blocks as when the folder's watcher has seen a change, and draws them.
    Image redraw() {
        load();
        renderer->setCatalog(catalog);
        return capture(simpleScene("velvet-test"));
    }

    TemporaryFolder folder_;
};

TEST_F(UserBlockTest, TwoFiles_AreDrawn) {
    EXPECT_NEAR(middle(capture(simpleScene("velvet-test"))).r, 0.5f, 1e-3f);
}

TEST_F(UserBlockTest, TwoFiles_AreInTheReport) {
    capture(simpleScene("velvet-test"));
    EXPECT_EQ(renderer->report().effects.front(), "models/velvet-test");
}

TEST_F(UserBlockTest, SavedShader_IsDrawnAnew) {
    capture(simpleScene("velvet-test"));
    writeShader("return vec3(0.0, p.glow, 0.0);");
    EXPECT_NEAR(middle(redraw()).g, 0.5f, 1e-3f);
}

TEST_F(UserBlockTest, BrokenShader_KeepsTheLastGoodProgram) {
    const Image before = capture(simpleScene("velvet-test"));
    writeShader("return vec3(p.sheen);");
    EXPECT_EQ(redraw(), before);
}

TEST_F(UserBlockTest, BrokenShader_IsReportedAtItsOwnLine) {
    capture(simpleScene("velvet-test"));
    writeShader("return vec3(p.sheen);");
    redraw();
    ASSERT_FALSE(renderer->report().messages.empty());
    EXPECT_EQ(renderer->report().messages.front().file, shader().string());
    EXPECT_EQ(renderer->report().messages.front().line, 3);
}

TEST_F(UserBlockTest, BrokenShader_IsCompiledOnce) {
    writeShader("return vec3(p.sheen);");
    redraw();
    capture(simpleScene("velvet-test"));
    EXPECT_EQ(renderer->report().compiled, 0);
    EXPECT_FALSE(renderer->report().messages.empty());
}

TEST_F(UserBlockTest, BrokenFromTheStart_IsDrawnAsAFallback) {
    writeShader("return vec3(p.sheen);");
    EXPECT_GT(middle(redraw()).g, 0.0f);
}

TEST_F(UserBlockTest, MendedShader_ClearsTheMessages) {
    writeShader("return vec3(p.sheen);");
    redraw();
    writeShader("return vec3(p.glow);");
    redraw();
    EXPECT_TRUE(renderer->report().messages.empty());
}

TEST_F(UserBlockTest, BrokenShader_StillFollowsTheCamera) {
    Scene scene = simpleScene("velvet-test");
    capture(scene);
    writeShader("return vec3(p.sheen);");
    redraw();
    scene.camera.distance = 40.0;
    EXPECT_EQ(pixel(capture(scene), 12, 16), glm::vec3(0.25f));
}

} // namespace
} // namespace patina::user_blocks_test
