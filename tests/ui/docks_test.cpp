// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>
#include <QKeyEvent>
#include <QWheelEvent>

#include "docks/block_chooser.h"
#include "docks/part_panel.h"
#include "docks/search_box.h"
#include "parameters/document_form.h"
#include "resources/texture_library.h"
#include "ui/fixtures.h"

namespace patina::tests::docks_test {
namespace {

struct Docks : testing::Test {
    FixtureDocument fixture;
};

/// Chooses in the panel as an artist does.
void choose(PartPanel& panel, const char* id) {
    auto* chooser = panel.findChild<BlockChooser*>();
    chooser->setCurrentIndex(chooser->findData(QString(id)));
    Q_EMIT chooser->activated(chooser->currentIndex());
}

/// A kind that no dock knows has a panel of this type, whoever owns it.
TEST_F(Docks, PanelOfAnyKind_ChoosesAPartOfTheSceneOrOfALight) {
    Document& document = fixture.document;
    document.setCatalog(std::make_shared<const Catalog>(loadCatalog(standardBlockRoots())));
    AssetClient client;
    TextureLibrary textures([&client]() -> AssetClient& { return client; });
    for (const auto& [kind, id] : {std::pair{kinds::fog, "linear"}, {kinds::shadows, "filtered"}}) {
        PartPanel panel(document, textures, kind, "Part");
        const BlockPath path = document.selection().currentPath(kind);
        choose(panel, id);
        ASSERT_NE(blockValuesAt(document.state(), path), nullptr) << kind;
        EXPECT_EQ(blockValuesAt(document.state(), path)->id, id);
        const std::string parameter = document.block(path)->parameters.front().id;
        EXPECT_NE(panel.form().row(parameter), nullptr) << kind;
        document.undoStack().undo();
        EXPECT_EQ(blockValuesAt(document.state(), path), nullptr) << kind;
        EXPECT_EQ(panel.findChild<BlockChooser*>()->currentData().toString(), "");
    }
}

TEST_F(Docks, WheelOverAChooserWithoutTheFocus_ChoosesNothing) {
    BlockChooser chooser(fixture.document, "models", BlockChooser::Off::Absent);
    const int before = chooser.currentIndex();
    QWheelEvent down({5, 5}, {5, 5}, {}, {0, -120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                     false);
    QApplication::sendEvent(&chooser, &down);
    EXPECT_EQ(chooser.currentIndex(), before);
    EXPECT_FALSE(down.isAccepted()); // it scrolls the dock
}

/// Whether a field takes the key away from the document.
bool takesUndo(QWidget& field) {
    QKeyEvent undo(QEvent::ShortcutOverride, Qt::Key_Z, Qt::ControlModifier);
    undo.ignore();
    QApplication::sendEvent(&field, &undo);
    return undo.isAccepted();
}

TEST_F(Docks, UndoInTheSearch_IsTheDocumentsWhileNothingStandsInIt) {
    SearchBox search;
    EXPECT_FALSE(takesUndo(search));
    search.setText("gold");
    EXPECT_TRUE(takesUndo(search));
}

} // namespace
} // namespace patina::tests::docks_test
