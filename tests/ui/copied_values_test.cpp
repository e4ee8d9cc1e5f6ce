// SPDX-License-Identifier: GPL-3.0-or-later
// Values and groups of a form: copied as text and pasted, reset, made random, locked, hidden.
#include <QAbstractButton>
#include <QClipboard>
#include <QGuiApplication>

#include "document/value_locks.h"
#include "material/preset_file.h"
#include "parameters/form_menu.h"
#include "ui/form_fixture.h"

namespace patina::tests::copied_values_test {
namespace {

struct CopiedForm : Form {
    Errors told;

    CopiedForm() {
        QObject::connect(&document, &Document::reported, &window,
                         [this](const Error& error) { told.push_back(error); });
    }

    FormMenu& menu() const { return form->menu(); }
    std::vector<ParameterRow*> surface() const { return form->rowsOf("Surface"); }
    void set(const std::string& id, const Value& value) {
        document.setValue(fixture.model(), id, value);
    }
    static void setText(const QString& text) { QGuiApplication::clipboard()->setText(text); }
    static QString text() { return QGuiApplication::clipboard()->text(); }
    TextureUse lay(const std::string& file) {
        const TextureUse use = textureUse("diffuse.color", file);
        document.setTexture(fixture.model(), "diffuse.color", use);
        return use;
    }
};

TEST_F(CopiedForm, Value_GoesOntoAnotherOfItsType) {
    set("roughness", 0.75);
    menu().copy({&row("roughness")});
    EXPECT_TRUE(text().contains("\"patina.values\""));
    const int steps = fixture.steps();
    menu().paste(row("exponent"));
    EXPECT_EQ(fixture.number("exponent"), 1.0); // as near as its range allows
    EXPECT_EQ(fixture.steps(), steps + 1);
    EXPECT_TRUE(told.empty());
}

TEST_F(CopiedForm, ValueOfAnotherType_ChangesNothingAndIsToldWithItsPlace) {
    menu().copy({&row("diffuse.color")});
    menu().paste(row("roughness"));
    EXPECT_EQ(fixture.steps(), 0);
    ASSERT_EQ(told.size(), 1u);
    EXPECT_EQ(told[0].file, "Clipboard");
    EXPECT_GT(told[0].line, 1);
    EXPECT_EQ(told[0].expected, "a number");
}

TEST_F(CopiedForm, TextThatIsNoJson_IsToldWithLineAndColumn) {
    setText("{\n  \"format\": oops\n}");
    menu().paste(surface());
    ASSERT_EQ(told.size(), 1u);
    EXPECT_EQ(told[0].line, 2);
    EXPECT_GT(told[0].column, 1);
}

TEST_F(CopiedForm, PlainValue_IsPastedFromAnyText) {
    setText(" 0.25 ");
    menu().paste(row("roughness"));
    EXPECT_EQ(fixture.number("roughness"), 0.25);
    setText("#ffffff");
    menu().paste(row("diffuse.color"));
    EXPECT_EQ(fixture.value("diffuse.color"), Value(glm::dvec3(1.0)));
}

TEST_F(CopiedForm, ImageOfAValue_GoesWithItAsOneStep) {
    const TextureUse use = lay("/somewhere/wood.png");
    menu().copy({&row("diffuse.color")});
    document.setTexture(fixture.model(), "diffuse.color", std::nullopt);
    set("diffuse.color", glm::dvec3(0.1));
    const int steps = fixture.steps();
    menu().paste(row("diffuse.color"));
    ASSERT_NE(document.texture(fixture.model(), "diffuse.color"), nullptr);
    EXPECT_EQ(*document.texture(fixture.model(), "diffuse.color"), use);
    EXPECT_EQ(fixture.steps(), steps + 1);
}

TEST_F(CopiedForm, ImageThatATextFromElsewhereNames_IsNotRead) {
    lay("/somewhere/wood.png");
    menu().copy({&row("diffuse.color")});
    const QString copied = text();
    document.setTexture(fixture.model(), "diffuse.color", std::nullopt);
    setText(copied); // the same words, by somebody else
    menu().paste(row("diffuse.color"));
    ASSERT_NE(document.texture(fixture.model(), "diffuse.color"), nullptr);
    EXPECT_TRUE(document.texture(fixture.model(), "diffuse.color")->outside);
}

TEST_F(CopiedForm, Group_IsOneStepAndLeavesLockedValuesAlone) {
    set("roughness", 0.75);
    set("samples", 9);
    menu().copy(surface());
    set("roughness", 0.1);
    set("samples", 2);
    setLocked(document, fixture.model(), {"samples"}, true);
    const int steps = fixture.steps();
    menu().paste(surface());
    EXPECT_EQ(fixture.number("roughness"), 0.75);
    EXPECT_EQ(fixture.value("samples"), Value(2));
    EXPECT_EQ(fixture.steps(), steps + 1);
    document.undoStack().undo();
    EXPECT_EQ(fixture.value("roughness"), roundedToFloat(Value(0.1)));
}

TEST_F(CopiedForm, ValuesThatTheOtherModelLacks_AreNamed) {
    set("diffuse.color", glm::dvec3(0.25));
    menu().copy(form->rows());
    document.setModel(Side::A, "second");
    set("diffuse.color", glm::dvec3(0.75));
    menu().paste(form->rows());
    EXPECT_EQ(fixture.value("diffuse.color"), Value(glm::dvec3(0.25)));
    ASSERT_EQ(told.size(), 1u);
    EXPECT_NE(told[0].problem.find("roughness"), std::string::npos);
    EXPECT_NE(told[0].problem.find("exponent"), std::string::npos);
}

TEST_F(CopiedForm, GroupOfAnotherKind_IsRefused) {
    setText("{\"format\": \"patina.values\", \"version\": 1, \"kind\": \"fog\","
            " \"parameters\": {\"roughness\": 1}}");
    menu().paste(surface());
    EXPECT_EQ(fixture.steps(), 0);
    ASSERT_EQ(told.size(), 1u);
    EXPECT_EQ(told[0].expected, "values of \"models\"");
}

TEST_F(CopiedForm, ResetOfAGroup_IsOneStepAndLeavesLockedValuesAlone) {
    set("roughness", 0.75);
    set("samples", 9);
    setLocked(document, fixture.model(), {"samples"}, true);
    const int steps = fixture.steps();
    menu().reset(surface());
    EXPECT_EQ(fixture.number("roughness"), 0.5);
    EXPECT_EQ(fixture.value("samples"), Value(9));
    EXPECT_EQ(fixture.steps(), steps + 1);
}

TEST_F(CopiedForm, RandomValues_StayWithinTheSlidersAndAreOneStep) {
    setLocked(document, fixture.model(), {"samples"}, true);
    const int steps = fixture.steps();
    const Value mode = fixture.value("mode");
    for (int i = 0; i < 20; ++i) {
        menu().randomise(form->rows());
        EXPECT_GE(fixture.number("roughness"), 0.0);
        EXPECT_LE(fixture.number("roughness"), 1.0);
        EXPECT_LE(fixture.number("exponent"), 1000.0);
        EXPECT_EQ(fixture.value("samples"), Value(4));
        EXPECT_EQ(fixture.value("mode"), mode);
    }
    EXPECT_EQ(fixture.steps(), steps + 20);
    EXPECT_NE(fixture.number("tilt"), 30.0);
}

TEST_F(CopiedForm, Lock_IsShownUndoneAndKeptInFiles) {
    menu().setLocked({&row("roughness")}, true);
    EXPECT_TRUE(row("roughness").isLocked());
    EXPECT_FALSE(row("exponent").isLocked());
    const nlohmann::json json = toJson(*document.material(Side::A));
    const auto read = materialFromJson({{}, json, {}}, "", document.catalog());
    ASSERT_TRUE(read);
    EXPECT_EQ(read->material, *document.material(Side::A));
    document.undoStack().undo();
    EXPECT_FALSE(row("roughness").isLocked());
    document.undoStack().redo();
    QTest::mouseClick(row("roughness").findChild<QAbstractButton*>("lock"), Qt::LeftButton);
    EXPECT_FALSE(row("roughness").isLocked());
}

TEST_F(CopiedForm, LockedValue_CanBeEditedByItself) {
    menu().setLocked({&row("roughness")}, true);
    type("roughness", "0.25");
    EXPECT_EQ(fixture.number("roughness"), 0.25);
}

TEST_F(CopiedForm, LocksOfLightsObjectsAndTheScene_AreTheirOwn) {
    for (const BlockPath& path :
         {pathOf(kinds::lights), pathOf(settings::object), pathOf(settings::scene)}) {
        setLocked(document, path, {"any"}, true);
        EXPECT_TRUE(isLocked(document.state(), path, "any")) << path.kind;
        EXPECT_FALSE(isLocked(document.state(), path, "another")) << path.kind;
        setLocked(document, path, {"any"}, false);
        EXPECT_FALSE(isLocked(document.state(), path, "any")) << path.kind;
    }
    EXPECT_EQ(document.scene(), fixtureScene(document.catalog()));
}

TEST_F(CopiedForm, ClipboardKeys_CopyAndPasteTheValueWithTheFocus) {
    set("roughness", 0.75);
    slider("roughness")->setFocus();
    QTest::keyClick(slider("roughness"), Qt::Key_C, Qt::ControlModifier);
    set("roughness", 0.25);
    QTest::keyClick(slider("roughness"), Qt::Key_V, Qt::ControlModifier);
    EXPECT_EQ(fixture.number("roughness"), 0.75);
}

TEST_F(CopiedForm, FilterForChangedValues_ShowsTheseAlone) {
    set("roughness", 0.75);
    form->setFilter(RowFilter::Changed);
    EXPECT_TRUE(row("roughness").isVisible());
    EXPECT_FALSE(row("exponent").isVisible());
    set("exponent", 9.0);
    EXPECT_TRUE(row("exponent").isVisible());
    set("exponent", 32.0);
    EXPECT_FALSE(row("exponent").isVisible());
    form->setFilter(RowFilter::All);
    EXPECT_TRUE(row("exponent").isVisible());
}

TEST_F(CopiedForm, FilterForChangedValues_KeepsTheRowThatHasTheFocus) {
    set("roughness", 0.75);
    form->setFilter(RowFilter::Changed);
    slider("roughness")->setFocus();
    set("roughness", 0.5);
    EXPECT_TRUE(row("roughness").isVisible());
    slider("roughness")->clearFocus();
    EXPECT_FALSE(row("roughness").isVisible());
}

TEST_F(CopiedForm, FilterForValuesInUse_FollowsWhatDecidesIt) {
    form->setFilter(RowFilter::Active);
    EXPECT_FALSE(row("strength").isVisible());
    set("mode", std::string("fancy"));
    EXPECT_TRUE(row("strength").isVisible());
}

} // namespace
} // namespace patina::tests::copied_values_test
