// SPDX-License-Identifier: GPL-3.0-or-later
// Cheaper ways that the Accuracy dock finds for the current material.
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QPlainTextEdit>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include "accuracy/accuracy_dock.h"
#include "accuracy/cheaper_page.h"
#include "session/message_log.h"
#include "ui/window_fixture.h"

namespace patina::tests::cheaper_ways_test {
namespace {

constexpr int waitMs = 120000;
constexpr double firstSeconds = 15.0;

/// A model of the user's with a bound that nothing needs, a power and a root.
constexpr const char* plushDescriptor = R"({
  "id": "plush", "version": 1, "label": "Plush", "summary": "For tests.",
  "applications": "Tests.", "source": "None", "parameters": [
    {"id": "diffuse.color", "label": "Diffuse", "doc": "Its colour.", "type": "color",
     "default": [0.5, 0.4, 0.3]}],
  "claims": ["finite", "non_negative"], "exemptions": {
    "reciprocal": "For tests.", "energy_conserving": "For tests.", "isotropic": "For tests.",
    "zero_below_horizon": "For tests."}
})";
constexpr const char* plushShader = R"(// SPDX-License-" "Identifier: MIT-0
#include "lib/directions.glsl"

vec3 plush(Directions d, Plush p) {
    float rim = pow(max(1.0 - d.nv, 0.0), 5.0) + 0.001 * sqrt(max(d.nl, 0.0));
    return p.diffuseColor * (d.nl + rim * d.nl);
}
)";

class CheaperPanel : public WindowFixture {
  protected:
    CheaperPanel() {
        writeFile(folder() / "plush.json", plushDescriptor);
        writeFile(folder() / "plush.glsl", plushShader);
        document().setCatalog(std::make_shared<const Catalog>(loadCatalog(standardBlockRoots())));
        document().setModel(Side::A, "plush");
        window().dock("accuracy")->show();
        pages().setCurrentWidget(&page());
        settle();
    }

    std::filesystem::path folder() const { return home("XDG_DATA_HOME") / "patina/shaders/models"; }
    AccuracyDock& pages() { return *window().dock("accuracy")->findChild<AccuracyDock*>(); }
    CheaperPage& page() { return *pages().findChild<CheaperPage*>(); }
    QTreeWidget& list() { return *page().findChild<QTreeWidget*>(); }

    QToolButton* button(const QString& text) {
        const auto all = page().findChildren<QToolButton*>();
        const auto found = std::ranges::find(all, text, &QToolButton::text);
        return found == all.end() ? nullptr : *found;
    }

    void start() {
        CheaperSearchOptions options;
        options.seconds = 120.0;
        options.cases = 128;
        options.heldOut = 1000;
        page().search(options);
    }

    bool waitForEnd() {
        return QTest::qWaitFor([this] { return !page().isMeasuring(); }, waitMs);
    }

    /// Returns the height that the words of a row take in the width of their column, in pixels.
    int wordsHeight(const QTreeWidgetItem& row) {
        const QRect column(0, 0, list().columnWidth(0), 1000);
        return list().fontMetrics().boundingRect(column, Qt::TextWordWrap, row.text(0)).height();
    }

    /// Searches until there is something, which is checked then.
    bool search() {
        start();
        const bool hasFound =
            QTest::qWaitFor([this] { return list().topLevelItemCount() > 0; }, waitMs);
        button("Stop")->click();
        return hasFound && waitForEnd() && page().found().isChecked &&
               list().topLevelItemCount() > 0;
    }
};

