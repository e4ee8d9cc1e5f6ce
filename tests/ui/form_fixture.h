// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QTest>
#include <gtest/gtest.h>

#include "parameters/document_form.h"
#include "parameters/number_box.h"
#include "parameters/parameter_editor.h"
#include "parameters/parameter_row.h"
#include "parameters/scrub_label.h"
#include "parameters/value_slider.h"
#include "resources/texture_library.h"
#include "ui/fixtures.h"

namespace patina::tests {

/// Shows the form of the current model in a window of its own, ready for real events.
struct Form : testing::Test {
    FixtureDocument fixture;
    Document& document = fixture.document;
    AssetClient client;
    TextureLibrary images{[this]() -> AssetClient& { return client; }};
    QWidget window;
    DocumentForm* form = new DocumentForm(document, images, kinds::models, &window);

    Form() {
        form->setGeometry(0, 0, 420, 600);
        window.resize(420, 600);
        window.show();
        window.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
        QApplication::setActiveWindow(&window); // there is no window manager to do it
    }

    ParameterRow& row(const std::string& id) const { return *form->row(id); }
    ValueSlider* slider(const std::string& id) const { return row(id).findChild<ValueSlider*>(); }
    NumberBox* box(const std::string& id) const { return row(id).findChild<NumberBox*>(); }

    static QPoint at(const QWidget& widget, double share) {
        return {static_cast<int>(share * (widget.width() - 1)), widget.height() / 2};
    }

    /// Presses on the slider, moves in small steps as a hand does, and releases it.
    void drag(ValueSlider* target, double from, double to,
              Qt::KeyboardModifiers modifiers = Qt::NoModifier) const {
        press(target, from, modifiers);
        move(target, from, to, modifiers);
        QTest::mouseRelease(target, Qt::LeftButton, modifiers, at(*target, to));
    }

    void press(ValueSlider* target, double share,
               Qt::KeyboardModifiers modifiers = Qt::NoModifier) const {
        QTest::mousePress(target, Qt::LeftButton, modifiers, at(*target, share));
    }

    void move(ValueSlider* target, double from, double to,
              Qt::KeyboardModifiers modifiers = Qt::NoModifier) const {
        constexpr int moves = 8;
        for (int i = 1; i <= moves; ++i) {
            const QPoint point = at(*target, from + (to - from) * i / moves);
            QMouseEvent event(QEvent::MouseMove, point, target->mapToGlobal(point), Qt::NoButton,
                              Qt::LeftButton, modifiers);
            QApplication::sendEvent(target, &event);
        }
    }

    static void wheel(QWidget* target, int notches) {
        const QPointF centre = QRectF(target->rect()).center();
        QWheelEvent event(centre, target->mapToGlobal(centre), {}, {0, 120 * notches}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(target, &event);
    }

    /// Types into a number box and confirms.
    void type(const std::string& id, const QString& text) const {
        NumberBox* target = box(id);
        target->setFocus();
        target->selectAll();
        QTest::keyClicks(target, text);
        QTest::keyClick(target, Qt::Key_Return);
    }
};

} // namespace patina::tests
