// SPDX-License-Identifier: GPL-3.0-or-later
// The text of the current object's shader, and what its functions take in the margin.
#include <QCheckBox>
#include <QDockWidget>
#include <QLabel>
#include <QTest>
#include <QToolButton>

#include "docks/shader_dock.h"
#include "docks/shader_text_view.h"
#include "document/document.h"
#include "ui/window_fixture.h"

namespace patina::tests::shader_dock_test {
namespace {

constexpr int waitMs = 120000;

class ShaderPanel : public WindowFixture {
  protected:
    ShaderPanel() {
        window().documentFiles().openTemplate(threeLightsFile()); // whose programs are short
        document().setModel(Side::A, "lambert");
        window().dock("shader")->show();
        finish();
    }

    ShaderDock& dock() { return *window().dock("shader")->findChild<ShaderDock*>(); }
    ShaderTextView& text() { return *dock().findChild<ShaderTextView*>(); }
    QCheckBox& margin() { return *dock().findChild<QCheckBox*>(); }
    QString state() { return dock().findChild<QLabel*>("state")->text(); }

    bool finish() {
        settle();
        return QTest::qWaitFor([this] { return !dock().isWorking(); }, waitMs);
    }
};

TEST_F(ShaderPanel, Text_FollowsTheModelAndHasNoOther) {
    EXPECT_TRUE(text().toPlainText().contains("vec3 lambert("));
    EXPECT_TRUE(text().isReadOnly());
    EXPECT_TRUE(text().margins().empty()) << "it was not asked for";
    document().setModel(Side::A, "minnaert");
    ASSERT_TRUE(finish());
    EXPECT_TRUE(text().toPlainText().contains("vec3 minnaert("));
    EXPECT_FALSE(text().toPlainText().contains("vec3 lambert("));
    EXPECT_FALSE(text().toPlainText().contains("#line")) << "nobody reads those";
}

TEST_F(ShaderPanel, Margin_StandsAtTheFunctionsAndIsPredictedBesideTheWindow) {
    margin().click();
    EXPECT_TRUE(dock().isWorking()) << "the window goes on";
    ASSERT_TRUE(finish());
    const QStringList lines = text().toPlainText().split('\n');
    int model = 0;
    for (const auto& [line, words] : text().margins()) {
        model = lines.at(line - 1).startsWith("vec3 lambert(") ? line : model;
        EXPECT_TRUE(lines.at(line - 1).contains('(')) << lines.at(line - 1).toStdString();
    }
    ASSERT_GT(model, 0) << state().toStdString();
    EXPECT_TRUE(text().margins().at(model).contains("cycles"));
    EXPECT_TRUE(state().contains("cycles for 64 pixels")) << state().toStdString();
    margin().click();
    ASSERT_TRUE(finish());
    EXPECT_TRUE(text().margins().empty());
}

TEST_F(ShaderPanel, Cancel_LeavesTheMarginEmptyAndTheText) {
    margin().click();
    for (QToolButton* button : dock().findChildren<QToolButton*>()) {
        if (button->text() == "Cancel") {
            button->click();
        }
    }
    ASSERT_TRUE(finish());
    EXPECT_TRUE(text().margins().empty());
    EXPECT_EQ(state(), "Stopped.");
    EXPECT_TRUE(text().toPlainText().contains("vec3 lambert("));
}

} // namespace
} // namespace patina::tests::shader_dock_test
