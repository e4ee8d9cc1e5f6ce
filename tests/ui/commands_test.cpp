// SPDX-License-Identifier: GPL-3.0-or-later
// Commands by their keys and their names, and what an artist sets once.
#include <ctime>

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QGroupBox>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QTabWidget>
#include <QTest>
#include <QTreeWidget>
#include <QWheelEvent>

#include "support/program.h"
#include "ui/preset_window.h"
#include "ui/window_fixture.h"

namespace patina::tests::commands_test {
namespace {

class Commands : public WindowFixture {
  protected:
    Commands() { focusView(); }

    QDialog* dialog(const char* name) { return window().findChild<QDialog*>(name); }
    void key(QWidget* widget, Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::keyClick(widget, key, modifiers);
    }
    QTreeWidgetItem* rowOf(QDialog* sheet, const QString& text) {
        const auto found = sheet->findChild<QTreeWidget*>()->findItems(
            text, Qt::MatchFixedString | Qt::MatchRecursive);
        return found.isEmpty() ? nullptr : found.front();
    }
};

void press(QDialog* sheet, const QString& text) {
    const auto buttons = sheet->findChildren<QPushButton*>();
    const auto button = std::ranges::find(buttons, text, &QPushButton::text);
    ASSERT_NE(button, buttons.end()) << text.toStdString();
    QTest::mouseClick(*button, Qt::LeftButton);
}

TEST_F(Commands, F1_ListsEveryKeyAndSearchesThem) {
    view().setFocus();
    key(&view(), Qt::Key_F1);
    QDialog* sheet = dialog("shortcutSheet");
    ASSERT_NE(sheet, nullptr);
    ASSERT_NE(rowOf(sheet, "Export Picture"), nullptr);
    EXPECT_EQ(rowOf(sheet, "Export Picture")->text(1), "Ctrl+Shift+E; F12");
    QTest::keyClicks(sheet->findChild<QLineEdit*>(), "picture export");
    EXPECT_FALSE(rowOf(sheet, "Export Picture")->isHidden());
    EXPECT_TRUE(rowOf(sheet, "Take Snapshot")->isHidden());
}

TEST_F(Commands, KeyThatIsTaken_IsToldAndTakenAwayAndKept) {
    key(&view(), Qt::Key_F1);
    QDialog* sheet = dialog("shortcutSheet");
    ASSERT_NE(sheet, nullptr);
    sheet->findChild<QTreeWidget*>()->setCurrentItem(rowOf(sheet, "Take Snapshot"));
    auto* edit = sheet->findChild<QKeySequenceEdit*>();
    edit->setFocus();
    key(edit, Qt::Key_D, Qt::ControlModifier);
    const auto labels = sheet->findChildren<QLabel*>();
    const auto tellsHolder = [&labels] {
        return std::ranges::any_of(
            labels, [](const QLabel* label) { return label->text().contains("Difference"); });
    };
    EXPECT_TRUE(QTest::qWaitFor(tellsHolder)); // more keys might follow
    press(sheet, "Set");
    EXPECT_EQ(rowOf(sheet, "Take Snapshot")->text(1), "Ctrl+D");
    EXPECT_EQ(rowOf(sheet, "Difference")->text(1), "");
    sheet->close();
    close();
    open();
    focusView();
    key(&view(), Qt::Key_F1);
    EXPECT_EQ(rowOf(dialog("shortcutSheet"), "Take Snapshot")->text(1), "Ctrl+D");
}

TEST_F(Commands, UsualKeysThatAreWantedBack_AreTakenFromWhoHasThem) {
    key(&view(), Qt::Key_F1);
    QDialog* sheet = dialog("shortcutSheet");
    ASSERT_NE(sheet, nullptr);
    sheet->findChild<QTreeWidget*>()->setCurrentItem(rowOf(sheet, "Take Snapshot"));
    sheet->findChild<QKeySequenceEdit*>()->setKeySequence(QKeySequence("Ctrl+D"));
    press(sheet, "Set");
    ASSERT_EQ(rowOf(sheet, "Difference")->text(1), "");
    sheet->findChild<QTreeWidget*>()->setCurrentItem(rowOf(sheet, "Difference"));
    press(sheet, "As Usual");
    EXPECT_EQ(rowOf(sheet, "Difference")->text(1), "Ctrl+D");
    EXPECT_EQ(rowOf(sheet, "Take Snapshot")->text(1), "");
}

TEST_F(Commands, CtrlK_RunsACommandByItsName) {
    key(&view(), Qt::Key_K, Qt::ControlModifier);
    QDialog* palette = dialog("commandPalette");
    ASSERT_NE(palette, nullptr);
    auto* search = palette->findChild<QLineEdit*>();
    QTest::keyClicks(search, "orthographic");
    key(search, Qt::Key_Return);
    EXPECT_EQ(camera().fieldOfView, 1.0);
}

TEST_F(Commands, CtrlK_BringsUpThePanelThatHasWhatIsSearched) {
    QDockWidget* scene = window().dock("scene");
    ASSERT_TRUE(scene->isVisibleTo(&window())); // as a tab behind others
    key(&view(), Qt::Key_K, Qt::ControlModifier);
    QDialog* palette = dialog("commandPalette");
    ASSERT_NE(palette, nullptr);
    auto* search = palette->findChild<QLineEdit*>();
    QTest::keyClicks(search, "picture passes");
    key(search, Qt::Key_Return);
    EXPECT_TRUE(QTest::qWaitFor([scene] { return !scene->visibleRegion().isEmpty(); }));
}

/// A word is looked for at the beginnings of words first.
TEST_F(Commands, WordThatBeginsAName_ComesBeforeOneWithinANother) {
    for (const auto& [words, first] : {std::pair("tone", "View \u203a Panels"),
                                       {"dark f", "Lighting: Dark field"},
                                       {"halft", "Model: Halftone"}}) {
        key(&view(), Qt::Key_K, Qt::ControlModifier);
        QDialog* palette = dialog("commandPalette");
        ASSERT_NE(palette, nullptr);
        auto* search = palette->findChild<QLineEdit*>();
        QTest::keyClicks(search, words);
        const QString shown = palette->findChild<QListWidget*>()->item(0)->text();
        EXPECT_TRUE(shown.startsWith(first)) << words << ": " << shown.toStdString();
        key(search, Qt::Key_Escape);
        EXPECT_TRUE(QTest::qWaitFor([this] { return dialog("commandPalette") == nullptr; }));
    }
}

TEST_F(Commands, TabOfAPanel_IsFoundByItsName) {
    const std::pair<const char*, const char*> tabs[] = {{"match", "Match"},
                                                        {"all models", "All Models"},
                                                        {"find cheaper", "Cheaper Ways"},
                                                        {"spectrum", "Spectrum"}};
    for (const auto& [words, title] : tabs) {
        key(&view(), Qt::Key_K, Qt::ControlModifier);
        QDialog* palette = dialog("commandPalette");
        ASSERT_NE(palette, nullptr);
        auto* search = palette->findChild<QLineEdit*>();
        QTest::keyClicks(search, words);
        key(search, Qt::Key_Return);
        const QString shown = title;
        EXPECT_TRUE(QTest::qWaitFor([this, &shown] {
            const auto all = window().findChildren<QTabWidget*>();
            return std::ranges::any_of(all, [&shown](const QTabWidget* each) {
                return each->tabText(each->currentIndex()) == shown &&
                       !each->currentWidget()->visibleRegion().isEmpty();
            });
        })) << title;
        EXPECT_TRUE(QTest::qWaitFor([this] { return dialog("commandPalette") == nullptr; }));
    }
    key(&view(), Qt::Key_F1); // lists each of them
    const auto* pages = window().dock("accuracy")->findChild<QTabWidget*>();
    for (int i = 0; i < pages->count(); ++i) {
        const QString row =
            QStringLiteral("Panels \u203a Pages of Accuracy \u203a ") + pages->tabText(i);
        EXPECT_NE(rowOf(dialog("shortcutSheet"), row), nullptr) << row.toStdString();
    }
}

/// What moves a camera is told as the chosen scheme has it.
TEST_F(Commands, F1_ListsTheDragsOfTheMouseScheme) {
    Session().setMouseHabits({MouseScheme::Blender, false});
    key(&view(), Qt::Key_F1);
    const auto keysOf = [this](const char* what) {
        const QTreeWidgetItem* row = rowOf(dialog("shortcutSheet"), what);
        return row == nullptr ? QString() : row->text(1);
    };
    EXPECT_TRUE(keysOf("Orbit").startsWith("Middle drag"));
    EXPECT_TRUE(keysOf("Move nearer or farther").contains("Ctrl+middle"));
}

/// The scene's dock has no tabs but is longer than it is high.
TEST_F(Commands, SectionOfADock_IsScrolledToByItsName) {
    key(&view(), Qt::Key_K, Qt::ControlModifier);
    QDialog* palette = dialog("commandPalette");
    ASSERT_NE(palette, nullptr);
    QTest::keyClicks(palette->findChild<QLineEdit*>(), "picture passes");
    key(palette->findChild<QLineEdit*>(), Qt::Key_Return);
    const auto fromTheTop = [this]() -> std::optional<int> { // pixels
        const QWidget* dock = window().dock("scene");
        const auto all = dock->findChildren<QGroupBox*>();
        const auto passes = std::ranges::find(all, "Picture Passes", &QGroupBox::title);
        const auto* area = dock->findChild<QScrollArea*>();
        return passes == all.end() || !(*passes)->isVisible()
                   ? std::nullopt
                   : std::optional((*passes)->mapTo(area, QPoint()).y());
    };
    EXPECT_TRUE(QTest::qWaitFor([&fromTheTop] { return fromTheTop() == 0; }));
    QTest::qWait(100); // what was late would move it
    EXPECT_EQ(fromTheTop(), 0);
}

TEST_F(Commands, CtrlKWithoutAMatch_SaysSo) {
    key(&view(), Qt::Key_K, Qt::ControlModifier);
    QDialog* palette = dialog("commandPalette");
    ASSERT_NE(palette, nullptr);
    EXPECT_FALSE(palette->findChild<QLabel*>()->isVisible());
    QTest::keyClicks(palette->findChild<QLineEdit*>(), "xyzzy");
    EXPECT_TRUE(palette->findChild<QLabel*>()->isVisible());
}

TEST_F(Commands, NameOfAModel_ChoosesItInOneStep) {
    const int before = document().undoStack().count();
    key(&view(), Qt::Key_K, Qt::ControlModifier);
    auto* search = dialog("commandPalette")->findChild<QLineEdit*>();
    QTest::keyClicks(search, "tonal art maps");
    key(search, Qt::Key_Return);
    EXPECT_EQ(document().material(Side::A)->model.id, "tonal-art-maps");
    EXPECT_EQ(document().undoStack().count(), before + 1);
}

TEST_F(Commands, SingleLetter_ActsInAViewOnly) {
    const auto actions = window().findChildren<QAction*>();
    const auto inspect = *std::ranges::find(actions, QString("inspect"), &QAction::objectName);
    auto* elsewhere = window().dock("lights")->findChild<QAbstractItemView*>();
    ASSERT_NE(elsewhere, nullptr);
    elsewhere->setFocus();
    key(elsewhere, Qt::Key_N);
    EXPECT_FALSE(inspect->isChecked());
    view().setFocus();
    key(&view(), Qt::Key_N);
    EXPECT_TRUE(inspect->isChecked());
}

TEST_F(Commands, BlenderMouse_OrbitsWithTheMiddleButtonOnly) {
    key(&view(), Qt::Key_Comma, Qt::ControlModifier);
    QDialog* preferences = dialog("preferences");
    ASSERT_NE(preferences, nullptr);
    preferences->findChild<QComboBox*>("mouseScheme")->setCurrentIndex(2);
    preferences->close();
    const Camera before = camera();
    drag(Qt::LeftButton, Qt::NoModifier, {40, 10});
    EXPECT_EQ(camera(), before);
    drag(Qt::MiddleButton, Qt::NoModifier, {40, 10});
    EXPECT_NE(camera().yaw, before.yaw);
    EXPECT_EQ(Session().mouseHabits().scheme, MouseScheme::Blender);
}

TEST_F(Commands, WheelThatDoesNotZoom_StillZoomsWithCtrl) {
    key(&view(), Qt::Key_Comma, Qt::ControlModifier);
    dialog("preferences")->findChild<QCheckBox*>("wheelZooms")->setChecked(false);
    dialog("preferences")->close();
    const auto wheel = [this](Qt::KeyboardModifiers modifiers) {
        const QPointF at(view().rect().center());
        QWheelEvent event(at, view().mapToGlobal(at), {}, {0, 120}, Qt::NoButton, modifiers,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&view(), &event);
    };
    const double before = camera().distance;
    wheel(Qt::NoModifier);
    EXPECT_EQ(camera().distance, before);
    wheel(Qt::ControlModifier);
    EXPECT_LT(camera().distance, before);
}

/// Milliseconds that this thread has worked.
double workedMs() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * double(time.tv_sec) + 1e-6 * double(time.tv_nsec);
}

class ManyPresets : public PresetWindow {
  protected:
    static constexpr int many = 5000;

