// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDropEvent>
#include <QMimeData>
#include <QSlider>

#include "docks/preset_filter_menu.h"
#include "library/preset_library.h"
#include "material/preset_file.h"
#include "ui/preset_window.h"

namespace patina::tests::presets_dock_test {
namespace {

class PresetSearch : public PresetWindow {
  protected:
    void SetUp() override {
        PresetWindow::SetUp();
        view().setCurrentIndex(view().model()->index(0, 0));
    }
};

TEST_F(PresetSearch, Enter_PutsAHitThatIsShownOnTheSide) {
    const QString before = shown(0);
    QTest::keyClicks(&search(), "gold");
    ASSERT_NE(shown(0), before);
    QTest::keyClick(&search(), Qt::Key_Return);
    EXPECT_EQ(nameOnA(), shown(0));
}

/// A preset whose description alone has the word stands behind those of that name.
TEST_F(PresetSearch, HitsInNames_ComeFirst) {
    QTest::keyClicks(&search(), "clay");
    ASSERT_GE(count(), 2);
    EXPECT_TRUE(shown(0).contains("clay", Qt::CaseInsensitive)) << shown(0).toStdString();
}

TEST_F(PresetSearch, EnterWithoutAHit_ChangesNothing) {
    QTest::keyClicks(&search(), "no such preset");
    QTest::keyClick(&search(), Qt::Key_Return);
    EXPECT_EQ(edits(), 0);
}

TEST_F(PresetSearch, WordsOfModelAndAuthor_AreFound) {
    QTest::keyClicks(&search(), "ward");
    const int ofModel = count();
    EXPECT_GE(ofModel, 3);
    QTest::keyClicks(&search(), " patina");
    EXPECT_GT(count(), 0);
    QTest::keyClicks(&search(), "xyz");
    EXPECT_EQ(count(), 0);
}

class PresetsTried : public PresetWindow {};

TEST_F(PresetsTried, Click_ShowsThePresetWithoutAnEdit) {
    click(1);
    EXPECT_EQ(seen().name, shown(1).toStdString());
    EXPECT_NE(nameOnA(), shown(1));
    EXPECT_EQ(edits(), 0);
    EXPECT_FALSE(document().isModified());
    EXPECT_TRUE(notice().text().contains(shown(1))) << notice().text().toStdString();
}

TEST_F(PresetsTried, Escape_ShowsTheMaterialAgain) {
    const Material before = seen();
    click(1);
    QTest::keyClick(&view(), Qt::Key_Escape);
    EXPECT_EQ(seen(), before);
    EXPECT_FALSE(notice().isVisibleTo(&dock()));
}

TEST_F(PresetsTried, FocusInAnotherPanel_ShowsTheMaterialAgainButAViewDoesNot) {
    const Material before = seen();
    view().setFocus();
    click(1);
    WindowFixture::view().setFocus();
    EXPECT_NE(seen(), before);
    window().dock("models")->widget()->findChild<QListView*>()->setFocus();
    EXPECT_EQ(seen(), before);
}

TEST_F(PresetsTried, Edit_EndsTrying) {
    click(1);
    document().setModel(Side::A, "lambert");
    EXPECT_EQ(seen(), *document().material(Side::A));
}

TEST_F(PresetsTried, Enter_AppliesItAsOneStep) {
    click(1);
    QTest::keyClick(&view(), Qt::Key_Return);
    EXPECT_EQ(nameOnA(), shown(1));
    EXPECT_EQ(edits(), 1);
}

TEST_F(PresetsTried, DoubleClick_IsOneStep) {
    click(1);
    QTest::mouseDClick(view().viewport(), Qt::LeftButton, {}, placeOf(1));
    EXPECT_EQ(nameOnA(), shown(1));
    EXPECT_EQ(edits(), 1);
}

TEST_F(PresetsTried, ArrowKeys_TryTheNext) {
    click(1);
    QTest::keyClick(&view(), Qt::Key_Right);
    EXPECT_EQ(seen().name, shown(2).toStdString());
    EXPECT_EQ(edits(), 0);
}

TEST_F(PresetsTried, ApplyingOne_MakesItRecent) {
    click(3);
    QTest::keyClick(&view(), Qt::Key_Return);
    auto* menu = dock().findChild<PresetFilterMenu*>();
    Q_EMIT menu->aboutToShow();
    for (QAction* action : menu->actions()) {
        if (action->text() == "Recently used") {
            action->trigger();
        }
    }
    EXPECT_EQ(count(), 1);
    EXPECT_EQ(shown(0), nameOnA());
}

class PresetsDropped : public PresetWindow {
  protected:
    void drop(QPointF place) {
        QMimeData files;
        files.setUrls(
            {QUrl::fromLocalFile(QString::fromStdString(otherPreset(document()).string()))});
        QDragEnterEvent enter(place.toPoint(), Qt::CopyAction, &files, Qt::LeftButton, {});
        QApplication::sendEvent(&WindowFixture::view(), &enter);
        QDropEvent event(place, Qt::CopyAction, &files, Qt::LeftButton, {});
        QApplication::sendEvent(&WindowFixture::view(), &event);
    }
};

TEST_F(PresetsDropped, OnAnObject_IsForThatObject) {
    Object beside = document().scene().objects.front();
    beside.name = "Beside";
    beside.translation = {100.0, 0.0, 0.0};
    window().files().meshes().addObject(beside);
    ASSERT_EQ(document().selection().object(), 1);
    const Material before = document().scene().objects[1].material;
    drop(QRectF(WindowFixture::view().rect()).center());
    EXPECT_EQ(document().selection().object(), 0);
    EXPECT_EQ(document().scene().objects[1].material, before);
    EXPECT_NE(document().scene().objects[0].material, before);
}

class PresetFolders : public PresetWindow {
  protected:
    /// A preset in a folder of the user's choice, and the folder.
    std::filesystem::path writeIn(const std::string& folder, const std::string& name) {
        Material material = *document().material(Side::A);
        material.name = name;
        std::filesystem::create_directories(home(folder));
        writeFile(home(folder) / (name + ".patina.json"), writeJson(toJson(material)));
        return home(folder);
    }
    PresetLibrary& library() { return window().dockContext().presets; }
    bool isShown(const QString& name, bool there = true) {
        return QTest::qWaitFor(
            [&] {
                for (int row = 0; row < count(); ++row) {
                    if (shown(row) == name) {
                        return there;
                    }
                }
                return !there;
            },
            20000);
    }
};

TEST_F(PresetFolders, AddedOne_IsShownWatchedAndRemembered) {
    const QString folder = QString::fromStdString(writeIn("mine", "First of mine").string());
    library().addFolder(folder);
    EXPECT_TRUE(isShown("First of mine"));
    writeIn("mine", "Second of mine");
    EXPECT_TRUE(isShown("Second of mine"));
    close();
    open();
    window().startRest();
    EXPECT_TRUE(isShown("Second of mine"));
}

TEST_F(PresetFolders, RemovedOne_StaysOnTheDisk) {
    const auto folder = writeIn("mine", "First of mine");
    library().addFolder(QString::fromStdString(folder.string()));
    ASSERT_TRUE(isShown("First of mine"));
    library().removeFolder(QString::fromStdString(folder.string()));
    EXPECT_TRUE(isShown("First of mine", false));
    EXPECT_TRUE(std::filesystem::exists(folder / "First of mine.patina.json"));
}

TEST_F(PresetFolders, NewFolderInsideOne_IsWatchedToo) {
    writeIn("XDG_DATA_HOME/patina/presets/inside", "Within");
    EXPECT_TRUE(isShown("Within"));
    writeIn("XDG_DATA_HOME/patina/presets/inside", "Within too");
    EXPECT_TRUE(isShown("Within too"));
}

/// Shows presets whose pictures nobody made before.
class PresetPictures : public PresetWindow {
  protected:
    void SetUp() override {
        std::filesystem::remove(home("XDG_CACHE_HOME") / "patina/thumbnails");
        PresetWindow::SetUp();
    }
};

TEST_F(PresetPictures, InSight_AreMade) {
    const auto picture = [this] {
        return view().model()->index(0, 0).data(Qt::DecorationRole).value<QIcon>().pixmap(48);
    };
    const QImage empty = picture().toImage();
    EXPECT_TRUE(QTest::qWaitFor([&] { return picture().toImage() != empty; }, 60000));
}

TEST_F(PresetPictures, Size_IsRemembered) {
    dock().findChild<QSlider*>()->setValue(120);
    close();
    open();
    EXPECT_EQ(view().pictureSize(), 120);
}

} // namespace
} // namespace patina::tests::presets_dock_test
