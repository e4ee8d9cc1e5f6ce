// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include <QImage>
#include <QObject>

#include "render/gpu/stretched_picture.h"
#include "viewport/view_context.h"

class QPainter;
class QWidget;
class QWindow;

namespace patina {

/// Draws what lies over the picture of a view.
class OverlaySource {
  public:
    virtual ~OverlaySource() = default;

    virtual bool isSeen() const = 0;

    /// Draws in the coordinates of the view's widget.
    virtual void draw(QPainter& painter) = 0;
};

/// Holds the picture of a view, in the context that all views share, and puts it on the screen with
/// what is laid over it. The widget of a view has a window of OpenGL inside for that, through which
/// the mouse reaches the widget: a QOpenGLWidget would copy the whole editor's window for each
/// frame of a view.
class ViewSurface : public QObject {
    Q_OBJECT

  public:
    /// Both references outlive it.
    ViewSurface(QWidget& widget, ViewContext& context);

    /// Opens the view and returns what draws it. Fails as ViewContext::open() does.
    Result<std::unique_ptr<Renderer>> open();
    void close(std::unique_ptr<Renderer> renderer);

    /// Asks for paintDue() once, after the events that wait now.
    void requestPaint();

    /// Returns the OpenGL name of the framebuffer that has the picture, which has the widget's
    /// size; a picture of another size is stretched to it. The views' context has to be current.
    unsigned framebuffer();

    /// Returns the same for a picture of `size` pixels, which show() stretches to the widget.
    unsigned framebuffer(glm::ivec2 size);

    /// Tells whether there is a picture, and whether it has another size than the widget.
    bool hasPicture() const { return hasPicture_; }
    bool isOutgrown() const;

    /// Says that a picture was drawn into the framebuffer, which show() puts on the screen.
    void notePicture();

    /// Sets what is drawn over the picture, which outlives it; noteOverlay() says that it has
    /// changed.
    void setOverlay(OverlaySource& source);
    void noteOverlay();

    /// Draws a child of the widget over the picture, which would hide it otherwise.
    void addToOverlay(QWidget& child);

    /// Puts the picture on the screen, unless it is there or nothing of the view is to be seen.
    void show(Renderer& renderer);

    /// Hides the picture under something that is drawn in its place, or shows it again.
    void setCovered(bool isCovered);

    /// Reads the picture back, without what is laid over it; null before there is one.
    QImage picture();

  Q_SIGNALS:
    void paintDue();
    void shown(); ///< the picture has come on the screen

  protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void resize();
    void fit() { fit(size()); }
    void fit(glm::ivec2 size);
    glm::ivec2 size() const;
    void drawOverlay();

    QWidget& widget_;
    ViewContext& context_;
    QWindow* window_;                           ///< belongs to the container
    QWidget* container_;                        ///< belongs to the widget
    Renderer* renderer_ = nullptr;              ///< is what open() returned, until close()
    std::unique_ptr<StretchedPicture> picture_; ///< is null before the first frame
    OverlayPicture overlay_;
    OverlaySource* overlaySource_ = nullptr;
    std::vector<QWidget*> children_; ///< are those that lie over the picture
    QImage overlayImage_;            ///< is drawn into again
    bool isAsked_ = false;           ///< paintDue() will come
    bool hasPicture_ = false;        ///< something was drawn into `picture_`
    bool isChanged_ = false;         ///< it is not what the screen shows
    bool isOverlayNew_ = false;      ///< what is laid over it has to be drawn
    bool isDrawingOverlay_ = false;
    bool isCovered_ = false;
};

} // namespace patina
