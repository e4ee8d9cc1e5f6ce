// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/focus_order.h"

#include <algorithm>
#include <set>

#include <QDockWidget>
#include <QTest>

#include "ui/window_fixture.h"

namespace patina::tests::focus_order_test {
namespace {

using FocusOrder = WindowFixture;

/// The panels in the order in which Tab visits them, each once for every visit.
std::vector<const QDockWidget*> panelsOf(const std::vector<QWidget*>& stops) {
    std::vector<const QDockWidget*> panels;
    for (QWidget* stop : stops) {
        const QWidget* parent = stop;
        while (parent && !qobject_cast<const QDockWidget*>(parent)) {
            parent = parent->parentWidget();
        }
        const auto* dock = qobject_cast<const QDockWidget*>(parent);
        if (dock && (panels.empty() || panels.back() != dock)) {
            panels.push_back(dock);
        }
    }
    return panels;
}

TEST_F(FocusOrder, Panels_AreVisitedOnceEach) {
    const auto panels = panelsOf(focusOrder(window()));
    EXPECT_EQ(std::set(panels.begin(), panels.end()).size(), panels.size());
}

TEST_F(FocusOrder, PanelBehindATab_IsLeftOut) {
    window().dock("fresnel")->raise();
    QTest::qWait(100);
    window().dock("parameters")->raise();
    QTest::qWait(100);
    const auto panels = panelsOf(focusOrder(window()));
    EXPECT_EQ(std::count(panels.begin(), panels.end(), window().dock("fresnel")), 0);
    EXPECT_EQ(std::count(panels.begin(), panels.end(), window().dock("parameters")), 1);
}

TEST_F(FocusOrder, AfterAModelSwap_VisitsTheNewRowsWhereTheyAre) {
    const auto before = panelsOf(focusOrder(window()));
    for (const Block* model : document().catalog().ofKind("models")) {
        if (model->id != document().material(Side::A)->model.id) {
            document().setModel(Side::A, model->id);
            break;
        }
    }
    QTest::qWait(100);
    EXPECT_EQ(panelsOf(focusOrder(window())), before);
}

TEST_F(FocusOrder, Tab_ReachesEveryStopAndComesBack) {
    const std::vector<QWidget*> order = focusOrder(window());
    window().activateWindow();
    order.front()->setFocus();
    std::vector<QWidget*> visited;
    for (std::size_t i = 0; i < order.size(); ++i) {
        visited.push_back(window().focusWidget());
        QTest::keyClick(window().focusWidget(), Qt::Key_Tab);
    }
    EXPECT_EQ(visited, order);
    EXPECT_EQ(window().focusWidget(), order.front());
}

TEST_F(FocusOrder, ShiftTab_GoesBack) {
    const std::vector<QWidget*> order = focusOrder(window());
    order.front()->setFocus();
    QTest::keyClick(window().focusWidget(), Qt::Key_Tab, Qt::ShiftModifier);
    EXPECT_EQ(window().focusWidget(), order.back());
}

} // namespace
} // namespace patina::tests::focus_order_test
