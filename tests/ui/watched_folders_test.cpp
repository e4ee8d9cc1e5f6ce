// SPDX-License-Identifier: GPL-3.0-or-later
// The user's folders while the editor runs: what comes, goes and changes there.
#include <QDockWidget>
#include <QTest>

#include "docks/picture_grid.h"
#include "material/preset_file.h"
#include "ui/window_fixture.h"

namespace patina::tests {
namespace {

namespace fs = std::filesystem;

constexpr int waitMs = 20000;

class WatchedFolders : public WindowFixture {
  protected:
    void SetUp() override { window().startRest(); }

    fs::path shaders() const { return home("XDG_DATA_HOME") / "patina/shaders"; }
    fs::path presets() const { return home("XDG_DATA_HOME") / "patina/presets"; }

    void writeModel(const std::string& label) const {
        fs::create_directories(shaders() / "models");
        writeFile(shaders() / "models/homemade.glsl",
                  "// SPDX-License-Identifier: MIT-0\n#include \"lib/directions.glsl\"\n"
                  "vec3 homemade(Directions d, Homemade p) {\n    return p.tint * d.nl;\n}\n");
        writeFile(shaders() / "models/homemade.json", R"({
            "id": "homemade", "version": 1, "label": ")" + label + R"(", "summary": "For tests.",
            "applications": "Tests.", "source": "None", "doc": "For tests.",
            "parameters": [{"id": "tint", "label": "Tint", "type": "color", "default": [1, 0, 0],
                            "min": 0, "max": 1, "doc": "Its colour."}],
            "claims": ["finite"]})");
    }

    /// The label of the user's model; empty while there is none.
    std::string label() {
        const Block* model = document().catalog().find("models", "homemade");
        return model ? model->label : "";
    }

    bool isShown(const std::string& wanted) {
        return QTest::qWaitFor([&] { return label() == wanted; }, waitMs);
    }

    /// A preset in the user's folder, written in place.
    void writePresetNamed(const std::string& name) {
        Material material = *document().material(Side::A);
        material.name = name;
        writeFile(presets() / "mine.patina.json", writeJson(toJson(material)));
    }

    bool isOffered(const QString& name) {
        auto* grid = window().dock("presets")->findChild<PictureGrid*>();
        return QTest::qWaitFor(
            [&] { return !grid->findItems(name, Qt::MatchExactly).isEmpty(); }, waitMs);
    }

    std::string messages() { return text(window().messages().messages()); }
};

TEST_F(WatchedFolders, ShadersMadeAgain_AreSeenAndWatched) {
    writeModel("First");
    ASSERT_TRUE(isShown("First"));
    fs::remove_all(shaders());
    ASSERT_TRUE(isShown(""));
    writeModel("Second");
    ASSERT_TRUE(isShown("Second"));
    writeModel("Third");
    EXPECT_TRUE(isShown("Third"));
}

TEST_F(WatchedFolders, ShadersMovedAway_AreGoneAndTheirSuccessorIsWatched) {
    writeModel("First");
    ASSERT_TRUE(isShown("First"));
    fs::rename(shaders(), home("elsewhere"));
    ASSERT_TRUE(isShown(""));
    writeModel("Second");
    ASSERT_TRUE(isShown("Second"));
    writeModel("Third");
    EXPECT_TRUE(isShown("Third"));
}

TEST_F(WatchedFolders, ShadersWhoseParentWasRemoved_AreSeenWhenTheyAreBack) {
    writeModel("First");
    ASSERT_TRUE(isShown("First"));
    fs::remove_all(shaders().parent_path());
    ASSERT_TRUE(isShown(""));
    writeModel("Second");
    EXPECT_TRUE(isShown("Second"));
}

TEST_F(WatchedFolders, PresetWrittenInPlace_IsReadAgain) {
    writePresetNamed("Before");
    ASSERT_TRUE(isOffered("Before"));
    writePresetNamed("After");
    EXPECT_TRUE(isOffered("After"));
}

TEST_F(WatchedFolders, PresetThatCannotBeRead_IsAMessageUntilItIsMended) {
    const auto isNamed = [this] {
        return messages().find("mine.patina.json") != std::string::npos;
    };
    writeFile(presets() / "mine.patina.json", "{\"format\": ");
    ASSERT_TRUE(QTest::qWaitFor(isNamed, waitMs));
    writePresetNamed("Mended");
    EXPECT_TRUE(QTest::qWaitFor([&] { return !isNamed(); }, waitMs)) << messages();
}

} // namespace
} // namespace patina::tests
