// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include <QObject>
#include <QTimer>

#include "render/lights/environment_lamps.h"
#include "render/renderer.h"
#include "render/surfaces/pixel_probe.h"
#include "viewport/drawing_note.h"
#include "viewport/frame_stopwatch.h"
#include "viewport/idle_release.h"
#include "viewport/ordered_programs.h"
#include "viewport/view_surface.h"
#include "viewport/viewed_scene.h"

class QOpenGLWidget;

namespace patina {

/// Draws what a widget shows, in the context of all views. A frame is drawn only after refresh(),
/// once however often that was called. One that takes long is drawn over several turns of the event
/// loop with the last picture on the screen, or a sketch where the scene is a new one; what changes
/// meanwhile is in the next one. An environment's light is fitted while something changes; when
/// nothing does any more, the sampled one takes its place little by little.
class FrameLoop : public QObject {
    Q_OBJECT

  public:
    /// How long a step of a frame, or of another picture, may keep the window waiting.
    static constexpr std::chrono::milliseconds stepPatience{20};

    /// Both outlive it.
    FrameLoop(QOpenGLWidget& widget, const ViewedScene& viewed);

    // The widget's context is there; it is current in open() and paint().
    void open();
    void close();
    void paint();

    /// Something can be drawn: there is a context, and it offers what a Renderer needs.
    bool canDraw() const { return renderer_ != nullptr; }

    /// Why nothing is drawn; empty when all is well.
    const QString& failure() const { return failure_; }

    /// Something that is drawn has changed.
    void refresh();

    /// Another scene is shown. While its first picture takes several turns a sketch of it is on the
    /// screen, or a note that says so.
    void announceScene();

    /// The blocks have changed.
    void announceCatalog();

    /// Drops the frame that is being drawn.
    void giveUp();

    /// Shows the numerical check in place of the picture.
    void setInspecting(bool on);
    bool isInspecting() const { return inspecting_; }

    /// The numbers of a pixel; nothing where there is no surface.
    std::optional<PixelProbe> probe(glm::ivec2 pixel);

    /// A frame is being drawn that takes several turns, or the renderer is lent.
    bool isDrawing() const { return progress_ != Progress::Idle; }

    /// Tells whether the picture shows what would be drawn now.
    bool isUpToDate() const { return !stale_ && !isDrawing(); }

    /// Returns how the scene is drawn now.
    View view() const;

    /// Samples that the picture has; 0 without an environment.
    int samples() const;

    /// Returns the lamps of the environment that was drawn last.
    EnvironmentLamps environmentLamps() const;

    int frameCount() const { return frameCount_; }

    /// Frames so far that had to wait for programs.
    int waitCount() const { return waitCount_; }

    const FrameReport& report() const;

    /// Finds out how frames are best timed here; see FrameStopwatch::choose().
    void chooseTimer() { stopwatch_.choose(isDrawing()); }
    FrameStopwatch& stopwatch() { return stopwatch_; }

    /// Draws a picture at once where nothing shows, in place of a frame that is being drawn. It is
    /// taken to be of what the frames show: where they are up to date it has their samples, too.
    Image pictureOf(const Scene& scene, View view, bool display);

    /// Lends the renderer for a picture that takes several turns. No frame is drawn until it is
    /// taken back.
    Renderer& lend();

    /// `isAnother`: what was drawn is another picture than the one on the screen.
    void takeBack(bool isAnother);

    /// Draws a scene once where nothing shows, which loads what it needs.
    void drawUnseen(const Scene& scene, const View& view);

  Q_SIGNALS:
    void sketchDrawn(); ///< something of a new scene is to be seen while its frame is drawn
    void frameDrawn();
    void failed(QString why);
    void messagesDrawn(patina::Errors messages); ///< what the last frame has to say
    void interrupted();                          ///< what is drawn with the lent renderer is gone
    void closing();                              ///< the renderer goes, lent or not

  private:
    enum class Progress {
        Idle,
        Waiting, ///< for programs, with the last picture on the screen
        Drawing,
        Drawn,
        Lent ///< until takeBack()
    };

    /// What has become of the picture on the screen.
    enum class Painted {
        Nothing, ///< the last one is there
        Later,   ///< that, until a frame that was begun is done
        Sketch,
        Frame
    };

    Painted paintNext();
    Painted beginFrame(unsigned framebuffer);
    View drawnView() const;
    FrameJob& beginJob(FramePurpose purpose);
    bool waitsForPrograms(FrameJob& job);
    void takePrograms();
    void makeTargets();
    std::optional<Painted> drawSketch(FrameJob& job, unsigned framebuffer);
    Painted drawFrame(FrameJob& job, unsigned framebuffer);
    void goOnWith(Progress progress);
    void proceed();
    void finishSketch();
    void show(unsigned framebuffer);
    double nextShare();
    void finishFrame();
    bool wantsSamples() const;
    void continueSoon();
    void addSamples();
    void releaseTargets();

    QOpenGLWidget& widget_;
    const ViewedScene& viewed_;
    ViewContext& context_;
    ViewSurface surface_;
    bool catalogIsNew_ = false;
    std::unique_ptr<Renderer> renderer_;
    QString failure_;
    Errors messages_; ///< of the last frame
    FrameStopwatch stopwatch_;
    int frameCount_ = 0;
    int waitCount_ = 0;
    Progress progress_ = Progress::Idle; ///< of a frame that takes several turns
    bool sketching_ = false;             ///< that frame is a sketch
    QTimer turn_;                        ///< its next one
    OrderedPrograms programs_;           ///< of the next frame
    std::uint64_t missing_ = 0;          ///< what they were ordered for; 0: nothing
    DrawingNote note_;
    bool stale_ = true; ///< the picture is not of what would be drawn now
    bool isNew_ = true; ///< no frame of this scene has been begun yet
    bool inspecting_ = false;
    QTimer sampleTimer_;       ///< the next frame that adds samples
    bool moreSamples_ = false; ///< that frame is asked for
    // The frame that is drawn, or was drawn last:
    bool isMoving_ = false;    ///< its light is fitted, because something has changed
    bool isAtRest_ = false;    ///< nothing has changed since the last one
    bool isContinued_ = false; ///< it adds samples to those of the last one
    int mixedSamples_ = 0;     ///< so many have taken the fitted picture's place on the screen
    IdleRelease targets_;
};

} // namespace patina
