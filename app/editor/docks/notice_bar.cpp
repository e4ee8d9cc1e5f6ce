// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/notice_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "docks/panel.h"

namespace patina {
namespace {

constexpr std::size_t maxActions = 2;

} // namespace

NoticeBar::NoticeBar(QWidget* parent) : QFrame(parent), label_(new QLabel(this)) {
    setFrameShape(QFrame::StyledPanel);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(6, 2, 2, 2);
    layout->setSpacing(2);
    label_->setWordWrap(true);
    label_->setTextFormat(Qt::PlainText);
    layout->addWidget(label_, 1);
    for (std::size_t i = 0; i < maxActions; ++i) {
        QToolButton* button = textButton({}, {}, this);
        layout->addWidget(button);
        buttons_.push_back(button);
        connect(button, &QToolButton::clicked, this, [this, i] {
            const std::function<void()> run = actions_.at(i).run; // run() may replace actions_
            run();
        });
    }
    hide();
}

void NoticeBar::say(const QString& text, const std::vector<Action>& actions) {
    label_->setText(text);
    actions_ = actions;
    for (std::size_t i = 0; i < buttons_.size(); ++i) {
        buttons_[i]->setVisible(i < actions_.size());
        if (i < actions_.size()) {
            buttons_[i]->setText(actions_[i].text);
            buttons_[i]->setToolTip(actions_[i].toolTip);
            buttons_[i]->setAccessibleName(actions_[i].toolTip);
        }
    }
    show();
}

void NoticeBar::clear() {
    label_->clear();
    hide();
}

QString NoticeBar::text() const {
    return label_->text();
}

} // namespace patina
