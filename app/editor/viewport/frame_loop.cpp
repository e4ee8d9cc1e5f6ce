// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/frame_loop.h"

#include <algorithm>
#include <utility>

#include "background/free_memory.h"
#include "render/frame/frame_job.h"
#include "render/surfaces/inspection_drawer.h"

namespace patina {
namespace {

/// So long a frame may take that might be a quick one, with the images it is drawn into. What
/// shows it in the window takes some 40 ms more on a slow screen.
constexpr std::chrono::milliseconds firstPatience{40};

/// Is how long for a sketch. Before the first one there is no window yet that could stand still.
constexpr std::chrono::milliseconds firstSketchPatience{200};
constexpr std::chrono::milliseconds sketchPatience{30};

/// Milliseconds; after a change of size, a frame that takes longer comes after a sketch.
constexpr double longFrame = 400.0;

} // namespace

FrameLoop::FrameLoop(QWidget& widget, const ViewedScene& viewed)
    : viewed_(viewed), context_(viewed.sources().context), surface_(widget, context_),
      stopwatch_(context_), turn_(context_.turns(), [this] { proceed(); }), programs_(viewed),
      note_(widget, surface_), refinement_(viewed),
      targets_([this] { return isDrawing() || wantsSamples(); }, [this] { releaseTargets(); }) {
    preparing_.setSingleShot(true);
    connect(&surface_, &ViewSurface::paintDue, this, &FrameLoop::paint);
    connect(&preparing_, &QTimer::timeout, this, &FrameLoop::makeTargets);
    connect(&refinement_, &SampleRefinement::due, this, &FrameLoop::addSamples);
    connect(&programs_, &OrderedPrograms::came, this, &FrameLoop::takePrograms);
    connect(&programs_, &OrderedPrograms::givenUp, this, &FrameLoop::giveUpPrograms);
}

void FrameLoop::open() {
    Result<std::unique_ptr<Renderer>> renderer = surface_.open();
    if (!renderer) {
        failure_ = QString::fromStdString(renderer.error().text());
        Q_EMIT failed(failure_);
        return;
    }
    renderer_ = std::move(*renderer);
    renderer_->setTextures(viewed_.sources().textures);
    renderer_->setTables(viewed_.sources().tables);
    const ViewContext::Current current(context_);
    stopwatch_.open();
    catalogIsNew_ = viewed_.catalog() != nullptr;
    stale_ = true;
}

void FrameLoop::close() {
    giveUp();
    Q_EMIT closing();
    isClosed_ = true;
    if (renderer_) {
        {
            const ViewContext::Current current(context_);
            stopwatch_.close();
        }
        surface_.close(std::move(renderer_));
        stale_ = true;
    }
}

void FrameLoop::paint() {
    if (!renderer_ && !isClosed_ && failure_.isEmpty()) {
        open();
    }
    if (renderer_ && sketchesFirst_ && surface_.isOutgrown()) {
        surface_.show(*renderer_); // a step of what comes now may take long
    }
    const bool isNew = isNew_;
    const Painted painted = paintNext();
    if (painted != Painted::Nothing && painted != Painted::Later) {
        surface_.notePicture();
    }
    switch (painted) {
    case Painted::Nothing:
        break;
    case Painted::Later:
        if (isNew) {
            note_.show();
        }
        break;
    case Painted::Sketch:
        finishSketch();
        break;
    case Painted::Frame:
        finishFrame();
        break;
    case Painted::Restyled:
        ++restyledCount_;
        targets_.noteUse();
        Q_EMIT frameDrawn();
        if (moreSamples_) {
            surface_.requestPaint();
        } else {
            continueSoon();
        }
        break;
    }
    if (renderer_) {
        surface_.show(*renderer_);
    }
}

FrameLoop::Painted FrameLoop::paintNext() {
    if (renderer_ && progress_ == Progress::Idle && std::exchange(restyles_, false) && !stale_) {
        const ViewContext::Current current(context_);
        if (holdsFrame_ && takePasses()) {
            renderer_->job().show(surface_.framebuffer());
            return Painted::Restyled;
        }
        stale_ = true;
    }
    const bool isDrawn = progress_ == Progress::Drawn;
    const bool isWanted = progress_ == Progress::Idle && (stale_ || moreSamples_);
    if (!renderer_ || !(isDrawn || isWanted)) {
        return Painted::Nothing;
    }
    const ViewContext::Current current(context_);
    const unsigned framebuffer =
        isWanted ? surface_.framebuffer() : surface_.framebuffer(renderer_->job().size());
    if (isWanted) {
        refinement_.beginFrame(std::exchange(stale_, false), samples());
        return beginFrame(framebuffer);
    }
    show(framebuffer);
    return std::exchange(sketching_, false) ? Painted::Sketch : Painted::Frame;
}

void FrameLoop::refresh() {
    const Scene& drawn =
        progress_ == Progress::Lent ? viewed_.sources().whole() : viewed_.sources().scene();
    if (isDrawing() && (refinement_.isAtRest() || !renderer_->job().hasMeshesOf(drawn))) {
        giveUp(); // it only refines a picture that is gone, or objects have come or gone
    }
    stale_ = true;
    surface_.requestPaint();
}

void FrameLoop::restyle() {
    if (stale_ || inspected_ || !(holdsFrame_ || isDrawing())) {
        refresh();
        return;
    }
    restyles_ = true;
    surface_.requestPaint();
}

bool FrameLoop::takePasses() {
    const Scene& scene = viewed_.sources().scene();
    const View drawn = viewed_.view();
    return renderer_->job().takePasses(scene, drawn.effects != nullptr ? *drawn.effects : scene);
}

void FrameLoop::announceScene() {
    isNew_ = true;
    sketchesFirst_ = true;
    refresh();
}

void FrameLoop::announceSize() {
    if (sketching_ && !surface_.hasPicture()) {
        sketchesFirst_ = true; // after the first picture of all, which comes stretched
    } else {
        giveUp();
        sketchesFirst_ = sketchesFirst_ || areFramesLong_;
    }
    refresh();
}

void FrameLoop::announceCatalog() {
    catalogIsNew_ = true;
    refresh();
}

void FrameLoop::giveUp() {
    turn_.leave();
    preparing_.stop();
    if (progress_ == Progress::Lent) {
        Q_EMIT interrupted();
        return;
    }
    if (std::exchange(sketching_, false)) {
        sketchesFirst_ = true; // what was being drawn is not to be seen yet
    }
    const Progress progress = std::exchange(progress_, Progress::Idle);
    if (progress == Progress::Drawing || progress == Progress::Drawn) {
        const ViewContext::Current current(context_);
        stopwatch_.end();
    }
}

void FrameLoop::setInspected(std::optional<Inspected> shown) {
    if (shown != inspected_) {
        giveUp();
        inspected_ = shown;
        refresh();
    }
}

std::optional<PixelProbe> FrameLoop::probe(glm::ivec2 pixel) {
    const ViewContext::Current current(context_);
    auto found = renderer_->inspection().probe(viewed_.sources().scene(), view(),
                                               viewed_.sources().meshes, pixel);
    return found ? std::move(*found) : std::nullopt;
}

View FrameLoop::view() const {
    View view = viewed_.view();
    view.isContinued = refinement_.isContinued();
    return view;
}

int FrameLoop::samples() const {
    return renderer_ ? renderer_->job().environmentSamples() : 0;
}

EnvironmentLamps FrameLoop::environmentLamps() const {
    return renderer_ ? patina::environmentLamps(renderer_->job().environmentRadiance())
                     : EnvironmentLamps();
}

const FrameReport& FrameLoop::report() const {
    static const FrameReport nothing;
    return renderer_ ? renderer_->report() : nothing;
}

FrameLoop::Painted FrameLoop::beginFrame(unsigned framebuffer) {
    moreSamples_ = false;
    if (std::exchange(catalogIsNew_, false) && renderer_->catalog() != viewed_.catalog().get()) {
        renderer_->setCatalog(viewed_.catalog()); // that of all views
    }
    if (inspected_) {
        stopwatch_.begin();
        renderer_->inspection().draw(viewed_.sources().scene(), view(), viewed_.sources().meshes,
                                     framebuffer, *inspected_);
        stopwatch_.end();
        return Painted::Frame;
    }
    const bool sketchesFirst = sketchesFirst_;
    FrameJob& job = beginJob(sketchesFirst ? FramePurpose::Sketch : FramePurpose::Window);
    if (waitsForPrograms(job)) {
        return Painted::Later;
    }
    isNew_ = false;
    sketchesFirst_ = false;
    stopwatch_.begin();
    if (sketchesFirst) {
        if (const std::optional<Painted> sketch = drawSketch(job, framebuffer)) {
            return *sketch;
        }
        return drawFrame(beginJob(FramePurpose::Window), framebuffer);
    }
    return drawFrame(job, framebuffer);
}

FrameJob& FrameLoop::beginJob(FramePurpose purpose) {
    return renderer_->begin(viewed_.sources().scene(), refinement_.drawn(viewed_.view()),
                            viewed_.sources().meshes, purpose);
}

/// Tells whether the frame waits for programs that are made elsewhere meanwhile. The first frame
/// has no window yet that could stand still.
bool FrameLoop::waitsForPrograms(FrameJob& job) {
    const View drawn = refinement_.drawn(viewed_.view());
    if (frameCount_ == 0 || !programs_.mustWait(job, viewed_.sources().scene(), drawn)) {
        return false;
    }
    ++waitCount_;
    progress_ = Progress::Waiting;
    preparing_.start(0);
    return true;
}

/// Makes them meanwhile; it takes as long as several steps of a frame.
void FrameLoop::makeTargets() {
    const ViewContext::Current current(context_);
    beginJob(FramePurpose::Targets).step(FrameJob::never);
}

void FrameLoop::takePrograms() {
    if (progress_ == Progress::Waiting) {
        endWaiting();
        (refinement_.isAtRest() ? moreSamples_ : stale_) = true;
        surface_.requestPaint();
    }
}

/// Leaves the last picture on the screen until something changes again.
void FrameLoop::giveUpPrograms() {
    if (progress_ == Progress::Waiting) {
        endWaiting();
        surface_.requestPaint();
    }
}

void FrameLoop::endWaiting() {
    preparing_.stop();
    progress_ = Progress::Idle;
}

/// Shows a sketch, now or in later turns. Nothing where the frame is as quick.
std::optional<FrameLoop::Painted> FrameLoop::drawSketch(FrameJob& job, unsigned framebuffer) {
    const auto patience = frameCount_ == 0 ? firstSketchPatience : sketchPatience;
    sketching_ = job.step(patience) == FrameJob::Progress::More;
    if (job.isNeedless()) {
        return std::nullopt;
    }
    if (sketching_) {
        goOn();
        return Painted::Later;
    }
    job.show(framebuffer);
    stopwatch_.end();
    return Painted::Sketch;
}

FrameLoop::Painted FrameLoop::drawFrame(FrameJob& job, unsigned framebuffer) {
    if (job.step(firstPatience) == FrameJob::Progress::More) {
        goOn();
        return Painted::Later;
    }
    show(framebuffer);
    return Painted::Frame;
}

void FrameLoop::show(unsigned framebuffer) {
    renderer_->job().show(framebuffer, sketching_ ? 1.0 : refinement_.nextShare(samples()));
    stopwatch_.end();
}

/// Draws the rest of a frame in later turns.
void FrameLoop::goOn() {
    progress_ = Progress::Drawing;
    turn_.take(sketching_               ? Urgency::Sketch
               : refinement_.isAtRest() ? Urgency::Refinement
                                        : Urgency::Frame);
}

/// Draws another turn of a long frame. Where the same objects are seen in another way it is
/// finished before a newer one begins: dropping it for every move of a drag would show none.
void FrameLoop::proceed() {
    const FrameJob::Progress progress = [this] {
        const ViewContext::Current current(context_);
        return renderer_->job().step(stepPatience);
    }();
    if (progress == FrameJob::Progress::Done) {
        turn_.leave();
        progress_ = Progress::Drawn;
        surface_.requestPaint();
    }
}

/// The whole frame is the next one.
void FrameLoop::finishSketch() {
    progress_ = Progress::Idle;
    note_.hide();
    stale_ = true;
    surface_.requestPaint();
    Q_EMIT sketchDrawn();
}

void FrameLoop::finishFrame() {
    if (!inspected_) {
        renderer_->job().noteTime(stopwatch_.milliseconds());
        areFramesLong_ = stopwatch_.milliseconds() > longFrame;
    }
    progress_ = Progress::Idle;
    holdsFrame_ = !inspected_;
    ++frameCount_;
    note_.hide();
    const FrameReport& report = renderer_->report();
    targets_.noteUse();
    if (report.messages != messages_) {
        messages_ = report.messages;
        Q_EMIT messagesDrawn(messages_);
    }
    Q_EMIT frameDrawn();
    stale_ = stale_ || report.isWaiting;
    if (stale_ || restyles_) {
        surface_.requestPaint();
    } else {
        continueSoon();
    }
}

bool FrameLoop::wantsSamples() const {
    return !inspected_ && refinement_.wantsMore(samples());
}

/// Refines a frame that shows the scene as it is.
void FrameLoop::continueSoon() {
    if (!inspected_) {
        refinement_.continueSoon(samples());
    }
}

void FrameLoop::addSamples() {
    if (wantsSamples() && !stale_ && !isDrawing()) {
        moreSamples_ = true;
        surface_.requestPaint();
    }
}

Image FrameLoop::pictureOf(const Scene& scene, View wanted, bool display) {
    if (!renderer_) {
        return {};
    }
    wanted.isContinued =
        !stale_ && !restyles_ && (progress_ == Progress::Idle || refinement_.isContinued());
    if (progress_ != Progress::Idle) {
        giveUp(); // the picture takes its place
        if (wanted.isContinued) {
            continueSoon();
        } else {
            refresh();
        }
    }
    holdsFrame_ = false;
    const ViewContext::Current current(context_);
    Result<Image> picture = renderer_->capture(scene, wanted, viewed_.sources().meshes, display);
    targets_.noteUse();
    return picture ? std::move(*picture) : Image();
}

Image FrameLoop::shownPicture(bool display, std::optional<double> exposure) {
    if (!renderer_ || !isUpToDate() || isInspecting() || !renderer_->job().hasPicture()) {
        return {};
    }
    const ViewContext::Current current(context_);
    return renderer_->job().read(display, exposure).value_or(Image());
}

Renderer& FrameLoop::lend() {
    if (progress_ != Progress::Lent) {
        giveUp();
        refinement_.forgetFrame();
        holdsFrame_ = false;
        progress_ = Progress::Lent;
    }
    return *renderer_;
}

void FrameLoop::takeBack(bool isAnother) {
    progress_ = Progress::Idle;
    targets_.noteUse();
    if (isAnother) {
        refresh();
    } else if (stale_) {
        surface_.requestPaint();
    } else {
        continueSoon();
    }
}

void FrameLoop::drawUnseen(const Scene& scene, const View& view) {
    const ViewContext::Current current(context_);
    renderer_->begin(scene, view, viewed_.sources().meshes, FramePurpose::Prewarm)
        .step(FrameJob::never);
    targets_.noteUse();
}

/// The picture that is shown is the surface's; what it was made in is a third of the editor's
/// memory.
void FrameLoop::releaseTargets() {
    if (renderer_) {
        {
            const ViewContext::Current current(context_);
            renderer_->job().releaseTargets();
        }
        returnFreeMemory();
    }
}

} // namespace patina
