// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <gtest/gtest.h>

#include "catalog/catalog.h"
#include "support/program.h"
#include "window/main_window.h"

namespace patina::tests {

/// Returns the file of a shipped scene without environment, ground and shadows, so that a frame
/// takes little time.
inline std::filesystem::path threeLightsFile() {
    return dataFolder() / "presets/three-lights.patina-scene.json";
}

/// Shows the editor's window on the shipped blocks, with folders of its own for everything it
/// keeps. A software driver needs long to fill a view of the size at a first start; for most tests
/// a small one does as well.
class WindowFixture : public testing::Test {
  protected:
    enum class Size { Small, AsAtFirstStart };

    explicit WindowFixture(Size size = Size::Small);
    ~WindowFixture() override;

    void open();  ///< shows a window and waits for its first frame
    void close(); ///< closes it without asking

    MainWindow& window() { return *window_; }
    Document& document() { return window_->document(); }
    Viewport& view() { return window_->views().first().viewport(); }
    Viewport& secondView() { return window_->views().second()->viewport(); }
    const Camera& camera() { return view().camera(); }

    /// Returns how many frames the first view drew since the last call, after pending work has
    /// settled.
    int newFrames();

    /// Waits until every panel has followed what changed: their timers are shorter than this one,
    /// so they have fired however long a frame in between took.
    void settle();

    /// Gives the first view the keyboard focus; menus' shortcuts need an active window, too.
    void focusView();

    /// Drags with the left, middle or right button over the middle of the first view.
    void drag(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, QPoint by);

    std::filesystem::path home(const std::string& name) const { return home_ / name; }

  private:
    TemporaryFolder home_;
    Size size_;
    std::unique_ptr<Theme> theme_;
    std::unique_ptr<MainWindow> window_;
    int framesBefore_ = 0;
};

/// Returns what a view shows, for an export.
PictureExport::Source pictureOf(Viewport& view);

/// Returns a preset of another model than the one on screen.
std::filesystem::path otherPreset(const Document& document);

} // namespace patina::tests
