// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <QTest>

#include "docks/notice_bar.h"
#include "docks/preset_view.h"
#include "docks/search_box.h"
#include "ui/window_fixture.h"

namespace patina::tests {

/// Shows the window with its presets read, and does to them what a user does.
class PresetWindow : public WindowFixture {
  protected:
    explicit PresetWindow(Size size = Size::Small) : WindowFixture(size) {}

    void SetUp() override {
        window().activateWindow();
        QApplication::setActiveWindow(&window()); // there is no window manager to do it
        window().startRest();
        ASSERT_TRUE(QTest::qWaitFor([this] { return count() > 100; }, 20000));
    }

    QDockWidget& dock() { return *window().dock("presets"); }
    PresetView& view() { return *dock().findChild<PresetView*>(); }
    SearchBox& search() { return *dock().findChild<SearchBox*>(); }
    NoticeBar& notice() { return *dock().findChild<NoticeBar*>(); }
    int count() { return view().model()->rowCount(); }
    QString shown(int row) { return view().model()->index(row, 0).data().toString(); }

    /// Scrolls to a row and returns a point in it.
    QPoint placeOf(int row) {
        view().scrollTo(view().model()->index(row, 0));
        return view().visualRect(view().model()->index(row, 0)).topLeft() + QPoint(30, 20);
    }
    void click(int row, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mouseClick(view().viewport(), Qt::LeftButton, modifiers, placeOf(row));
    }

    /// Returns the material that the first view draws.
    const Material& seen() {
        const Scene& scene = WindowFixture::view().viewed().sources().scene();
        return scene.objects.front().material;
    }
    QString nameOnA() { return QString::fromStdString(document().material(Side::A)->name); }
    int edits() { return document().undoStack().count(); }

    std::filesystem::path presets() const { return home("XDG_DATA_HOME") / "patina/presets"; }
};

} // namespace patina::tests
