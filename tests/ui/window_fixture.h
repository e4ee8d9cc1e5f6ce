// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <gtest/gtest.h>

#include "catalog/catalog.h"
#include "support/program.h"
#include "window/main_window.h"

namespace patina::tests {

/// Returns a shipped scene without environment, ground and shadows, so that a frame takes little.
inline std::filesystem::path threeLightsFile() {
    return dataFolder() / "presets/three-lights.patina-scene.json";
}

/// The editor's window on the shipped blocks, with folders of its own for everything it keeps. A
/// view of the size that a first start gives it takes a software driver long to fill; most tests
/// are as well served by a small one.
class WindowFixture : public testing::Test {
  protected:
    enum class Size { Small, AsAtFirstStart };

    explicit WindowFixture(Size size = Size::Small);
    ~WindowFixture() override;

    void open();  ///< shows a window and waits for its first frame
    void close(); ///< takes it away without asking

    MainWindow& window() { return *window_; }
    Document& document() { return window_->document(); }
    Viewport& view() { return window_->views().first().viewport(); }
    Viewport& secondView() { return window_->views().second()->viewport(); }
    const Camera& camera() { return view().camera(); }

    /// Frames drawn by the first view since the last call, after what was going on has settled.
    int newFrames();

    /// Lets every panel follow what changed: their timers are shorter than this one, so they have
    /// fired however long a frame in between took.
    void settle();

    /// Gives the first view the keys, those of the menus too, which need an active window.
    void focusView();

    /// A left, middle or right drag over the middle of the first view.
    void drag(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, QPoint by);

    std::filesystem::path home(const std::string& name) const { return home_ / name; }

  private:
    TemporaryFolder home_;
    Size size_;
    std::unique_ptr<Theme> theme_;
    std::unique_ptr<MainWindow> window_;
    int framesBefore_ = 0;
};

/// What a view shows, for an export.
PictureExport::Source pictureOf(Viewport& view);

/// A preset of some other model than the one on screen.
std::filesystem::path otherPreset(const Document& document);

} // namespace patina::tests