    ManyPresets() {
        const std::filesystem::path folder = presets() / "many";
        std::filesystem::create_directories(folder);
        for (int i = 0; i < many; ++i) {
            const std::string number = std::to_string(i);
            writeFile(folder / (number + ".patina.json"),
                      R"({"format": "patina.preset", "version": 1, "name": "Paint )" + number +
                          R"(", "model": {"id": "lambert", "version": 1}})");
        }
    }
};

/// By the window's own clock, which does not depend on what else the machine does.
TEST_F(ManyPresets, CtrlK_OpensAndSearchesQuickly) {
    ASSERT_TRUE(QTest::qWaitFor([this] { return count() > many; }, 60000));
    QTest::qWait(1000);
    double before = workedMs();
    QTest::keyClick(&WindowFixture::view(), Qt::Key_K, Qt::ControlModifier);
    auto* palette = window().findChild<QDialog*>("commandPalette");
    const double opening = workedMs() - before;
    ASSERT_NE(palette, nullptr);
    double longest = 0.0;
    for (const char* words : {"p", "paint", "paint 49", "preset: paint 4999"}) {
        before = workedMs();
        palette->findChild<QLineEdit*>()->setText(words);
        longest = std::max(longest, workedMs() - before);
    }
    EXPECT_LT(opening, 50.0);
    EXPECT_LT(longest, 50.0);
}

} // namespace
} // namespace patina::tests::commands_test
