// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/status_line.h"

#include <algorithm>
#include <cmath>

#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include "background/long_tasks.h"
#include "docks/effect_label.h"
#include "text/short_text.h"
#include "window/task_popup.h"

namespace patina {
namespace {

/// Milliseconds; the line is written at most this often while frames follow each other
constexpr int settleMs = 250;
constexpr int progressWidth = 230;
constexpr int percent = 100;

} // namespace

StatusLine::StatusLine(Document& document, MessageLog& messages, QWidget* parent)
    : QStatusBar(parent), document_(document), messages_(messages), model_(new QLabel(this)),
      effects_(new QLabel(this)), comparison_(new QLabel(this)), samples_(new QLabel(this)),
      time_(new QLabel(this)), progress_(new QProgressBar(this)), tasks_(new QToolButton(this)),
      badge_(new QToolButton(this)), switched_(new QToolButton(this)) {
    setSizeGripEnabled(false);
    // What it says does not widen the window.
    setSizePolicy(QSizePolicy::Ignored, sizePolicy().verticalPolicy());
    model_->setObjectName("statusModel");
    effects_->setObjectName("statusEffects");
    time_->setObjectName("statusTime");
    // The list of effects shrinks when the window is narrow; its tool tip has all of it.
    effects_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    addWidget(model_);
    addWidget(effects_, 1);
    makeTaskRow();
    comparison_->setObjectName("statusComparison");
    comparison_->hide();
    addPermanentWidget(comparison_);
    samples_->setObjectName("statusSamples");
    samples_->hide();
    addPermanentWidget(samples_);
    switched_->setAutoRaise(true);
    switched_->setObjectName("switchedOff");
    switched_->setToolTip(tr("The views do not show everything: open the list of effects"));
    addPermanentWidget(switched_);
    setSwitchedOff(0);
    connect(switched_, &QToolButton::clicked, this, &StatusLine::effectsWished);
    addPermanentWidget(time_);
    badge_->setAutoRaise(true);
    badge_->setObjectName("messageBadge");
    addPermanentWidget(badge_);
    settle_.setSingleShot(true);
    settle_.setInterval(settleMs);
    connect(&settle_, &QTimer::timeout, this, &StatusLine::showFrame);
    connect(badge_, &QToolButton::clicked, this, &StatusLine::messagesWished);
    connect(&messages_, &MessageLog::changed, this, &StatusLine::showBadge);
    onChange(document_, DocumentChange::Current, &settle_, qOverload<>(&QTimer::start));
    showBadge();
    setMinimumHeight(sizeHint().height()); // parts that come and go do not move the views
}

void StatusLine::makeTaskRow() {
    progress_->setRange(0, percent);
    progress_->setFixedWidth(progressWidth);
    progress_->setObjectName("taskProgress");
    tasks_->setAutoRaise(true);
    tasks_->setObjectName("tasks");
    tasks_->setToolTip(tr("List what is going on, and stop it"));
    addPermanentWidget(progress_);
    addPermanentWidget(tasks_);
    connect(tasks_, &QToolButton::clicked, this, &StatusLine::listTasks);
    connect(&LongTasks::all(), &LongTasks::changed, this, &StatusLine::showTasks);
    showTasks();
}

/// Shows the oldest task, and how many there are.
void StatusLine::showTasks() {
    const std::vector<LongTasks::Row> rows = LongTasks::all().shown();
    progress_->setVisible(!rows.empty());
    tasks_->setVisible(!rows.empty());
    if (rows.empty()) {
        return;
    }
    const TaskState& first = rows.front().state;
    progress_->setValue(static_cast<int>(std::lround(std::max(first.share, 0.0) * percent)));
    progress_->setFormat(first.share < 0.0 ? rows.front().name
                                           : tr("%1 %p%").arg(rows.front().name));
    tasks_->setText(rows.size() == 1 ? tr("1 task") : tr("%1 tasks").arg(rows.size()));
    tasks_->setAccessibleName(tasks_->text());
}

void StatusLine::listTasks() {
    popup_ = new TaskPopup(LongTasks::all(), this);
    popup_->showAt(tasks_->mapToGlobal(QPoint(tasks_->width(), 0)));
}

void StatusLine::setViewport(Viewport* viewport) {
    if (viewport_) {
        disconnect(&viewport_->frames(), nullptr, this, nullptr);
    }
    viewport_ = viewport;
    connect(&viewport->frames(), &FrameLoop::frameDrawn, this, [this] {
        if (!settle_.isActive()) {
            settle_.start();
        }
    });
    settle_.start();
}

void StatusLine::showFrame() {
    const Material* material = document_.material(document_.selection().side());
    const Block* model =
        material ? document_.catalog().find(kinds::models, material->model.id) : nullptr;
    const QString id = material ? QString::fromStdString(material->model.id) : QString();
    model_->setText(model      ? shortened(QString::fromStdString(model->label))
                    : material ? tr("%1 (not installed)").arg(shortened(id))
                               : tr("No object"));
    if (!viewport_) {
        return;
    }
    QStringList effects;
    for (const std::string& effect : viewport_->frames().report().effects) {
        effects << effectLabel(effect, material, document_.scene(document_.selection().side()),
                               document_.catalog());
    }
    const QString list = effects.join(tr(", "));
    effects_->setText(tr("In the shader: %1").arg(list));
    effects_->setToolTip(effects.join('\n'));
    time_->setText(viewport_->frames().stopwatch().text());
    time_->setToolTip(tr("Time of the last frame of this view and how it was measured"));
    showSamples();
}

/// Shows how many samples of the environment's light the picture has.
void StatusLine::showSamples() {
    const int samples = viewport_->frames().samples();
    samples_->setVisible(samples > 0);
    samples_->setText(samples < viewport_->viewed().wantedSamples()
                          ? tr("Environment: %1 of %2 samples")
                                .arg(samples)
                                .arg(viewport_->viewed().wantedSamples())
                          : tr("Environment: %1 samples").arg(samples));
}

void StatusLine::setSwitchedOff(int effects) {
    switched_->setVisible(effects > 0);
    switched_->setText(effects == 1 ? tr("1 effect off") : tr("%1 effects off").arg(effects));
    switched_->setAccessibleName(switched_->text());
}

void StatusLine::setComparison(const QString& text, const QString& details) {
    comparison_->setText(text);
    comparison_->setToolTip(details);
    comparison_->setVisible(!text.isEmpty());
}

void StatusLine::showBadge() {
    const int count = messages_.count();
    const bool onlyNotes = count == messages_.noteCount();
    badge_->setText(count == 0   ? tr("No messages")
                    : onlyNotes  ? (count == 1 ? tr("1 note") : tr("%1 notes").arg(count))
                    : count == 1 ? tr("⚠ 1 message")
                                 : tr("⚠ %1 messages").arg(count));
    badge_->setAccessibleName(badge_->text());
    badge_->setToolTip(tr("Show or hide the messages"));
}

} // namespace patina
