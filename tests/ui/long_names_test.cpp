// SPDX-License-Identifier: GPL-3.0-or-later
// Names of 200 characters, in everything that has a name.
#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QTest>

#include "document/scene_edits.h"
#include "ui/window_fixture.h"

namespace patina::tests::long_names_test {
namespace {

const std::string longName(200, 'W');
constexpr int narrowestScreen = 1280;
constexpr int widestMenu = 600;
constexpr int statusMs = 400; ///< the status line is written four times a second

class LongNames : public WindowFixture {
  protected:
    void SetUp() override { before_ = widths(); }

    std::vector<int> widths() {
        newFrames();
        QTest::qWait(statusMs);
        return {window().dock("models")->width(), window().dock("parameters")->width(),
                window().views().width()};
    }
    void expectRoom() {
        EXPECT_EQ(widths(), before_);
        EXPECT_LE(window().minimumSizeHint().width(), narrowestScreen);
    }
    void addModel(const std::string& id) {
        const std::filesystem::path folder = home("XDG_DATA_HOME") / "patina/shaders/models";
        std::filesystem::create_directories(folder);
        writeFile(folder / (id + ".glsl"), "// SPDX-License-"
                                           "Identifier: MIT-0\n"
                                           "#include \"lib/directions.glsl\"\nvec3 " +
                                               id +
                                               "(Directions d, Lengthy p) {\n"
                                               "    return vec3(p.amount * d.nl);\n}\n");
        writeFile(folder / (id + ".json"), R"({"id": ")" + id + R"(", "version": 1, "label": ")" +
                                               longName + R"(", "parameters": [
            {"id": "amount", "label": ")" + longName +
                                               R"(", "type": "float", "default": 0.5,
             "unit": ")" + longName + R"(", "group": ")" +
                                               longName + R"("},
            {"id": "sort", "label": "Sort", "type": "enum", "default": "one", "values": [
             {"id": "one", "label": ")" + longName +
                                               R"("}, {"id": "two", "label": "Two"}]}]})");
    }

  private:
    std::vector<int> before_;
};

TEST_F(LongNames, OfObjectsAndLights_LeaveTheLayout) {
    Object object = document().scene().objects[0];
    object.name = longName;
    object.material.name = longName;
    setObject(document(), 0, object);
    Light light = document().scene().lights[0];
    light.name = longName;
    setLight(document(), 0, light);
    window().comparison().setComparing(true);
    expectRoom();
}

TEST_F(LongNames, OfAModelAndItsParameters_LeaveTheLayout) {
    addModel("lengthy");
    auto catalog = std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()));
    ASSERT_EQ(text(catalog->errors), "");
    document().setCatalog(catalog);
    document().setModel(Side::A, "lengthy");
    expectRoom();
}

TEST_F(LongNames, OfAModelThatIsNotInstalled_LeaveTheLayout) {
    Material material = *document().material(Side::A);
    material.model.id = longName;
    material.parts["fresnel"] = {longName, 1, {}, nlohmann::json::object()};
    document().replaceMaterial(Side::A, material, "Preset");
    expectRoom();
}

TEST_F(LongNames, OfAFile_LeaveTheLayout) {
    const std::filesystem::path file = home(longName + ".patina-scene.json");
    ASSERT_TRUE(window().documentFiles().saveScene(file));
    window().files().open({QString::fromStdString(file.string())}, Side::A);
    expectRoom();
}

TEST_F(LongNames, InMenus_AreShortened) {
    const std::filesystem::path file = home(longName + ".patina-scene.json");
    ASSERT_TRUE(window().documentFiles().saveScene(file));
    window().files().open({QString::fromStdString(file.string())}, Side::A);
    Object object = document().scene().objects[0];
    object.name = longName;
    addObject(document(), object);
    for (QAction* action : window().menuBar()->actions()) {
        Q_EMIT action->menu()->aboutToShow();
        EXPECT_LE(action->menu()->sizeHint().width(), widestMenu) << action->text().toStdString();
        for (QAction* inner : action->menu()->actions()) {
            if (inner->menu()) {
                Q_EMIT inner->menu()->aboutToShow();
                EXPECT_LE(inner->menu()->sizeHint().width(), widestMenu);
            }
        }
    }
}

TEST_F(LongNames, OfAMaterial_MakeFileNamesThatCanBeWritten) {
    const QString name = SaveActions::asFileName(QString::fromStdString(longName + longName));
    EXPECT_LE(name.toUtf8().size(), 200);
    EXPECT_FALSE(name.isEmpty());
}

TEST_F(LongNames, OfAMaterialInAnotherScript_MakeFileNamesThatCanBeWritten) {
    const QString chinese = SaveActions::asFileName(QString(200, QChar(0x4e00)));
    EXPECT_LE(chinese.toUtf8().size(), 200);
    EXPECT_TRUE(chinese.startsWith(QString(40, QChar(0x4e00))));
}

} // namespace
} // namespace patina::tests::long_names_test
