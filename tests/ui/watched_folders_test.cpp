// SPDX-License-Identifier: GPL-3.0-or-later
// The user's folders while the editor runs: what comes, goes and changes there.
#include <QAction>
#include <QDockWidget>
#include <QTest>
#include <QTimer>

#include "catalog/catalog.h"
#include "docks/preset_view.h"
#include "material/preset_file.h"
#include "ui/window_fixture.h"

namespace patina::tests::watched_folders_test {
namespace {

namespace fs = std::filesystem;

constexpr int waitMs = 120000;

class WatchedFolders : public WindowFixture {
  protected:
    void SetUp() override { window().startRest(); }

    fs::path shaders() const { return home("XDG_DATA_HOME") / "patina/shaders"; }
    fs::path presets() const { return home("XDG_DATA_HOME") / "patina/presets"; }

    void writeModel(const std::string& label) const {
        fs::create_directories(shaders() / "models");
        writeFile(shaders() / "models/homemade.glsl",
                  "// SPDX-License-"
                  "Identifier: MIT-0\n#include \"lib/directions.glsl\"\n"
                  "vec3 homemade(Directions d, Homemade p) {\n    return p.tint * d.nl;\n}\n");
        writeFile(shaders() / "models/homemade.json", R"({
            "id": "homemade", "version": 1, "label": ")" + label +
                                                          R"(", "summary": "For tests.",
            "applications": "Tests.", "source": "None", "doc": "For tests.",
            "parameters": [{"id": "tint", "label": "Tint", "type": "color", "default": [1, 0, 0],
                            "min": 0, "max": 1, "doc": "Its colour."}],
            "claims": ["finite"]})");
    }

    /// Writes the model's shader so that line 4 of it does not compile.
    void breakModel() const {
        writeFile(shaders() / "models/homemade.glsl",
                  "// SPDX-License-"
                  "Identifier: MIT-0\n#include \"lib/directions.glsl\"\n"
                  "vec3 homemade(Directions d, Homemade p) {\n    return p.tint * d.no;\n}\n");
    }

    bool isTold(const std::string& what) {
        return QTest::qWaitFor([&] { return messages().find(what) != std::string::npos; }, waitMs);
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
        const QAbstractItemModel& shown =
            *window().dock("presets")->findChild<PresetView*>()->model();
        return QTest::qWaitFor(
            [&] {
                return shown.rowCount() > 0 &&
                       !shown.match(shown.index(0, 0), Qt::DisplayRole, name, 1, Qt::MatchExactly)
                            .isEmpty();
            },
            waitMs);
    }

    std::string messages() { return text(window().messages().messages()); }
};

TEST_F(WatchedFolders, MessagesThatCameByThemselves_GoWithWhatTheySaid) {
    QDockWidget& dock = *window().dock("messages");
    fs::create_directories(presets());
    for (const bool byHand : {false, true}) {
        ASSERT_FALSE(dock.isVisible());
        writeFile(presets() / "mine.patina.json", "{");
        ASSERT_TRUE(isTold("mine.patina.json"));
        EXPECT_TRUE(dock.isVisible());
        if (byHand) {
            dock.toggleViewAction()->trigger();
            dock.toggleViewAction()->trigger();
        }
        writePresetNamed("Mine");
        ASSERT_TRUE(QTest::qWaitFor([&] { return messages().empty(); }, waitMs));
        EXPECT_EQ(dock.isVisible(), byHand);
    }
}

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

TEST_F(WatchedFolders, ChangeWhileAnotherFileNeverRests_IsSeen) {
    writeModel("First");
    ASSERT_TRUE(isShown("First"));
    QTimer restless;
    int rounds = 0;
    QObject::connect(&restless, &QTimer::timeout,
                     [&] { writeFile(shaders() / "models/other.json", std::to_string(++rounds)); });
    restless.start(30);
    writeModel("Second");
    EXPECT_TRUE(QTest::qWaitFor([&] { return label() == "Second"; }, waitMs)) << rounds;
}

TEST_F(WatchedFolders, ShaderThatDoesNotCompile_IsToldThoughNobodyChoseIt) {
    writeModel("First");
    ASSERT_TRUE(isShown("First"));
    breakModel();
    EXPECT_TRUE(isTold("homemade.glsl:4:")) << messages();
}

TEST_F(WatchedFolders, ShaderThatTakesAllMemory_IsToldAndTheEditorGoesOn) {
    writeModel("First");
    ASSERT_TRUE(isShown("First"));
    std::string bomb = "#define M0 d.nl\n";
    for (int i = 1; i <= 36; ++i) {
        const std::string before = "M" + std::to_string(i - 1);
        bomb += "#define M" + std::to_string(i) + " " + before + " + " + before + "\n";
    }
    writeFile(shaders() / "models/homemade.glsl",
              "// SPDX-License-Identifier: MIT-0\n#include \"lib/directions.glsl\"\n" + bomb +
                  "vec3 homemade(Directions d, Homemade p) {\n    return p.tint * (M36);\n}\n");
    EXPECT_TRUE(isTold("the block \"homemade\" was not let in")) << messages();
    writeModel("Second");
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return messages().find("homemade.glsl") == std::string::npos; }, waitMs))
        << messages();
}

