// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/viewport.h"

#include <utility>

#include <QApplication>
#include <QDragEnterEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QTimer>
#include <QUrl>

#include "render/frame/frame_job.h"
#include "render/gpu/stretched_picture.h"
#include "viewport/program_worker.h"

namespace patina {

Viewport::Viewport(Sources sources, QWidget* parent)
    : QOpenGLWidget(parent), sources_(std::move(sources)),
      note_(new QLabel(tr("Drawing the scene …"), this)) {
    note_->setContentsMargins(12, 6, 12, 6);
    note_->setAutoFillBackground(true);
    note_->hide();
    setFormat(surfaceFormat());
    setFocusPolicy(Qt::StrongFocus);
    setAcceptDrops(true);
    setMinimumSize(160, 120);
    setUpdateBehavior(PartialUpdate); // the last picture stays until there is another one
    turn_.setSingleShot(true);
    connect(&turn_, &QTimer::timeout, this, &Viewport::proceed);
    prewarming_.setSingleShot(true);
    connect(&prewarming_, &QTimer::timeout, this, &Viewport::makePrewarmed);
    if (sources_.programs) {
        connect(sources_.programs, &ProgramWorker::finished, this, &Viewport::takePrograms);
    }
    probeTimer_.setSingleShot(true);
    connect(&probeTimer_, &QTimer::timeout, this, &Viewport::probe);
    sampleTimer_.setSingleShot(true);
    connect(&sampleTimer_, &QTimer::timeout, this, &Viewport::addSamples);
    idleTimer_.setSingleShot(true);
    connect(&idleTimer_, &QTimer::timeout, this, &Viewport::releaseWhenIdle);
}

Viewport::~Viewport() {
    dropRenderer();
    if (context()) {
        disconnect(context(), nullptr, this, nullptr); // it goes with the base class
    }
}

QSurfaceFormat Viewport::surfaceFormat() {
    QSurfaceFormat format;
    format.setVersion(4, 1);
    format.setProfile(QSurfaceFormat::CoreProfile);
    // The renderer has buffers of its own; the widget's only takes the finished picture.
    format.setDepthBufferSize(0);
    format.setStencilBufferSize(0);
    return format;
}

void Viewport::refresh() {
    const Scene& drawn = capture_ ? sources_.whole() : sources_.scene();
    if (isDrawing() && (isContinued_ || !renderer_->job().hasMeshesOf(drawn))) {
        giveUpFrame(); // it only adds to a picture that is gone, or objects have come or gone
    }
    stale_ = true;
    update();
}

void Viewport::announceScene() {
    isNew_ = true;
    refresh();
}

void Viewport::setCamera(const Camera& camera) {
    if (!(camera == camera_)) {
        camera_ = camera;
        refresh();
    }
}

void Viewport::setCatalog(std::shared_ptr<const Catalog> catalog) {
    catalog_ = std::move(catalog);
    catalogIsNew_ = true;
    refresh();
}

void Viewport::initializeGL() {
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &Viewport::dropRenderer);
    Result<std::unique_ptr<Renderer>> renderer = Renderer::create({sources_.programCache});
    if (!renderer) {
        failure_ = QString::fromStdString(renderer.error().text());
        Q_EMIT failed(failure_);
        return;
    }
    renderer_ = std::move(*renderer);
    renderer_->setTextures(sources_.textures);
    timer_.emplace(FrameTimer::Method::WallClock);
    catalogIsNew_ = catalog_ != nullptr;
    stale_ = true;
}

Image Viewport::linearPicture() {
    Scene unexposed = sources_.scene();
    unexposed.exposure = 0.0;
    return pictureOf(unexposed, view(), false);
}

Image Viewport::picture(bool display) {
    const Scene& whole = sources_.whole();
    if (&whole == &sources_.scene()) {
        return pictureOf(whole, view(), display);
    }
    stale_ = true; // what is shown is another picture, to which nothing of this one may be added
    View wanted = view();
    wanted.effects = nullptr;
    Image image = pictureOf(whole, wanted, display);
    refresh();
    return image;
}

Image Viewport::pictureOf(const Scene& scene, View wanted, bool display) {
    if (!renderer_) {
        return {};
    }
    wanted.isContinued = !stale_ && (progress_ == Progress::Idle || isContinued_);
    if (progress_ != Progress::Idle) {
        giveUpFrame(); // capturing takes its place
        if (wanted.isContinued) {
            continueSoon();
        } else {
            refresh();
        }
    }
    makeCurrent();
    Result<Image> picture = renderer_->capture(scene, wanted, sources_.meshes, display);
    doneCurrent();
    watchForRest();
    return picture ? std::move(*picture) : Image();
}