TEST_F(CheaperPanel, Found_AreListedShownCopiedAndSavedAsABlockOfTheirOwn) {
    ASSERT_TRUE(search()) << page().state().toStdString();
    const CheaperWay& cheapest = page().found().ways.ways.back();
    EXPECT_LT(cheapest.cost, page().found().ways.exact.cost);
    EXPECT_LE(cheapest.error, 0.25);
    const auto texts = page().findChildren<QPlainTextEdit*>();
    const auto glsl = std::ranges::find(texts, QStringLiteral("GLSL of the found ways"),
                                        &QPlainTextEdit::accessibleName);
    ASSERT_NE(glsl, texts.end());
    EXPECT_TRUE((*glsl)->toPlainText().contains("Found1("));
    button("Copy")->click();
    EXPECT_EQ(QApplication::clipboard()->text(), (*glsl)->toPlainText());
    QTreeWidgetItem& row = *list().topLevelItem(list().topLevelItemCount() - 1);
    EXPECT_GT(wordsHeight(row), list().fontMetrics().height()) << "one line would not wrap";
    EXPECT_GE(list().visualItemRect(&row).height(), wordsHeight(row)) << row.text(0).toStdString();

    button("Save as my block")->click();
    EXPECT_EQ(readFile(folder() / "plush.glsl"), plushShader);
    EXPECT_EQ(readFile(folder() / "plush.json"), plushDescriptor);
    EXPECT_TRUE(std::filesystem::exists(folder() / "plush-cheaper.glsl"));
    EXPECT_TRUE(std::filesystem::exists(folder() / "plush-cheaper.json"));
    EXPECT_TRUE(page().state().contains("plush-cheaper")) << page().state().toStdString();
    EXPECT_FALSE(button("Save as my block")->isEnabled());
}

TEST_F(CheaperPanel, UseIt_GivesTheMaterialTheSelectedWayInOneStep) {
    writeFile(folder() / "plush-cheaper.json", "{}"); // another file of the artist's
    ASSERT_TRUE(search()) << page().state().toStdString();
    const int steps = document().undoStack().count();
    const Material before = *document().material(Side::A);
    list().setCurrentItem(list().topLevelItem(list().topLevelItemCount() - 1));
    button("Use it")->click();
    document().setCatalog(std::make_shared<const Catalog>(loadCatalog(standardBlockRoots())));
    ASSERT_TRUE(QTest::qWaitFor(
        [this] { return document().material(Side::A)->model.id == "plush-cheaper-2"; }, waitMs));
    EXPECT_EQ(readFile(folder() / "plush-cheaper.json"), "{}");
    EXPECT_EQ(document().undoStack().count(), steps + 1);
    const std::string level = "found-" + std::to_string(list().topLevelItemCount());
    EXPECT_EQ(document().material(Side::A)->accuracy.at("cheaper.plush"), level);
    EXPECT_EQ(document().material(Side::A)->model.parameters, before.model.parameters);
    EXPECT_TRUE(QTest::qWaitFor(
        [this] { return page().state().contains("has found ways already"); }, waitMs));
    page().search();
    EXPECT_FALSE(page().isMeasuring()) << "what it has found is not searched again";
    document().undoStack().undo();
    EXPECT_EQ(*document().material(Side::A), before);
}

TEST_F(CheaperPanel, Button_ShowsTheFirstWaysSoonAndStopKeepsThemChecked) {
    pages().setCurrentIndex(0);
    QElapsedTimer time;
    time.start();
    pages().findChild<QToolButton*>("find")->click();
    ASSERT_EQ(pages().currentWidget(), &page());
    ASSERT_TRUE(page().isMeasuring());
    ASSERT_TRUE(QTest::qWaitFor([this] { return list().topLevelItemCount() > 0; }, waitMs));
    EXPECT_LT(double(time.elapsed()) / 1000.0, firstSeconds);
    EXPECT_FALSE(button("Save as my block")->isEnabled()) << "they are not checked yet";
    button("Stop")->click();
    ASSERT_TRUE(waitForEnd());
    EXPECT_TRUE(page().state().startsWith("Stopped")) << page().state().toStdString();
    EXPECT_TRUE(page().found().isChecked);
    EXPECT_GT(list().topLevelItemCount(), 0);
    EXPECT_TRUE(button("Save as my block")->isEnabled());
}

TEST_F(CheaperPanel, ShaderThatChangedSince_IsNotSaved) {
    ASSERT_TRUE(search()) << page().state().toStdString();
    writeFile(folder() / "plush.glsl", std::string(plushShader) + "\n// changed\n");
    page().save();
    EXPECT_FALSE(std::filesystem::exists(folder() / "plush-cheaper.glsl"));
    EXPECT_FALSE(std::filesystem::exists(folder() / "plush-cheaper.json"));
}

} // namespace
} // namespace patina::tests::cheaper_ways_test