TEST_F(WatchedFolders, CheckOfAnEndlessShader_IsCancelledUntilItIsMended) {
    writeModel("First");
    ASSERT_TRUE(isShown("First"));
    writeFile(shaders() / "models/homemade.glsl",
              "// SPDX-License-Identifier: MIT-0\n#include \"lib/directions.glsl\"\n"
              "vec3 homemade(Directions d, Homemade p) {\n    float sum = d.nl;\n"
              "    while (sum > -1.0) {\n        sum = abs(sin(sum)) + d.nl * d.nl;\n    }\n"
              "    return p.tint * sum;\n}\n");
    const auto row = [] {
        const auto rows = LongTasks::all().shown();
        const auto found = std::ranges::find(rows, "Checking your blocks", &LongTasks::Row::name);
        return found == rows.end() ? std::nullopt : std::optional(*found);
    };
    ASSERT_TRUE(QTest::qWaitFor([&] { return row().has_value(); }, waitMs));
    ASSERT_TRUE(row()->canCancel);
    LongTasks::all().cancel(row()->number);
    EXPECT_TRUE(isTold("checking your blocks was stopped")) << messages();
    EXPECT_FALSE(row());
    writeModel("Second");
    EXPECT_TRUE(QTest::qWaitFor([&] { return messages().find("was stopped") == std::string::npos; },
                                waitMs))
        << messages();
    EXPECT_TRUE(isShown("Second"));
}

TEST_F(WatchedFolders, ShaderThatDidNotCompileAtTheStart_IsToldUntilItIsMended) {
    writeModel("First");
    breakModel();
    close();
    open();
    window().startRest();
    ASSERT_TRUE(isTold("homemade.glsl:4:")) << messages();
    writeModel("First");
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return messages().find("homemade.glsl") == std::string::npos; }, waitMs))
        << messages();
}

TEST_F(WatchedFolders, ShaderThatDoesNotCompile_HasNoPicture) {
    writeModel("First");
    ASSERT_TRUE(isShown("First"));
    ThumbnailMaker maker(document().sharedCatalog(),
                         {home("cache"), home("programs"), threeLightsFile()});
    QImage picture;
    int made = 0;
    QObject::connect(&maker, &ThumbnailMaker::ready, &window(),
                     [&](const QString&, const QImage& drawn) {
                         picture = drawn;
                         ++made;
                     });
    const auto isMade = [&](int count) {
        const Block* model = document().catalog().find("models", "homemade");
        maker.ask("homemade", defaultMaterial(*model));
        return QTest::qWaitFor([&] { return made == count; }, waitMs);
    };
    maker.start();
    ASSERT_TRUE(isMade(1));
    ASSERT_FALSE(picture.isNull());
    breakModel();
    maker.setCatalog(std::make_shared<const Catalog>(loadCatalog(standardBlockRoots())));
    ASSERT_TRUE(isMade(2));
    EXPECT_TRUE(picture.isNull());
}

TEST_F(WatchedFolders, FileThatIsNoPartOfABlock_ChangesNothing) {
    writeModel("First");
    ASSERT_TRUE(isShown("First"));
    int changes = 0;
    onChange(document(), DocumentChange::Catalog, &document(), [&] { ++changes; });
    writeFile(shaders() / "models/notes.txt", "x");
    QTest::qWait(1000);
    EXPECT_EQ(changes, 0);
}

/// The folder that comes with Patina, as a copy.
class ShippedFolder : public WatchedFolders {
  protected:
    void SetUp() override {
        close();
        fs::create_directories(home("data"));
        for (const char* part : {"shaders", "schemas", "presets"}) {
            fs::copy(fs::path(PATINA_SOURCE_DIR) / part, home("data") / part,
                     fs::copy_options::recursive);
        }
        qputenv("PATINA_DATA_DIR", QByteArray::fromStdString(home("data").string()));
        open();
        WatchedFolders::SetUp();
    }
    void TearDown() override { qunsetenv("PATINA_DATA_DIR"); }

    fs::path shipped() const { return home("data") / "shaders"; }

    /// The model that the document begins with.
    const Block* model() {
        const Material& material = *document().material(Side::A);
        return document().catalog().find("models", material.model.id);
    }

    /// Writes another label into its descriptor, and waits until the editor has it.
    bool isRelabelled(const fs::path& descriptor) {
        const std::string before = model()->label;
        std::string text = readFile(descriptor);
        text.replace(text.find('"' + before + '"'), before.size() + 2, "\"Relabelled\"");
        writeFile(descriptor, text);
        return QTest::qWaitFor([&] { return model() && model()->label == "Relabelled"; }, waitMs);
    }
};

TEST_F(ShippedFolder, Lost_LeavesTheModelsAndSaysSo) {
    fs::remove_all(shipped());
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return messages().find("data/shaders") != std::string::npos; }, waitMs));
    EXPECT_NE(model(), nullptr);
}

TEST_F(ShippedFolder, LostAndBack_IsWellAgainAndWatched) {
    const fs::path descriptor = model()->descriptorFile;
    const auto isTold = [&] { return messages().find("data/shaders") != std::string::npos; };
    fs::remove_all(shipped());
    ASSERT_TRUE(QTest::qWaitFor(isTold, waitMs));
    fs::copy(PATINA_SOURCE_DIR "/shaders", shipped(), fs::copy_options::recursive);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !isTold(); }, waitMs)) << messages();
    EXPECT_TRUE(isRelabelled(descriptor));
}

TEST_F(ShippedFolder, MovedAwayAndReplaced_IsWatched) {
    const fs::path descriptor = model()->descriptorFile;
    QTest::qWait(1000); // all is at rest
    fs::rename(shipped(), home("data") / "former");
    fs::copy(PATINA_SOURCE_DIR "/shaders", shipped(), fs::copy_options::recursive);
    QTest::qWait(1000);
    EXPECT_TRUE(isRelabelled(descriptor));
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
} // namespace patina::tests::watched_folders_test
