// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QTimer>

#include "measure/time/frame_timer.h"
#include "parameters/color_source.h"
#include "render/renderer.h"
#include "render/surfaces/pixel_probe.h"
#include "viewport/camera_navigation.h"

class QLabel;

namespace patina {

class ProgramWorker;
class StretchedPicture;

/// Shows a scene with a Renderer of its own and hands the mouse and the keys to a
/// CameraNavigation. A frame is drawn only after refresh(), once however often that was called.
/// One that takes long is drawn over several turns of the event loop with the last picture on the
/// screen, or a sketch where the scene is a new one; what changes meanwhile is in the next one.
class Viewport : public QOpenGLWidget, public ColorSource {
    Q_OBJECT

  public:
    using SceneSource = std::function<const Scene&()>;

    struct Sources {
        SceneSource scene;      ///< as it is shown
        SceneSource whole;      ///< as it is exported
        MeshSource meshes;
        std::function<const Scene*()> effects; ///< see View::effects
        /// See View::environmentImage.
        std::function<std::shared_ptr<const EnvironmentImage>()> environment;
        std::filesystem::path programCache;
        TextureSource textures{}; ///< the images of materials; without it none are shown
        ProgramWorker* programs = nullptr; ///< makes programs; without it frames wait for them
    };

    explicit Viewport(Sources sources, QWidget* parent = nullptr);
    ~Viewport() override;

    /// What a context must offer; the application's default before the first window is made.
    static QSurfaceFormat surfaceFormat();

    CameraNavigation& navigation() { return navigation_; }
    const Camera& camera() const { return camera_; }
    void setCamera(const Camera& camera);
    void setCatalog(std::shared_ptr<const Catalog> catalog);

    /// Something that is drawn has changed.
    void refresh();

    /// A frame of this scene may be wanted soon: its programs are made when there is nothing else
    /// to do.
    void prewarm(const Scene& ahead);

    /// A frame is being drawn that takes several turns.
    bool isDrawing() const { return progress_ != Progress::Idle; }

    /// Whether the picture shows what would be drawn now.
    bool isUpToDate() const { return !stale_ && !isDrawing(); }

    /// So many samples of an environment's light a view gathers while nothing changes: as many as
    /// the scene says.
    int wantedSamples() const;

    /// Samples that the picture has; 0 without an environment.
    int samples() const;

    /// Another scene is shown. While its first picture takes several turns a sketch of it is on the
    /// screen, or a note that says so.
    void announceScene();

    int frameCount() const { return frameCount_; }

    /// Frames so far that had to wait for programs.
    int waitCount() const { return waitCount_; }

    /// Programs that may be wanted soon are being made.
    bool isPrewarming() const { return !prewarmed_.empty(); }
    const FrameReport& report() const;

    /// The picture before exposure and tone mapping.
    Image linearPicture() override;

    /// The picture as it is shown, divided by 255, or as linear floats with the exposure in them;
    /// empty when none can be drawn.
    Image picture(bool display);

    using PictureTaken = std::function<void(Image)>;

    /// As picture(), over as many turns of the event loop as it takes, with what is shown staying
    /// on the screen; one at a time. What changes meanwhile may or may not be in it.
    void capture(bool display, PictureTaken taken);

    /// Ends that without a picture.
    void cancelCapture();

    /// "1.3 ms (GPU timer)", or how else it was measured. Call it a moment after the frame.
    QString frameTime();

    /// Shows the numerical check in place of the picture, and reads the numbers of the pixel
    /// under the pointer.
    void setInspecting(bool on);

    /// Finds out how frames are best timed here, which takes some milliseconds; a clock on the
    /// wall does until then.
    void chooseTimer();

    /// Why nothing is drawn; empty when all is well.
    const QString& failure() const { return failure_; }

  Q_SIGNALS:
    void sketchDrawn(); ///< something of a new scene is to be seen while its frame is drawn
    void frameDrawn();
    void failed(QString why);
    void messagesDrawn(patina::Errors messages); ///< what the last frame has to say
    void activated(); ///< it was clicked
    /// While inspecting: the numbers under the pointer; nothing where there is no surface.
    void probed(const std::optional<patina::PixelProbe>& numbers);
    void focusShown(bool byKeyboard); ///< the keyboard brought the focus here, or it went
    void filesDropped(QStringList files);

  protected:
    void initializeGL() override;
    void paintGL() override;
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
    enum class Progress {
        Idle,
        Waiting, ///< for programs, with the last picture on the screen
        Drawing,
        Drawn,
        Capturing ///< a picture that is to be kept
    };

    /// A picture that is asked for and not there yet.
    struct Capture {
        bool display = true;
        PictureTaken taken;
        bool isAnother = false; ///< than the one on the screen, to which more may be added
    };

    /// What a ProgramWorker was asked for.
    struct Order {
        quint64 number = 0; ///< 0: nothing, or it came
        std::uint64_t missing = 0;
    };

    void dropRenderer();
    void showNote();
    void showLast();
    glm::ivec2 pixelsOf(const QSize& size) const;
    Image pictureOf(const Scene& scene, View wanted, bool display);
    void probeSoon();
    void probe();
    void makePrewarmed();
    bool waitsForPrograms(FrameJob& job);
    void takePrograms(quint64 number);
    void makeTargets();
    quint64 askFor(const Scene& scene, const View& view);
    void preparePrewarmed();
    void watchForRest();
    void releaseWhenIdle();
    View view() const;
    View viewAhead() const;
    void beginFrame();
    FrameJob& beginJob(FramePurpose purpose);
    bool drawSketch(FrameJob& job);
    void drawFrame(FrameJob& job);
    void goOnWith(Progress progress);
    void proceed();
    void beginCapture();
    void proceedCapture();
    void finishCapture(Image picture);
    void finishSketch();
    void finishFrame();
    void giveUpFrame();
    bool wantsSamples() const;
    void continueSoon();
    void addSamples();

    Sources sources_;
    CameraNavigation navigation_;
    Camera camera_;
    std::shared_ptr<const Catalog> catalog_;
    bool catalogIsNew_ = false;
    std::unique_ptr<Renderer> renderer_;
    Errors messages_; ///< of the last frame
    std::optional<FrameTimer> timer_;
    QString frameTime_; ///< the last one that was known
    QString failure_;
    int frameCount_ = 0;
    int waitCount_ = 0;
    Progress progress_ = Progress::Idle; ///< of a frame that takes several turns
    bool sketching_ = false;             ///< that frame is a sketch
    QTimer turn_;                        ///< its next one
    Order ordered_;                      ///< for the next frame
    std::vector<Scene> prewarmed_;       ///< whose programs are still to be made
    quint64 prewarmedOrder_ = 0;         ///< of the last of them; 0: it was not asked for
    QTimer prewarming_;                  ///< one of them a turn
    QElapsedTimer sinceFrame_;
    QTimer idleTimer_;
    bool stale_ = true; ///< the picture is not of what would be drawn now
    bool resizing_ = false;
    std::unique_ptr<StretchedPicture> last_; ///< while the size changes
    QTimer sampleTimer_;       ///< the next frame that adds samples
    bool moreSamples_ = false; ///< that frame is asked for
    bool isContinued_ = false; ///< the frame that is drawn, or was drawn last, adds samples
    QLabel* note_; ///< that a picture is on its way
    bool isNew_ = true; ///< no frame of this scene has been begun yet
    bool inspecting_ = false;
    std::optional<Capture> capture_;
    std::optional<QPoint> pointer_; ///< where it is, while it is over the view
    QTimer probeTimer_;             ///< its moves are gathered
};

} // namespace patina
