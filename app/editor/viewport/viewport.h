// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QWidget>

#include "parameters/color_source.h"
#include "viewport/camera_navigation.h"
#include "viewport/frame_loop.h"
#include "viewport/picture_capture.h"
#include "viewport/pixel_prober.h"
#include "viewport/prewarmer.h"
#include "viewport/viewed_scene.h"

namespace patina {

/// Shows a view as a widget: it hands the mouse and the keys to a CameraNavigation and its context
/// to a FrameLoop. After a change of its size it shows the last picture, stretched, until there is
/// one of that size.
class Viewport : public QWidget, public ColorSource {
    Q_OBJECT

  public:
    explicit Viewport(ViewedScene::Sources sources, QWidget* parent = nullptr);
    ~Viewport() override;

    CameraNavigation& navigation() { return navigation_; }
    FrameLoop& frames() { return frames_; }
    const FrameLoop& frames() const { return frames_; }
    Prewarmer& prewarmer() { return prewarmer_; }
    const ViewedScene& viewed() const { return viewed_; }
    PixelProber& prober() { return prober_; }
    PictureCapture& capture() { return capture_; }

    const Camera& camera() const { return viewed_.camera(); }
    void setCamera(const Camera& camera);
    void setCatalog(std::shared_ptr<const Catalog> catalog);

    /// Shows the numerical check in place of the picture, and reads the numbers of the pixel
    /// under the pointer.
    void setInspected(std::optional<Inspected> shown);

    /// Draws what is due and returns the picture, without lines and handles.
    QImage grabPicture();

    Image linearPicture() override { return capture_.linearPicture(); }

  Q_SIGNALS:
    void shown();     ///< a picture has come on the screen
    void activated(); ///< the mouse was pressed in it
    void resized();   ///< its size has changed
    void cameraChanged();
    /// Says that Tab brought the focus here, or that it did not or that the focus left.
    void focusShown(bool byKeyboard);
    void filesDropped(QStringList files, QPointF place);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    CameraNavigation navigation_;
    ViewedScene viewed_;
    FrameLoop frames_;
    Prewarmer prewarmer_;
    PixelProber prober_;
    PictureCapture capture_;
};

} // namespace patina
