// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include <QObject>
#include <QTimer>

#include "viewport/frame_loop.h"

namespace patina {

/// Takes pictures of what a view shows, which are to be kept: at once, or over several turns of the
/// event loop in place of frames.
class PictureCapture : public QObject {
    Q_OBJECT

  public:
    using Taken = std::function<void(Image)>;

    /// Both outlive it.
    PictureCapture(FrameLoop& frames, const ViewedScene& viewed);

    /// Returns the picture before exposure and tone mapping.
    Image linearPicture();

    /// The picture as it is shown, divided by 255, or as linear floats with the exposure in them;
    /// empty when none can be drawn.
    Image picture(bool display);

    /// As picture(), over as many turns of the event loop as it takes, with what is shown staying
    /// on the screen; one at a time. What changes meanwhile may or may not be in it.
    void start(bool display, Taken taken);

    /// Ends that without a picture.
    void cancel();

  private:
    /// A picture that is asked for and not there yet.
    struct Order {
        bool display = true;
        Taken taken;
        bool isAnother = false; ///< than the one on the screen, to which more may be added
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
    Renderer* lent_ = nullptr; ///< while the order is being drawn
    bool isBegun_ = false;     ///< its picture, which its next turn goes on with
    QTimer turn_;
};

} // namespace patina
