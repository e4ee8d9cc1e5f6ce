// SPDX-License-Identifier: GPL-3.0-or-later
// What can be done to a material as a whole, in the window.
#include <QDockWidget>
#include <QTest>
#include <QToolButton>

#include "ui/window_fixture.h"

namespace patina::tests::material_actions_test {
namespace {

class MaterialInTheWindow : public WindowFixture {
  protected:
    MaterialActions& actions() { return *window().findChild<MaterialActions*>(); }
    void trigger(const QString& text) {
        const auto all = actions().all();
        const auto found = std::ranges::find(all, text, &QAction::text);
        ASSERT_NE(found, all.end()) << text.toStdString();
        (*found)->trigger();
    }
    void setColour(const glm::dvec3& colour) {
        document().setValue(document().selection().currentPath(kinds::models), "diffuse.color",
                            colour);
    }
    /// What the first view shows.
    const Material& shown() { return view().viewed().sources().scene().objects.front().material; }
};

TEST_F(MaterialInTheWindow, Original_IsShownWithoutAnEditAndGoesWithTheNextOne) {
    const Material opened = *document().material(Side::A);
    setColour(glm::dvec3(0.0, 0.1, 0.9));
    const int steps = document().undoStack().count();
    const Scene scene = document().scene();
    focusView();
    QTest::keyClick(&view(), Qt::Key_O);
    EXPECT_TRUE(actions().original()->isChecked());
    EXPECT_EQ(shown(), opened);
    EXPECT_GT(newFrames(), 0);
    EXPECT_EQ(document().undoStack().count(), steps);
    EXPECT_EQ(document().scene(), scene);
    QTest::keyClick(&view(), Qt::Key_O);
    EXPECT_EQ(shown(), *document().material(Side::A));
    QTest::keyClick(&view(), Qt::Key_O);
    setColour(glm::dvec3(0.0, 0.9, 0.1));
    EXPECT_FALSE(actions().original()->isChecked());
    EXPECT_EQ(shown(), *document().material(Side::A));
}

TEST_F(MaterialInTheWindow, OriginalButton_TogglesWhenItIsClicked) {
    setColour(glm::dvec3(0.0, 0.1, 0.9));
    QToolButton* button = window().dock("parameters")->findChild<QToolButton*>("original");
    button->click();
    EXPECT_TRUE(actions().original()->isChecked());
    EXPECT_TRUE(button->isChecked());
    button->click();
    EXPECT_FALSE(actions().original()->isChecked());
    EXPECT_FALSE(button->isChecked());
}

TEST_F(MaterialInTheWindow, DefaultOfTheModel_CountsUntilItIsForgotten) {
    const auto choose = [this](const char* model) {
        Material plain = defaultMaterial(*document().catalog().find(kinds::models, "lambert"));
        document().replaceMaterial(Side::A, plain, "Plain");
        document().setModel(Side::A, model);
    };
    const auto gloss = [this] {
        const BlockPath path = document().selection().currentPath(kinds::models);
        return document().value(path, *document().block(path)->parameter("gloss"));
    };
    choose("phong");
    const Value usual = gloss();
    document().setValue(document().selection().currentPath(kinds::models), "gloss", 0.25);
    trigger("Set as &Default of the Model");
    choose("phong");
    EXPECT_EQ(gloss(), Value(0.25));
    close();
    open();
    choose("phong");
    EXPECT_EQ(gloss(), Value(0.25)); // at the next start
    trigger("&Forget the Default of the Model");
    choose("phong");
    EXPECT_EQ(gloss(), usual);
}

} // namespace
} // namespace patina::tests::material_actions_test
