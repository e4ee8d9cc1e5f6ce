// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of preset files in the library: one undo step each, with a result per preset.
#include <algorithm>

#include "files/preset_edits.h"
#include "library/preset_library.h"
#include "material/preset_file.h"
#include "material/variant.h"
#include "ui/preset_window.h"

namespace patina::tests::preset_edits_test {
namespace {

namespace fs = std::filesystem;

class PresetEditsTest : public PresetWindow {
  protected:
    void SetUp() override {
        for (const char* name : {"One", "Two", "Three"}) {
            Material material = *document().material(Side::A);
            material.name = name;
            material.tags = {"heirloom"};
            fs::create_directories(presets());
            writeFile(fileOf(name), writeJson(toJson(material)));
        }
        PresetWindow::SetUp();
        ASSERT_TRUE(QTest::qWaitFor([this] { return library().isRead(); }, 20000));
        QObject::connect(
            &edits_, &PresetEdits::done, &edits_,
            [this](const QString&, const std::vector<PresetOutcome>& told) { outcomes_ = told; });
    }

    fs::path fileOf(const std::string& name) const { return presets() / (name + ".patina.json"); }
    PresetLibrary& library() { return window().dockContext().presets; }
    PresetPtr entry(const std::string& name) {
        return library().find(QString::fromStdString(fileOf(name).string()));
    }
    PresetPtr shippedEntry() {
        return *std::ranges::find_if(library().entries(), &PresetEntry::shipped);
    }
    Material read(const std::string& name) {
        return readPreset(fileOf(name), document().catalog())->material;
    }

