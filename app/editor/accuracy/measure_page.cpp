// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/measure_page.h"

#include <utility>

#include <QEvent>
#include <QFileInfo>
#include <QVBoxLayout>

#include "accuracy/chart_export.h"
#include "accuracy/cost_subject.h"
#include "accuracy/measure_bar.h"
#include "accuracy/measure_turn.h"
#include "core/atomic_file.h"
#include "docks/settling.h"
#include "document/document_files.h"
#include "session/message_log.h"

namespace patina {
namespace {

constexpr int settleMs = 100;

} // namespace

MeasurePage::MeasurePage(const DockContext& context, std::shared_ptr<MeasureTurn> turn,
                         const QString& what, const QStringList& endings,
                         std::unique_ptr<KeptResults> results, const QString& task)
    : document_(context.document), documentFiles_(context.documentFiles), meshes_(context.meshes),
      textures_(context.textures), environments_(context.environments), messages_(context.messages),
      turn_(std::move(turn)), results_(std::move(results)),
      bar_(new MeasureBar(what, endings, this)), rows_(new QVBoxLayout(this)),
      worker_({.name = task, .canCancel = true}) {
    rows_->setContentsMargins(6, 4, 6, 0);
    rows_->setSpacing(4);
    rows_->addWidget(bar_);
    settle_.setSingleShot(true);
    settle_.setInterval(settleMs);
    connectParts();
}

void MeasurePage::connectParts() {
    connect(bar_, &MeasureBar::startWished, this, [this] { startMeasuring(); });
    connect(bar_, &MeasureBar::stopWished, this, [this] { stopMeasuring(); });
    connect(bar_, &MeasureBar::exportWished, this, [this](const QString& ending) {
        const QString file = askForChartFile(this, ending);
        if (!file.isEmpty()) {
            exportTo(file);
        }
    });
    connect(&worker_, &Worker::progressed, this, [this](double share, const QString& doing) {
        doing_ = doing;
        bar_->setProgress(share);
        showState();
    });
    connect(turn_.get(), &MeasureTurn::changed, this, &MeasurePage::showState);
    connect(&settle_, &QTimer::timeout, this, &MeasurePage::follow);
    startWhenChanged(settle_, document_, meshes_);
    connect(&documentFiles_, &DocumentFiles::fileChanged, &settle_, qOverload<>(&QTimer::start));
}

void MeasurePage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    follow();
}

void MeasurePage::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && isVisible()) {
        refresh(); // marks have the palette's colours
    }
}

std::string MeasurePage::file() const {
    return documentFiles_.file().path.string();
}

/// Does nothing in a dock that is closed; showEvent() catches up.
void MeasurePage::follow() {
    if (isVisible()) {
        refresh();
    }
}

void MeasurePage::refresh() {
    const MeasuredSubject now = subject();
    shown_ = running_ ? &*running_ : results_->find(now, file());
    stale_ = shown_ != nullptr && !(shown_->subject == now);
    isOfOtherBlocks_ =
        stale_ && shown_->subject.scene == now.scene && shown_->subject.object == now.object;
    showNumbers(stale_);
    showState();
}

CostSweep::Subject MeasurePage::costSubject() {
    return patina::costSubject(document_, meshes_, textures_, environments_);
}

bool MeasurePage::canStart() const {
    return !isMeasuring() && nothingText().isEmpty() && turn_->whyNot(*this).isEmpty();
}

void MeasurePage::start(std::function<MeasureEnd(Worker::Control&)> measure) {
    if (!canStart() || !turn_->take(*this)) {
        return;
    }
    running_ = PageResult{subject(), file(), {}, {}, false, {}};
    doing_.clear();
    bar_->setProgress(0.0);
    worker_.ask(
        [measure = std::move(measure)](Worker::Control& control) {
            const Result<void> opened = control.openContext();
            return opened ? measure(control) : endOf(false, {opened.error()});
        },
        [this](const MeasureEnd& end) { finish(end); });
    refresh();
}

void MeasurePage::take(std::any numbers, const QString& method) {
    if (running_) {
        running_->numbers = std::move(numbers);
        running_->method = method;
        refresh();
    }
}

void MeasurePage::finish(const MeasureEnd& end) {
    turn_->giveBack(*this);
    if (running_) {
        running_->complete = end.value_or(false);
        running_->problem = problemText(end);
        results_->keep(*std::exchange(running_, std::nullopt));
    }
    refresh();
}

void MeasurePage::exportTo(const QString& file) {
    if (!hasNumbers()) {
        return;
    }
    const QByteArray bytes = bytesFor(QFileInfo(file).suffix().toLower());
    const auto written = writeFileAtomically(file.toStdString(), bytes.toStdString());
    if (!written) {
        messages_.add(written.error());
    }
}

QString MeasurePage::state() const {
    return bar_->text();
}

QString MeasurePage::nothingText() const {
    return document_.selection().object() < 0 ? tr("There is no object.") : QString();
}

QString MeasurePage::notYetText() const {
    return tr("Nothing is measured yet.");
}

QString MeasurePage::runningText() const {
    return tr("Measuring …");
}

QString MeasurePage::outOfDateText() const {
    return isOfOtherBlocks_ ? tr("Out of date: other shaders have been read since.")
                            : tr("Out of date: the scene has changed since.");
}

QString MeasurePage::measuredText() const {
    return shown_->method;
}

QString MeasurePage::stateText() const {
    if (isMeasuring()) {
        return doing_.isEmpty() ? runningText() : doing_;
    }
    if (const QString nothing = nothingText(); !nothing.isEmpty()) {
        return nothing;
    }
    if (shown_ != nullptr && !shown_->problem.isEmpty()) {
        return tr("Could not be measured: %1").arg(shown_->problem);
    }
    if (!hasNumbers()) {
        const QString whyNot = turn_->whyNot(*this);
        if (!whyNot.isEmpty()) {
            return whyNot;
        }
        return shown_ != nullptr && !stale_ ? tr("Stopped.") : notYetText();
    }
    if (stale_) {
        return outOfDateText();
    }
    return shown_->complete ? measuredText() : tr("Stopped. %1").arg(measuredText());
}

void MeasurePage::showState() {
    bar_->setRunning(isMeasuring());
    bar_->setStartable(nothingText().isEmpty(), turn_->whyNot(*this));
    bar_->setExportable(hasNumbers());
    bar_->setText(stateText());
}

MeasuredSubject MeasurePage::subjectOfModels() const {
    const int object = document().selection().object();
    Scene scene = document().ownScene(document().selection().side());
    if (object >= 0) {
        scene.objects[static_cast<std::size_t>(object)].material = {};
    }
    return subjectOf(std::move(scene), object, document().catalog(), SubjectBlocks::All);
}

} // namespace patina
