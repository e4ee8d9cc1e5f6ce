// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/measure_bar.h"

#include <cmath>

#include <QHBoxLayout>
#include <QMenu>
#include <QProgressBar>
#include <QToolButton>

#include "docks/elided_label.h"
#include "docks/panel.h"

namespace patina {
namespace {

constexpr int progressSteps = 1000;
constexpr int progressWidth = 200;
constexpr int longestText = 3; ///< in lines; the tool tip has the rest

} // namespace

MeasureBar::MeasureBar(const QString& what, const QStringList& endings, QWidget* parent)
    : QWidget(parent), what_(what), row_(new QHBoxLayout(this)),
      start_(textButton(tr("Measure"), what, this)),
      stop_(textButton(tr("Stop"), tr("Stop and keep what was measured so far"), this)),
      progress_(new QProgressBar(this)), text_(new ElidedLabel(this)),
      export_(textButton(tr("Export"), tr("Write what was measured to a file"), this)) {
    text_->setObjectName("state");
    progress_->setRange(0, progressSteps);
    progress_->setMaximumWidth(progressWidth);
    progress_->setAccessibleName(tr("Progress of the measurement"));
    auto* menu = new QMenu(export_);
    for (const QString& ending : endings) {
        menu->addAction(tr("As %1…").arg(ending.toUpper()), this,
                        [this, ending] { Q_EMIT exportWished(ending); });
    }
    export_->setMenu(menu);
    export_->setPopupMode(QToolButton::InstantPopup);
    row_->setContentsMargins(0, 0, 0, 0);
    for (QWidget* widget : std::initializer_list<QWidget*>{start_, stop_, progress_}) {
        row_->addWidget(widget);
    }
    row_->addWidget(text_, 1);
    row_->addWidget(export_);
    connect(start_, &QToolButton::clicked, this, &MeasureBar::startWished);
    connect(stop_, &QToolButton::clicked, this, &MeasureBar::stopWished);
    setRunning(false);
    setExportable(false);
}

void MeasureBar::addButton(QToolButton* button) {
    row_->insertWidget(row_->indexOf(export_), button);
}

void MeasureBar::setStartText(const QString& text) {
    start_->setText(text);
}

void MeasureBar::giveTwoLines() {
    text_->setMaxLines(longestText);
    text_->setMinimumHeight(2 * fontMetrics().lineSpacing()); // so that a longer text moves nothing
}

void MeasureBar::setProgress(double share) {
    progress_->setValue(static_cast<int>(std::lround(share * progressSteps)));
}

void MeasureBar::setRunning(bool running) {
    start_->setVisible(!running);
    stop_->setVisible(running);
    progress_->setVisible(running);
}

void MeasureBar::setStartable(bool startable, const QString& whyNot) {
    start_->setEnabled(startable && whyNot.isEmpty());
    start_->setToolTip(whyNot.isEmpty() ? what_ : whyNot);
}

void MeasureBar::setExportable(bool exportable) {
    export_->setEnabled(exportable);
}

void MeasureBar::setText(const QString& text) {
    text_->setElidedText(text);
}

QString MeasureBar::text() const {
    return text_->text();
}

} // namespace patina