    PresetEdits edits_{library()};
    std::vector<PresetOutcome> outcomes_;
};

TEST_F(PresetEditsTest, Rename_KeepsTheFileAndIsUndone) {
    const std::string before = readFile(fileOf("One"));
    edits_.rename({entry("One")}, "Another");
    EXPECT_EQ(read("One").name, "Another");
    edits_.undoStack().undo();
    EXPECT_EQ(readFile(fileOf("One")), before);
    edits_.undoStack().redo();
    EXPECT_EQ(read("One").name, "Another");
}

TEST_F(PresetEditsTest, RenameOfMany_IsOneStepAndNumbersThem) {
    edits_.rename({entry("One"), entry("Two")}, "Tile");
    EXPECT_EQ(read("One").name, "Tile 1");
    EXPECT_EQ(read("Two").name, "Tile 2");
    EXPECT_EQ(edits_.undoStack().count(), 1);
    edits_.undoStack().undo();
    edits_.rename({entry("Two"), shippedEntry(), entry("Three")}, "{n}: old {name}");
    EXPECT_EQ(read("Two").name, "1: old Two");
    EXPECT_EQ(read("Three").name, "3: old Three");
    EXPECT_EQ(std::ranges::count_if(outcomes_, &PresetOutcome::isDone), 2); // not the shipped one
}

TEST_F(PresetEditsTest, TrashOfMany_IsOneStepAndRestoredByUndo) {
    const std::string before = readFile(fileOf("Two"));
    edits_.moveToTrash({entry("One"), entry("Two"), entry("Three")});
    EXPECT_FALSE(fs::exists(fileOf("One")));
    EXPECT_FALSE(fs::exists(fileOf("Three")));
    ASSERT_EQ(edits_.undoStack().count(), 1);
    edits_.undoStack().undo();
    EXPECT_TRUE(fs::exists(fileOf("One")));
    EXPECT_EQ(readFile(fileOf("Two")), before);
}

TEST_F(PresetEditsTest, ShippedPresetAmongOthers_IsToldAndStays) {
    const PresetPtr shipped = shippedEntry();
    edits_.moveToTrash({shipped, entry("One")});
    EXPECT_TRUE(fs::exists(shipped->file));
    EXPECT_FALSE(fs::exists(fileOf("One")));
    ASSERT_EQ(outcomes_.size(), 2u);
    EXPECT_FALSE(outcomes_[0].isDone());
    EXPECT_EQ(outcomes_[0].entry, shipped);
    EXPECT_TRUE(outcomes_[1].isDone());
}

TEST_F(PresetEditsTest, EditThatNoPresetTakes_LeavesNoStep) {
    edits_.rename({shippedEntry()}, "Mine now");
    EXPECT_EQ(edits_.undoStack().count(), 0);
    ASSERT_EQ(outcomes_.size(), 1u);
    EXPECT_FALSE(outcomes_[0].isDone());
}

TEST_F(PresetEditsTest, TagsOfMany_AreAddedAndTakenAway) {
    edits_.changeTags({entry("One"), entry("Two")}, {"metal", "heirloom"}, {});
    EXPECT_EQ(read("One").tags, (std::vector<std::string>{"heirloom", "metal"}));
    EXPECT_EQ(read("Three").tags, std::vector<std::string>{"heirloom"});
    edits_.undoStack().undo();
    edits_.changeTags({entry("Three")}, {}, {"heirloom"});
    EXPECT_EQ(read("One").tags, std::vector<std::string>{"heirloom"});
    EXPECT_TRUE(read("Three").tags.empty());
}

TEST_F(PresetEditsTest, UndoOfAFileThatWasChangedMeanwhile_LeavesItAlone) {
    edits_.rename({entry("One")}, "Another");
    writeFile(fileOf("One"), readFile(fileOf("One")) + "\n");
    const std::string theirs = readFile(fileOf("One"));
    edits_.undoStack().undo();
    EXPECT_EQ(readFile(fileOf("One")), theirs);
    ASSERT_EQ(outcomes_.size(), 1u);
    EXPECT_FALSE(outcomes_[0].isDone());
}

TEST_F(PresetEditsTest, DuplicatesOfAShippedPreset_LieInTheUsersFolder) {
    const PresetPtr shipped = shippedEntry();
    edits_.duplicate({shipped, shipped});
    int copies = 0;
    for (const auto& file : fs::directory_iterator(presets())) {
        const auto copy = readPreset(file.path(), document().catalog());
        copies += copy && copy->material.model == shipped->material.model ? 1 : 0;
    }
    EXPECT_EQ(copies, 2);
    edits_.undoStack().undo();
    EXPECT_EQ(std::distance(fs::directory_iterator(presets()), fs::directory_iterator()), 3);
}

TEST_F(PresetEditsTest, FavouritesOfMany_AreOneStepAndRemembered) {
    edits_.setFavourites({entry("One"), shippedEntry()}, true);
    EXPECT_TRUE(PresetMarks(window().dockContext().session).isFavourite(shippedEntry()->path));
    ASSERT_EQ(edits_.undoStack().count(), 1);
    edits_.undoStack().undo();
    EXPECT_FALSE(library().marks().isFavourite(entry("One")->path));
}

TEST_F(PresetEditsTest, DetachedVariant_LooksAsBeforeAndFollowsNoParent) {
    edits_.makeVariants({entry("One")});
    const fs::path file = presets() / "One-variant.patina.json";
    const auto variant = [&] { return library().find(QString::fromStdString(file.string())); };
    ASSERT_TRUE(QTest::qWaitFor([&] { return variant() != nullptr; }, 20000));
    const std::string before = readFile(file);
    edits_.detach({entry("Two"), variant()});
    const Material detached = read("One-variant");
    EXPECT_EQ(parentOf(detached), "");
    EXPECT_EQ(detached.model, read("One").model);
    edits_.undoStack().undo();
    EXPECT_EQ(readFile(file), before);
    EXPECT_EQ(parentOf(read("One-variant")), fileOf("One").generic_string());
}

TEST_F(PresetEditsTest, ParentOfVariants_StaysUnlessTheyGoWithIt) {
    edits_.makeVariants({entry("One")});
    const fs::path file = presets() / "One-variant.patina.json";
    const auto variant = [&] { return library().find(QString::fromStdString(file.string())); };
    ASSERT_TRUE(QTest::qWaitFor([&] { return variant() != nullptr; }, 20000));
    edits_.moveToTrash({entry("One")});
    ASSERT_EQ(outcomes_.size(), 1u);
    EXPECT_NE(outcomes_[0].problem.find("it is the parent of " + variant()->name.toStdString()),
              std::string::npos)
        << outcomes_[0].problem;
    EXPECT_TRUE(fs::exists(fileOf("One")));
    edits_.moveToTrash({entry("One"), variant()});
    EXPECT_FALSE(fs::exists(fileOf("One")));
    EXPECT_FALSE(fs::exists(file));
}

TEST_F(PresetEditsTest, ImportThatIsUndone_LiesInTheTrashAndComesBack) {
    const fs::path folder = presets() / "bundle";
    fs::create_directories(folder);
    writeFile(folder / "New.patina.json", readFile(fileOf("One")));
    edits_.noteImport(QString::fromStdString(folder.string()));
    edits_.undoStack().undo();
    EXPECT_FALSE(fs::exists(folder));
    edits_.undoStack().redo();
    EXPECT_EQ(readFile(folder / "New.patina.json"), readFile(fileOf("One")));
}

class PresetKeys : public PresetEditsTest {
  protected:
    void SetUp() override {
        PresetEditsTest::SetUp();
        QTest::keyClicks(&search(), "heirloom");
        ASSERT_EQ(count(), 3);
        view().setFocus();
        click(0);
        click(1, Qt::ControlModifier);
    }
};

TEST_F(PresetKeys, DeleteAndUndo_AreForTheSelectedPresetsAndNotForTheDocument) {
    document().setModel(Side::A, "lambert");
    QTest::keyClick(&view(), Qt::Key_Delete);
    ASSERT_TRUE(QTest::qWaitFor([this] { return count() == 1; }, 20000));
    QTest::keyClick(&view(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(QTest::qWaitFor([this] { return count() == 3; }, 20000));
    EXPECT_EQ(document().undoStack().index(), 1);
}

TEST_F(PresetKeys, UndoAfterAnEditOfTheDocument_IsTheDocuments) {
    QTest::keyClick(&view(), Qt::Key_Delete);
    ASSERT_TRUE(QTest::qWaitFor([this] { return count() == 1; }, 20000));
    document().setModel(Side::A, "lambert");
    QTest::keyClick(&view(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(document().undoStack().index(), 0);
    EXPECT_FALSE(fs::exists(fileOf("One")) && fs::exists(fileOf("Three")));
}

} // namespace
} // namespace patina::tests::preset_edits_test
