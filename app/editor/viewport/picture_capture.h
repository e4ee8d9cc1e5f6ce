// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include <QObject>
#include <QTimer>

#include "viewport/frame_loop.h"

namespace patina {

/// Takes pictures of what a view shows, for export: at once, or over several turns of the event
/// loop in place of frames.
class PictureCapture : public QObject {
    Q_OBJECT

  public:
    using Taken = std::function<void(Image)>;
    /// Returns what is drawn in place of the view's scene.
    using SceneChange = std::function<Scene(const Scene&)>;

    /// Both references outlive it.
    PictureCapture(FrameLoop& frames, const ViewedScene& viewed);

    /// Returns the picture in linear light before exposure and tone mapping; empty when none can be
    /// drawn.
    Image linearPicture();

    /// Returns the picture as it is shown, divided by 255, or as linear floats after exposure;
    /// empty when none can be drawn.
    Image picture(bool display);

    /// Takes picture() over as many turns of the event loop as it takes, while the last frame stays
    /// on the screen. A second call ends the first without a picture. What changes meanwhile may or
    /// may not be in it. With a `change` another scene is drawn.
    void start(bool display, Taken taken, SceneChange change = {});

    /// Ends a picture that was started; `taken` gets an empty one.
    void cancel();

  private:
    /// Describes a picture that was asked for and is not there yet.
    struct Order {
        bool display = true;
        Taken taken;
        /// The picture is not the one on the screen, to which more samples may be added.
        bool isAnother = false;
        SceneChange change{};
        Scene changed{}; ///< is what `change` made of the scene
    };

    void begin();
    void beginAnew();
    void proceed();
    std::optional<Image> proceeded();
    void finish(Image picture);
    Order end();

    FrameLoop& frames_;
    const ViewedScene& viewed_;
    std::optional<Order> order_;
    Renderer* lent_ = nullptr; ///< is null unless the order is being drawn
    bool isBegun_ = false; ///< the order's picture has been begun, and its next turn continues it
    QTimer turn_;
};

} // namespace patina
