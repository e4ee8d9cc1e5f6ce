// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/parameter_row.h"

#include <algorithm>

#include <QContextMenuEvent>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMimeData>
#include <QToolButton>
#include <QUrl>

#include "parameters/dropped_files.h"
#include "parameters/editor_factory.h"
#include "parameters/parameter_text.h"
#include "parameters/row_mark.h"
#include "parameters/scrub_label.h"
#include "parameters/texture_line.h"
#include "parameters/warning_mark.h"

namespace patina {

ParameterRow::ParameterRow(const Parameter& parameter, QWidget* parent)
    : QWidget(parent), editor_(makeEditor(parameter, this)),
      label_(new ScrubLabel(QString::fromStdString(parameter.label), this)),
      foldButton_(new QToolButton(this)), both_(new QWidget(this)),
      pair_(new QBoxLayout(QBoxLayout::LeftToRight, both_)), warning_(new WarningMark(this)),
      lockMark_(new RowMark(drawPadlock, this)), resetMark_(new RowMark(drawResetArrow, this)),
      value_(parameter.defaultValue) {
    makeLayout();
    makeAccessible();
    connect(editor_, &ParameterEditor::interactionBegan, this, &ParameterRow::interactionBegan);
    connect(editor_, &ParameterEditor::interactionEnded, this, &ParameterRow::interactionEnded);
    connect(editor_, &ParameterEditor::edited, this, &ParameterRow::edited);
    connect(lockMark_, &QAbstractButton::clicked, this, &ParameterRow::unlockWished);
    connect(resetMark_, &QAbstractButton::clicked, this, &ParameterRow::reset);
    connect(foldButton_, &QAbstractButton::clicked, this, [this] {
        isOpened_ = !isOpened_;
        updateFolding();
    });
    for (QWidget* widget : focusChain()) {
        widget->installEventFilter(this);
    }
    present(parameter.defaultValue);
    updateFolding();
}

void ParameterRow::makeLayout() {
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(6);
    line->addWidget(label_, 0, Qt::AlignTop);
    auto* column = new QVBoxLayout;
    column->setSpacing(2);
    column->addWidget(foldButton_);
    column->addWidget(both_);
    pair_->setContentsMargins(0, 0, 0, 0);
    pair_->setSpacing(2);
    pair_->addWidget(editor_, 1);
    line->addLayout(column, 1);
    line->addWidget(warning_, 0, Qt::AlignTop);
    line->addWidget(lockMark_, 0, Qt::AlignTop);
    line->addWidget(resetMark_, 0, Qt::AlignTop);
    label_->setWordWrap(true);
    setLabelWidth(labelWidthHint());
    editor_->scrubWith(*label_);
    foldButton_->setAutoRaise(true);
    foldButton_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    foldButton_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    QSizePolicy policy = resetMark_->sizePolicy();
    policy.setRetainSizeWhenHidden(true); // nothing may jump when a value changes
    resetMark_->setSizePolicy(policy);
    foldButton_->setObjectName("fold");
    lockMark_->setObjectName("lock");
    resetMark_->setObjectName("reset");
    alignFirstLine();
}

/// Label and marks are as high as the editor's first line, so that their texts stand level.
void ParameterRow::alignFirstLine() {
    int height = std::max(resetMark_->sizeHint().height(), foldButton_->sizeHint().height());
    for (const QWidget* widget : tabStopsIn(editor_)) {
        height = std::max(height, widget->sizeHint().height());
    }
    label_->setMinimumHeight(height);
    resetMark_->setFixedHeight(height);
    warning_->setFixedHeight(height);
    lockMark_->setFixedHeight(height);
}

void ParameterRow::makeAccessible() {
    setToolTip(tooltipOf(parameter()));
    label_->setBuddy(editor_->focusTarget());
    const QString doc = QString::fromStdString(parameter().doc);
    editor_->focusTarget()->setAccessibleDescription(doc);
    resetMark_->setAccessibleName(tr("Reset %1").arg(editor_->name()));
    resetMark_->setToolTip(tr("Changed. Click to reset to %1.")
                               .arg(shownValue(parameter(), parameter().defaultValue)));
    lockMark_->setAccessibleName(tr("Unlock %1").arg(editor_->name()));
    lockMark_->setToolTip(tr("Locked: random values, and a reset or a paste of the whole group, "
                             "leave it alone. Edits, presets and other models do not. Click to "
                             "unlock."));
    foldButton_->setAccessibleName(tr("Show %1").arg(editor_->name()));
}

const Parameter& ParameterRow::parameter() const {
    return editor_->parameter();
}

bool ParameterRow::isFolded() const {
    return !isCounting_ && !isOpened_;
}

void ParameterRow::present(const Value& value) {
    value_ = value;
    editor_->present(value);
    const bool isChanged = roundedToFloat(value) != roundedToFloat(parameter().defaultValue);
    if (isChanged != isChanged_) {
        isChanged_ = isChanged;
        resetMark_->setVisible(isChanged);
    }
    if (parameter().physical) {
        warning_->setWarning(physicalWarning(parameter(), value));
    }
    if (!isCounting_) {
        updateSummary();
    }
}

void ParameterRow::setCounting(bool counts, const QString& reason) {
    reason_ = reason;
    if (counts != isCounting_) {
        isCounting_ = counts;
        isOpened_ = false;
        updateFolding();
    }
}

void ParameterRow::updateFolding() {
    foldButton_->setVisible(!isCounting_);
    foldButton_->setArrowType(isFolded() ? Qt::RightArrow : Qt::DownArrow);
    both_->setVisible(!isFolded());
    editor_->setVisible(!isFolded());
    if (textureLine_) {
        textureLine_->setVisible(takesTextures_ && !isFolded());
    }
    QPalette colors;
    if (!isCounting_) {
        QColor grey = palette().color(QPalette::WindowText);
        grey.setAlphaF(0.55f); // quiet, but still to be read on light and dark
        colors.setColor(QPalette::WindowText, grey);
        colors.setColor(QPalette::ButtonText, grey);
    }
    label_->setPalette(colors);
    foldButton_->setPalette(colors);
    updateSummary();
}

void ParameterRow::updateSummary() {
    const QString shown = shownValue(parameter(), value_);
    foldButton_->setText(tr("%1, not in use").arg(shown));
    foldButton_->setToolTip(tr("Counts only when %1.").arg(reason_));
    foldButton_->setAccessibleDescription(foldButton_->text() + ". " + foldButton_->toolTip());
}

int ParameterRow::labelWidthHint() const {
    return label_->fontMetrics().horizontalAdvance(label_->text()) + 2;
}

/// Counts the reset mark even while it is hidden, so that the row needs no more room when it
/// appears.
int ParameterRow::widthBesideLabel() const {
    const int mark = resetMark_->sizeHint().width() + layout()->spacing();
    return layout()->minimumSize().width() - label_->minimumWidth() +
           (resetMark_->isHidden() ? mark : 0);
}

void ParameterRow::setLabelWidth(int width) {
    label_->setFixedWidth(width);
}

std::vector<QWidget*> ParameterRow::tabStopsIn(const QWidget* part) const {
    std::vector<QWidget*> stops;
    for (QWidget* widget : part->findChildren<QWidget*>()) {
        if (widget->window() == window() && (widget->focusPolicy() & Qt::TabFocus)) {
            stops.push_back(widget);
        }
    }
    return stops;
}

std::vector<QWidget*> ParameterRow::focusChain() const {
    std::vector<QWidget*> chain{foldButton_};
    const std::vector<QWidget*> editing = tabStopsIn(editor_);
    chain.insert(chain.end(), editing.begin(), editing.end());
    chain.insert(chain.end(), buttons_.begin(), buttons_.end());
    if (textureLine_) {
        const std::vector<QWidget*> image = tabStopsIn(textureLine_);
        chain.insert(chain.end(), image.begin(), image.end());
    }
    return chain;
}

void ParameterRow::addButton(QToolButton* button) {
    buttons_.push_back(button);
    pair_->addWidget(button, 0, Qt::AlignTop);
    button->installEventFilter(this);
}

TextureLine* ParameterRow::makeTextureLine() {
    textureLine_ = new TextureLine(editor_->name(), this);
    pair_->addWidget(textureLine_);
    setAcceptDrops(true);
    updateFolding();
    return textureLine_;
}

/// Without an image its button stands beside the editor; an image has a line of its own.
void ParameterRow::presentTexture(bool takes, const std::optional<TextureUse>& use,
                                  const TexturePreview& preview) {
    takesTextures_ = takes;
    textureLine_->present(use, preview);
    textureLine_->setVisible(takes && !isFolded());
    const bool hasEditor = !infoOf(parameter().type).isFile;
    pair_->setDirection(use && hasEditor ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    pair_->setStretchFactor(editor_, hasEditor ? 1 : 0);
    pair_->setAlignment(textureLine_, use ? Qt::Alignment() : Qt::AlignLeft);
}

void ParameterRow::dragEnterEvent(QDragEnterEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (takesTextures_ && urls.size() == 1 && urls.front().isLocalFile()) {
        acceptCopy(*event);
    }
}

void ParameterRow::dropEvent(QDropEvent* event) {
    acceptCopy(*event);
    Q_EMIT imageDropped(event->mimeData()->urls().front().toLocalFile());
}

bool ParameterRow::hasTexture() const {
    return textureLine_ && textureLine_->isBound();
}

bool ParameterRow::isLocked() const {
    return !lockMark_->isHidden();
}

void ParameterRow::setLocked(bool isLocked) {
    lockMark_->setVisible(isLocked);
}

void ParameterRow::reset() {
    Q_EMIT edited(parameter().defaultValue);
}

void ParameterRow::contextMenuEvent(QContextMenuEvent* event) {
    Q_EMIT menuWished(event->globalPos());
}

void ParameterRow::mouseDoubleClickEvent(QMouseEvent* event) {
    if (label_->geometry().contains(event->position().toPoint())) {
        reset();
    }
}

void ParameterRow::enterEvent(QEnterEvent* event) {
    QWidget::enterEvent(event);
    Q_EMIT approached();
}

void ParameterRow::leaveEvent(QEvent* event) {
    QWidget::leaveEvent(event);
    Q_EMIT left();
}

bool ParameterRow::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn) {
        Q_EMIT approached();
    }
    const bool isKey =
        event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    if (!isKey || qobject_cast<QLineEdit*>(watched)) {
        return QWidget::eventFilter(watched, event);
    }
    return takeKey(*static_cast<QKeyEvent*>(event)) || QWidget::eventFilter(watched, event);
}

/// Backspace resets, and the clipboard's keys copy and paste, wherever the row has the focus,
/// except where it edits text. No shortcut of the window may take them.
bool ParameterRow::takeKey(QKeyEvent& key) {
    void (ParameterRow::*act)() = key.key() == Qt::Key_Backspace     ? &ParameterRow::reset
                                  : key.matches(QKeySequence::Copy)  ? &ParameterRow::copyWished
                                  : key.matches(QKeySequence::Paste) ? &ParameterRow::pasteWished
                                                                     : nullptr;
    if (!act) {
        return false;
    }
    if (key.type() == QEvent::KeyPress) {
        (this->*act)();
    }
    key.accept();
    return true;
}

void ParameterRow::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        updateFolding();
    } else if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) {
        alignFirstLine();
    }
}

} // namespace patina
