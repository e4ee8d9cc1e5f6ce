// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include <QObject>
#include <QTimer>

#include "render/lights/environment_lamps.h"
#include "render/renderer.h"
#include "render/surfaces/inspected_view.h"
#include "render/surfaces/pixel_probe.h"
#include "viewport/drawing_note.h"
#include "viewport/frame_stopwatch.h"
#include "viewport/idle_release.h"
#include "viewport/ordered_programs.h"
#include "viewport/sample_refinement.h"
#include "viewport/view_surface.h"
#include "viewport/viewed_scene.h"

class QWidget;

namespace patina {

/// Draws what a widget shows, in the context of all views. A frame is drawn only after refresh(),
/// once however often that was called. One that takes long is drawn over several turns of the event
/// loop with the last picture on the screen, or a sketch where the scene is a new one; what changes
/// meanwhile is in the next one. An environment's light is fitted while something changes; when
/// nothing does any more, the sampled one takes its place little by little.
class FrameLoop : public QObject {
    Q_OBJECT

  public:
    /// Limits how long a step of a frame, or of another picture, may keep the window waiting.
    static constexpr std::chrono::milliseconds stepPatience{20};

    /// Both outlive it.
    FrameLoop(QWidget& widget, const ViewedScene& viewed);

    /// Draws what is due at once, as it is done by itself whenever the event loop turns and the
    /// widget is visible.
    void paint();

    /// Gives back all that is on the device; nothing is drawn any more.
    void close();

    /// Returns what shows the picture.
    ViewSurface& surface() { return surface_; }

    /// Tells whether something can be drawn: there is a context that offers what a Renderer needs.
    bool canDraw() const { return renderer_ != nullptr; }

    /// Says why nothing is drawn; empty when all is well.
    const QString& failure() const { return failure_; }

    /// Asks for a frame, since something that is drawn has changed.
    void refresh();

    /// Asks for the last frame with other passes over its picture, for which the scene is not drawn
    /// again where that picture is still there.
    void restyle();

    /// Asks for a frame of another scene. While its first picture takes several turns a sketch of
    /// it is on the screen, or a note that says so.
    void announceScene();

    /// Asks for a frame of another size, for which the one that is being drawn is dropped, unless
    /// it is the sketch that will be the first picture of all. Where frames take long a sketch
    /// shows the scene in that size first, and until then the last picture is stretched.
    void announceSize();

    /// Asks for a frame with other blocks.
    void announceCatalog();

    /// Drops the frame that is being drawn.
    void giveUp();

    /// Shows the numerical check or another thing in place of the picture; nothing: the picture.
    void setInspected(std::optional<Inspected> shown);
    bool isInspecting() const { return inspected_.has_value(); }

    /// Returns the numbers of a pixel; nothing where there is no surface.
    std::optional<PixelProbe> probe(glm::ivec2 pixel);

    /// Tells whether a frame is being drawn that takes several turns, or the renderer is lent.
    bool isDrawing() const { return progress_ != Progress::Idle; }

    /// Tells whether the picture shows what would be drawn now.
    bool isUpToDate() const { return !stale_ && !restyles_ && !isDrawing(); }

    /// Returns how the scene is drawn now.
    View view() const;

    /// Returns how many samples the picture has; 0 without an environment.
    int samples() const;

    /// Returns the lamps of the environment that was drawn last.
    EnvironmentLamps environmentLamps() const;

    int frameCount() const { return frameCount_; }

    /// Counts the pictures so far that differ from the last frame in the passes over it alone.
    int restyledCount() const { return restyledCount_; }

    /// Counts the frames so far that had to wait for programs.
    int waitCount() const { return waitCount_; }

    const FrameReport& report() const;

    /// Finds out how frames are best timed here; see FrameStopwatch::choose().
    void chooseTimer() { stopwatch_.choose(isDrawing()); }
    FrameStopwatch& stopwatch() { return stopwatch_; }

    /// Draws a picture at once where nothing shows, in place of a frame that is being drawn. It is
    /// taken to be of what the frames show: where they are up to date it has their samples, too.
    Image pictureOf(const Scene& scene, View view, bool display);

    /// Returns the picture on the screen, for which nothing is drawn; see FrameJob::read(). Empty
    /// while it is not of what would be drawn now, and where another thing is shown in its place.
    Image shownPicture(bool display, std::optional<double> exposure = {});

    /// Lends the renderer for a picture that takes several turns. No frame is drawn until it is
    /// taken back.
    Renderer& lend();

    /// Takes the renderer back. `isAnother`: it drew another picture than the one on the screen.
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

    /// Tells what has become of the picture on the screen.
    enum class Painted {
        Nothing, ///< the last one is there
        Later,   ///< that, until a frame that was begun is done
        Sketch,
        Frame,
        Restyled ///< the last frame with other passes over it
    };

    void open();
    Painted paintNext();
    bool takePasses();
    Painted beginFrame(unsigned framebuffer);
    FrameJob& beginJob(FramePurpose purpose);
    bool waitsForPrograms(FrameJob& job);
    void takePrograms();
    void giveUpPrograms();
    void makeTargets();
    void endWaiting();
    std::optional<Painted> drawSketch(FrameJob& job, unsigned framebuffer);
    Painted drawFrame(FrameJob& job, unsigned framebuffer);
    void goOn();
    void proceed();
    void finishSketch();
    void show(unsigned framebuffer);
    void finishFrame();
    bool wantsSamples() const;
    void continueSoon();
    void addSamples();
    void releaseTargets();

    const ViewedScene& viewed_;
    ViewContext& context_;
    ViewSurface surface_;
    bool catalogIsNew_ = false;
    std::unique_ptr<Renderer>
        renderer_; ///< is null before the first paint(), and where that failed
    bool isClosed_ = false;
    QString failure_;
    Errors messages_; ///< are those of the last frame
    FrameStopwatch stopwatch_;
    int frameCount_ = 0;
    int waitCount_ = 0;
    Progress progress_ = Progress::Idle; ///< is that of a frame that takes several turns
    bool sketching_ = false;             ///< that frame is a sketch
    QTimer preparing_;                   ///< begins what is done while it waits for programs
    FrameTurns::Place turn_;             ///< draws its next turn
    OrderedPrograms programs_;           ///< are those of the next frame
    DrawingNote note_;
    bool stale_ = true;                  ///< the picture is not of what would be drawn now
    bool isNew_ = true;                  ///< no frame of this scene has been begun yet
    bool areFramesLong_ = true;          ///< the last one was, or there is none yet
    bool sketchesFirst_ = true;          ///< the next frame comes after a sketch
    std::optional<Inspected> inspected_; ///< nothing: the picture is shown
    SampleRefinement refinement_;
    bool moreSamples_ = false; ///< a frame that adds samples is asked for
    bool restyles_ = false;    ///< the last frame with other passes is asked for
    bool holdsFrame_ = false;  ///< the renderer's picture is that of the last frame
    int restyledCount_ = 0;
    IdleRelease targets_;
};

} // namespace patina
