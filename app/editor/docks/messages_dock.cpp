// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/messages_dock.h"

#include <QPlainTextEdit>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "docks/panel.h"
#include "session/message_log.h"

namespace patina {

MessagesDock::MessagesDock(const DockContext& context)
    : messages_(context.messages), text_(new QPlainTextEdit(this)) {
    text_->setReadOnly(true);
    text_->setFrameShape(QFrame::NoFrame);
    text_->setAccessibleName(tr("Messages"));
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    text_->setPlaceholderText(tr("Nothing went wrong so far."));
    auto* clear = textButton(tr("Clear"), tr("Forget what happened; what is still wrong stays"),
                             this);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 6, 0);
    layout->addWidget(text_, 1);
    layout->addWidget(clear, 0, Qt::AlignTop);
    connect(clear, &QToolButton::clicked, &messages_, &MessageLog::clearEvents);
    connect(&messages_, &MessageLog::changed, this, &MessagesDock::update);
    update();
}

void MessagesDock::update() {
    text_->setPlainText(QString::fromStdString(text(messages_.messages())));
    text_->verticalScrollBar()->setValue(text_->verticalScrollBar()->maximum());
}

} // namespace patina
