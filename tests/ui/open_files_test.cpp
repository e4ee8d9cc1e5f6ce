// SPDX-License-Identifier: GPL-3.0-or-later
// What the command line, the menu and a drop name is opened, or it is said why not.
#include <QTest>

#include "ui/window_fixture.h"

namespace patina::tests {
namespace {

class OpenFiles : public WindowFixture {
  protected:
    /// The scene as it stands, under another name.
    QString sceneFile(const std::string& name) {
        EXPECT_TRUE(document().saveScene(home("a.patina-scene.json")));
        std::filesystem::rename(home("a.patina-scene.json"), home(name));
        EXPECT_TRUE(document().openTemplate(FileActions::defaultScene()));
        return QString::fromStdString(home(name).string());
    }

    QString presetFile() { return QString::fromStdString(otherPreset(document()).string()); }

    std::string messages() { return text(window().messages().messages()); }
};

TEST_F(OpenFiles, SceneWithAPlainName_IsOpenedByItsFormat) {
    const QString file = sceneFile("plain.json");
    window().files().open({file}, Side::A);
    EXPECT_EQ(document().file().kind, DocumentFile::Kind::Scene);
    EXPECT_EQ(messages(), "");
}

TEST_F(OpenFiles, TwoPresets_AreTheTwoSides) {
    window().files().open({presetFile(), presetFile()}, Side::A);
    EXPECT_TRUE(document().isComparing());
    EXPECT_EQ(messages(), "");
}

TEST_F(OpenFiles, SceneBesideAPreset_IsNamedAsNotOpened) {
    const QString scene = sceneFile("b.patina-scene.json");
    window().files().open({presetFile(), scene}, Side::A);
    EXPECT_EQ(document().file().kind, DocumentFile::Kind::Preset);
    EXPECT_NE(messages().find("b.patina-scene.json"), std::string::npos) << messages();
}

TEST_F(OpenFiles, ThirdPreset_IsNamedAsNotOpened) {
    window().files().open({presetFile(), presetFile(), "third.patina.json"}, Side::A);
    EXPECT_NE(messages().find("third.patina.json"), std::string::npos) << messages();
}

} // namespace
} // namespace patina::tests
