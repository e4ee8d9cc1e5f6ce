// SPDX-License-Identifier: GPL-3.0-or-later
// Looks that are kept under names.
#include <QListWidget>
#include <QPushButton>
#include <QTest>

#include "docks/snapshots_dock.h"
#include "document/snapshot_edits.h"
#include "ui/fixtures.h"
#include "ui/window_fixture.h"

namespace patina::tests::snapshots_test {
namespace {

class Snapshots : public WindowFixture {
  protected:
    Snapshots() {
        const auto actions = window().findChildren<QAction*>();
        take_ = *std::ranges::find(actions, QKeySequence("Ctrl+T"), &QAction::shortcut);
    }

    void take() { take_->trigger(); }

    QListWidget& list() { return *window().findChild<QListWidget*>("snapshots"); }

    void press(const QString& text) {
        for (auto* button : window().findChild<SnapshotsDock*>()->findChildren<QPushButton*>()) {
            if (button->text() == text) {
                QTest::mouseClick(button, Qt::LeftButton);
            }
        }
    }

    void change() {
        ASSERT_TRUE(window().documentFiles().applyPreset(otherPreset(document()), Side::A));
    }

  private:
    QAction* take_;
};

TEST_F(Snapshots, Restored_IsTheLookAgainInOneStep) {
    const Material kept = *document().material(Side::A);
    take();
    ASSERT_EQ(list().count(), 1);
    EXPECT_FALSE(list().item(0)->icon().isNull());
    change();
    const int steps = document().undoStack().index();
    press("Restore");
    EXPECT_EQ(*document().material(Side::A), kept);
    EXPECT_EQ(document().undoStack().index(), steps + 1);
    document().undoStack().undo();
    EXPECT_NE(*document().material(Side::A), kept);
}

TEST_F(Snapshots, Compared_IsOnSideB) {
    const Material kept = *document().material(Side::A);
    take();
    change();
    press("Compare");
    ASSERT_TRUE(document().isComparing());
    EXPECT_EQ(*document().material(Side::B), kept);
}

TEST_F(Snapshots, Taken_IsUndoneAndDoneAgain) {
    take();
    document().undoStack().undo();
    EXPECT_EQ(list().count(), 0);
    document().undoStack().redo();
    EXPECT_EQ(list().count(), 1);
}

TEST(SnapshotsInAFile, AreThereAgain) {
    FixtureDocument fixture;
    const TemporaryFolder folder;
    takeSnapshot(fixture.document, "picture");
    takeSnapshot(fixture.document, "another");
    renameSnapshot(fixture.document, 1, "Warm");
    const std::vector<Snapshot> kept = fixture.document.state().snapshots;
    ASSERT_EQ(kept.size(), 2u);
    EXPECT_NE(kept[0].name, kept[1].name);
    ASSERT_TRUE(fixture.files.saveScene(folder / "a.patina-scene.json"));
    fixture.files.startFrom(Scene());
    ASSERT_TRUE(fixture.files.openScene(folder / "a.patina-scene.json"));
    EXPECT_EQ(fixture.document.state().snapshots, kept);
    EXPECT_FALSE(fixture.document.scene().extras.contains("snapshots"));
}

TEST(SnapshotsInAFile, PictureThatIsTooLarge_IsLeftOutAndTheLookIsThere) {
    FixtureDocument fixture;
    takeSnapshot(fixture.document, std::string(2u << 20, 'p'));
    const auto json = snapshotsToJson(fixture.document.state().snapshots);
    const auto read = snapshotsFromJson(json, {}, fixture.document.catalog(), {});
    ASSERT_EQ(read.size(), 1u);
    EXPECT_EQ(read[0].material, fixture.document.state().snapshots[0].material);
    EXPECT_EQ(read[0].png, "");
}

} // namespace
} // namespace patina::tests::snapshots_test
