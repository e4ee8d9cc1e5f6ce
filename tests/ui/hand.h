// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>
#include <QWidget>
#include <QWindow>
#include <gtest/gtest.h>

namespace patina::tests {

/// Does what an artist's hand does, and counts it. Events go to the window, which finds what is
/// under the pointer or has the focus: what is covered, or out of sight, is not reached.
class Hand {
  public:
    void click(QWidget& target, QPoint at, Qt::KeyboardModifiers modifiers = {},
               Qt::MouseButton button = Qt::LeftButton) {
        reach(target, at);
        QTest::mouseClick(windowOf(target), button, modifiers, inWindow(target, at));
        ++clicks_;
    }
    void click(QWidget& target, Qt::KeyboardModifiers modifiers = {}) {
        click(target, target.rect().center(), modifiers);
    }
    void doubleClick(QWidget& target, QPoint at) {
        reach(target, at);
        QTest::mouseClick(windowOf(target), Qt::LeftButton, {}, inWindow(target, at));
        QTest::mouseDClick(windowOf(target), Qt::LeftButton, {}, inWindow(target, at));
        clicks_ += 2;
    }

    /// Moves in small steps with the button held.
    void drag(QWidget& target, QPoint from, QPoint to) {
        constexpr int moves = 8;
        reach(target, from);
        QTest::mousePress(windowOf(target), Qt::LeftButton, {}, inWindow(target, from));
        for (int i = 1; i <= moves; ++i) {
            const QPoint at = from + (to - from) * i / moves;
            QTest::mouseMove(windowOf(target), inWindow(target, at));
        }
        QTest::mouseRelease(windowOf(target), Qt::LeftButton, {}, inWindow(target, to));
        ++drags_;
    }

    /// Presses a key for whatever has the focus in the window of `near`.
    void key(QWidget& near, Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(windowOf(near), key, modifiers);
        ++keys_;
    }
    void type(QWidget& near, const QString& text) {
        for (const QChar letter : text) {
            QTest::keyClick(windowOf(near), letter.toLatin1());
            ++keys_;
        }
    }

    /// Clicks through menus; names are parts of the items' texts.
    void choose(QMenuBar& bar, const QStringList& names) {
        QAction* action = itemOf(bar.actions(), names.front());
        ASSERT_NE(action, nullptr) << names.front().toStdString();
        click(bar, bar.actionGeometry(action).center());
        choose(*action->menu(), names.mid(1));
    }
    void choose(QMenu& menu, const QStringList& names) {
        QAction* action = itemOf(menu.actions(), names.front());
        ASSERT_NE(action, nullptr) << names.front().toStdString();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&menu));
        click(menu, menu.actionGeometry(action).center());
        if (names.size() > 1) {
            choose(*action->menu(), names.mid(1));
        }
    }

    void turnWheel(QWidget& over, int notches) {
        const QPointF centre = QRectF(over.rect()).center();
        QWheelEvent event(centre, over.mapToGlobal(centre), {}, {0, 120 * notches}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&over, &event);
        ++wheels_;
    }

    /// Does the same in the menu that opens next, which blocks its caller.
    void chooseInNextPopup(const QStringList& names) {
        auto* timer = new QTimer(qApp);
        QObject::connect(timer, &QTimer::timeout, [this, timer, names] {
            if (auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget())) {
                timer->deleteLater();
                choose(*menu, names);
            }
        });
        timer->start(20);
    }

    int clicks() const { return clicks_; }
    int drags() const { return drags_; }
    int keys() const { return keys_; }
    int wheels() const { return wheels_; }

  private:
    static QWindow* windowOf(const QWidget& target) { return target.window()->windowHandle(); }
    static QPoint inWindow(const QWidget& target, QPoint at) {
        return target.mapTo(target.window(), at);
    }
    static QAction* itemOf(const QList<QAction*>& actions, const QString& name) {
        for (QAction* action : actions) {
            if (action->isVisible() && QString(action->text()).remove('&').contains(name)) {
                return action;
            }
        }
        return nullptr;
    }

    /// Turns the wheel over the scroll areas around a place until it is in sight.
    void reach(QWidget& target, QPoint at) {
        constexpr int maxNotches = 200;
        for (QWidget* around = &target; !around->isWindow();) {
            around = around->parentWidget();
            auto* area = qobject_cast<QScrollArea*>(around);
            for (int i = 0; area && i < maxNotches; ++i) {
                const int y = target.mapTo(area->viewport(), at).y();
                if (y >= 0 && y < area->viewport()->height()) {
                    break;
                }
                turnWheel(*area->viewport(), y < 0 ? 1 : -1);
            }
        }
    }
    int clicks_ = 0;
    int drags_ = 0;
    int keys_ = 0;
    int wheels_ = 0;
};

} // namespace patina::tests