QString Viewport::frameTime() {
    if (!timer_) {
        return {};
    }
    makeCurrent();
    timer_->collect();
    doneCurrent();
    if (timer_->milliseconds() > 0.0) {
        const std::string_view method = timer_->methodText();
        frameTime_ = tr("%1 ms (%2)")
                         .arg(timer_->milliseconds(), 0, 'f', 2)
                         .arg(QString::fromUtf8(method.data(), qsizetype(method.size())));
    }
    return frameTime_;
}

void Viewport::chooseTimer() {
    if (!timer_) {
        return;
    }
    frameTime(); // of the frames so far
    makeCurrent();
    const FrameTimer::Method method = trustedMethod();
    if (method != timer_->method() && progress_ == Progress::Idle) {
        timer_.emplace(method);
    }
    doneCurrent();
}

const FrameReport& Viewport::report() const {
    static const FrameReport nothing;
    return renderer_ ? renderer_->report() : nothing;
}

View Viewport::view() const {
    View view;
    view.size = pixelsOf(size());
    view.camera = camera_;
    view.effects = sources_.effects ? sources_.effects() : nullptr;
    view.environmentImage = sources_.environment ? sources_.environment() : nullptr;
    view.isContinued = isContinued_;
    view.maxSamples = wantedSamples();
    return view;
}

void Viewport::dropRenderer() {
    giveUpFrame();
    if (const auto capture = std::exchange(capture_, std::nullopt)) {
        capture->taken({});
    }
    if (renderer_) {
        makeCurrent();
        timer_.reset();
        renderer_.reset();
        doneCurrent();
    }
}

void Viewport::mousePressEvent(QMouseEvent* event) {
    Q_EMIT activated();
    navigation_.press(*event);
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
    navigation_.move(*event);
    pointer_ = event->position().toPoint();
    probeSoon();
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
    navigation_.release(*event);
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
    navigation_.doubleClick(*event);
}

void Viewport::wheelEvent(QWheelEvent* event) {
    navigation_.wheel(*event);
    event->accept();
}

void Viewport::keyPressEvent(QKeyEvent* event) {
    if (!navigation_.keyPress(*event)) {
        QOpenGLWidget::keyPressEvent(event);
    }
}

void Viewport::keyReleaseEvent(QKeyEvent* event) {
    if (!navigation_.keyRelease(*event)) {
        QOpenGLWidget::keyReleaseEvent(event);
    }
}

void Viewport::focusInEvent(QFocusEvent* event) {
    Q_EMIT focusShown(event->reason() == Qt::TabFocusReason ||
                      event->reason() == Qt::BacktabFocusReason);
    QOpenGLWidget::focusInEvent(event);
}

void Viewport::focusOutEvent(QFocusEvent* event) {
    navigation_.focusLost();
    Q_EMIT focusShown(false);
    QOpenGLWidget::focusOutEvent(event);
}

/// The key of the light works wherever the pointer is, also before a click brings the focus here.
void Viewport::enterEvent(QEnterEvent* event) {
    qApp->installEventFilter(this);
    pointer_ = event->position().toPoint();
    probeSoon();
    QOpenGLWidget::enterEvent(event);
}

void Viewport::leaveEvent(QEvent* event) {
    qApp->removeEventFilter(this);
    pointer_.reset();
    probeSoon();
    QOpenGLWidget::leaveEvent(event);
}

bool Viewport::eventFilter(QObject* watched, QEvent* event) {
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease;
    const bool isElsewhere = watched->isWidgetType() && watched != this &&
                             !qobject_cast<QLineEdit*>(watched) &&
                             static_cast<QWidget*>(watched)->window() == window();
    if (!isKey || !isElsewhere) {
        return QOpenGLWidget::eventFilter(watched, event);
    }
    const auto& key = *static_cast<QKeyEvent*>(event);
    if (key.key() != Qt::Key_L || key.modifiers() != Qt::NoModifier) {
        return QOpenGLWidget::eventFilter(watched, event);
    }
    return event->type() == QEvent::KeyPress ? navigation_.keyPress(key)
                                             : navigation_.keyRelease(key);
}

void Viewport::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) {
        event->acceptProposedAction();
    }
}

void Viewport::dropEvent(QDropEvent* event) {
    QStringList files;
    for (const QUrl& url : event->mimeData()->urls()) {
        if (url.isLocalFile()) {
            files << url.toLocalFile();
        }
    }
    if (!files.isEmpty()) {
        event->acceptProposedAction();
        Q_EMIT filesDropped(files);
    }
}

} // namespace patina
