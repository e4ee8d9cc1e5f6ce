// SPDX-License-Identifier: GPL-3.0-or-later
// What CONTRIBUTING.md shows how to add to the editor, as it stands there.
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

#include "docks/object_count_dock.h"
#include "document/commands/solo_command.h"
#include "document/scene_edits.h"
#include "parameters/parameter_editor.h"
#include "text/display_number.h"
#include "ui/window_fixture.h"
#include "window/lazy_dock.h"

namespace patina {
ParameterEditor* makeStopsEditor(const Parameter& parameter, QWidget* parent);
} // namespace patina

namespace patina::tests::recipes_test {
namespace {

class RecipesTest : public WindowFixture {};

TEST_F(RecipesTest, DockOfTheGuide_FollowsTheDocument) {
    const auto make = [](const DockContext& context) { return new ObjectCountDock(context); };
    LazyDock dock({"object-count", "Objects", DockPlace::Bottom, make}, window().dockContext(),
                  &window());
    window().addDockWidget(Qt::BottomDockWidgetArea, &dock);
    dock.show();
    const auto* label = qobject_cast<QLabel*>(dock.widget());
    ASSERT_NE(label, nullptr);
    EXPECT_EQ(label->text(), "1 object(s)");
    window().files().meshes().addBeside(Object());
    EXPECT_EQ(label->text(), "2 object(s)");
}

TEST_F(RecipesTest, EditorOfTheGuidesType_TellsOfEdits) {
    Parameter parameter;
    parameter.defaultValue = 0.0;
    parameter.min = -4.0;
    parameter.max = 4.0;
    const std::unique_ptr<ParameterEditor> editor(makeStopsEditor(parameter, nullptr));
    editor->present(Value(1.0));
    const auto* box = editor->findChild<QLineEdit*>();
    ASSERT_NE(box, nullptr);
    EXPECT_EQ(numberLocale().toDouble(box->text()), 1.0);
    QSignalSpy edits(editor.get(), &ParameterEditor::edited);
    QTest::keyClick(editor->focusTarget(), Qt::Key_Up);
    EXPECT_EQ(edits.count(), 1);
}

/// Which of the document's lights are on.
std::vector<bool> lit(const Document& document) {
    std::vector<bool> on;
    for (const Light& light : document.scene().lights) {
        on.push_back(light.enabled);
    }
    return on;
}

/// A scene of three lights.
class EditOfTheGuide : public RecipesTest {
  protected:
    EditOfTheGuide() {
        while (document().scene().lights.size() < 3) {
            addLight(document(), "point");
        }
        document().undoStack().clear();
    }
    int steps() { return document().undoStack().count(); }
};

TEST_F(EditOfTheGuide, Edit_IsUndoneAndDoneAgain) {
    const std::vector<Light> before = document().scene().lights;
    int heard = 0;
    onChange(document(), DocumentChange::Lights, &window(), [&heard] { ++heard; });
    soloLight(document(), 1);
    EXPECT_EQ(lit(document()), (std::vector{false, true, false}));
    document().undoStack().undo();
    EXPECT_EQ(document().scene().lights, before);
    document().undoStack().redo();
    EXPECT_EQ(lit(document()), (std::vector{false, true, false}));
    EXPECT_EQ(heard, 3);
}

TEST_F(EditOfTheGuide, EditThatChangesNothing_IsNoStep) {
    soloLight(document(), 1);
    soloLight(document(), 1);
    EXPECT_EQ(steps(), 1);
}

TEST_F(EditOfTheGuide, EditsOfOneInteraction_AreOneStep) {
    const std::vector<Light> before = document().scene().lights;
    const int token = document().interaction().begin();
    for (const std::size_t index : {0u, 1u, 2u}) {
        soloLight(document(), index);
    }
    document().interaction().end(token);
    EXPECT_EQ(steps(), 1);
    soloLight(document(), 0);
    EXPECT_EQ(steps(), 2);
    document().undoStack().undo();
    document().undoStack().undo();
    EXPECT_EQ(document().scene().lights, before);
}

TEST_F(EditOfTheGuide, EditsOfOtherKindsInOneInteraction_AreStepsOfTheirOwn) {
    const int token = document().interaction().begin();
    soloLight(document(), 0);
    setLight(document(), 1, document().scene().lights[0]);
    document().interaction().end(token);
    EXPECT_EQ(steps(), 2);
}

TEST_F(EditOfTheGuide, InteractionThatEndsWhereItBegan_IsNoStep) {
    soloLight(document(), 0);
    const int token = document().interaction().begin();
    soloLight(document(), 1);
    soloLight(document(), 0);
    document().interaction().end(token);
    EXPECT_EQ(steps(), 1);
}

} // namespace
} // namespace patina::tests::recipes_test
