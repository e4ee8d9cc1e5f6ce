// SPDX-License-Identifier: GPL-3.0-or-later
// The exact way beside another one, which chooses nothing.
#include "ui/accuracy_fixture.h"
#include "viewport/side_view.h"

namespace patina::tests::accuracy_compare_test {
namespace {

TEST_F(MeasuredPanel, Compared_HasTheExactWayInAAndTheChosenInB) {
    window().resize(1400, 800); // room for both titles
    dock().apply(pointOf("near"));
    settle();
    const int before = steps();
    list().select(pointOf("far"));
    dock().compare(list().selected());
    EXPECT_EQ(steps(), before + 1);
    EXPECT_EQ(level(Side::A), "");
    EXPECT_EQ(level(Side::B), "far");
    for (SideView* view : window().findChildren<SideView*>()) {
        const QLabel& title = *view->findChild<QLabel*>("title");
        const QString what = view->side() == Side::A ? "Exact" : "Work: Far";
        EXPECT_TRUE(title.toolTip().startsWith(what + " – Burning"))
            << title.toolTip().toStdString();
        EXPECT_TRUE(title.text().contains(what.left(5))) << title.text().toStdString();
    }
}

TEST_F(MeasuredPanel, EndOfComparing_PutsBackWhatWasThere) {
    dock().apply(pointOf("near"));
    const Material chosen = *document().material(Side::A);
    dock().compare(pointOf("far"));
    dock().compare(pointOf("near"));
    EXPECT_EQ(level(Side::A), "");
    const int before = steps();
    window().comparison().setComparing(false);
    EXPECT_EQ(steps(), before + 1);
    EXPECT_EQ(*document().material(Side::A), chosen);
    document().undoStack().undo();
    EXPECT_EQ(level(Side::A), "");
    EXPECT_EQ(level(Side::B), "near");
    window().comparison().setComparing(false);
    EXPECT_EQ(*document().material(Side::A), chosen);
}

TEST_F(MeasuredPanel, ComparedSideB_LeavesSideAAsItWas) {
    const int far = pointOf("far");
    window().comparison().setComparing(true);
    document().selection().setSide(Side::B);
    Material other = *document().material(Side::A);
    other.opacity = 0.5;
    document().replaceMaterial(Side::A, other, "Another");
    dock().compare(far);
    window().comparison().setComparing(false);
    EXPECT_EQ(*document().material(Side::A), other);
}

TEST_F(MeasuredPanel, SavedWhileComparing_KeepsTheChoice) {
    dock().apply(pointOf("near"));
    dock().compare(pointOf("far"));
    const std::filesystem::path preset = home("kept.patina.json");
    ASSERT_TRUE(window().documentFiles().savePreset(preset, Side::A));
    EXPECT_NE(readFile(preset).find("\"work\": \"near\""), std::string::npos);
    EXPECT_EQ(level(Side::A), "");
    const std::filesystem::path scene = home("kept.patina-scene.json");
    ASSERT_TRUE(window().documentFiles().saveScene(scene));
    ASSERT_TRUE(window().documentFiles().openScene(scene));
    EXPECT_EQ(level(Side::A), "near");
    EXPECT_EQ(level(Side::B), "far");
}

TEST_F(MeasuredPanel, EditedWhileComparing_StaysEditedAfterwards) {
    const int far = pointOf("far");
    dock().apply(pointOf("near"));
    dock().compare(far);
    document().setValue(document().selection().currentPath(settings::material), "opacity", 0.5);
    window().comparison().setComparing(false);
    EXPECT_EQ(document().material(Side::A)->opacity, 0.5);
    EXPECT_EQ(level(Side::A), "near");
}

TEST_F(MeasuredPanel, ChosenWhileComparing_IsChosen) {
    dock().apply(pointOf("near"));
    dock().compare(pointOf("far"));
    dock().apply(0); // the exact way
    window().comparison().setComparing(false);
    EXPECT_EQ(level(Side::A), "");
    document().undoStack().undo();
    document().undoStack().undo();
    window().comparison().setComparing(false);
    EXPECT_EQ(level(Side::A), "near");
}

} // namespace
} // namespace patina::tests::accuracy_compare_test
