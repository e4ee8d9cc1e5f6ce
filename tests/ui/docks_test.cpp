// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QApplication>
#include <QKeyEvent>
#include <QWheelEvent>

#include "docks/block_chooser.h"
#include "docks/search_box.h"
#include "ui/fixtures.h"

namespace patina::tests::docks_test {
namespace {

struct Docks : testing::Test {
    FixtureDocument fixture;
};

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
