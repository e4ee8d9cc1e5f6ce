// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/panel.h"

#include <algorithm>

#include <QEvent>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

namespace patina {
namespace {

constexpr int margin = 6;
constexpr int settlingMs = 500;
constexpr int widest = 340; ///< pixels that content may claim at most

/// Is as wide as its content needs, up to `widest`.
class ScrolledContent : public QScrollArea {
  public:
    QSize minimumSizeHint() const override {
        const QSize least = QScrollArea::minimumSizeHint();
        const int needed =
            widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width();
        return {std::max(least.width(), std::min(needed, widest)), least.height()};
    }

  protected:
    /// Passes on only what makes it wider or narrower: the whole window is laid out for it, and a
    /// slider's tick asks its content for a layout.
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::LayoutRequest && asked_ != minimumSizeHint().width()) {
            asked_ = minimumSizeHint().width();
            updateGeometry();
        }
        return QScrollArea::eventFilter(watched, event);
    }

  private:
    int asked_ = -1; ///< pixels; the width that it last asked for
};

/// Keeps a section at the top of its panel for a moment: a panel that is new has layouts to come,
/// in which labels above the section wrap otherwise and rows change their height.
class KeptAtTop : public QObject {
  public:
    KeptAtTop(QScrollArea& area, QWidget& section)
        : QObject(&section), area_(area), section_(section) {
        section.installEventFilter(this);
        area.widget()->installEventFilter(this);
        QTimer::singleShot(settlingMs, this, &QObject::deleteLater);
    }

    void scroll() {
        const int top = section_.mapTo(area_.widget(), QPoint()).y();
        area_.ensureVisible(0, top + area_.viewport()->height(), 0, 0);
        area_.ensureVisible(0, top, 0, 0);
    }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        const bool hasMoved = watched == &section_ && event->type() == QEvent::Move;
        if (hasMoved || (watched == area_.widget() && event->type() == QEvent::Resize)) {
            // The scroll bar has its range only after this event.
            QMetaObject::invokeMethod(this, &KeptAtTop::scroll, Qt::QueuedConnection);
        }
        return QObject::eventFilter(watched, event);
    }

  private:
    QScrollArea& area_;
    QWidget& section_;
};

} // namespace

void fillPanel(QWidget* panel, const std::vector<QWidget*>& rows, QWidget* scrolled) {
    auto* layout = new QVBoxLayout(panel);
    layout->setContentsMargins(margin, margin, margin, 0);
    layout->setSpacing(margin);
    for (QWidget* row : rows) {
        layout->addWidget(row);
    }
    layout->addWidget(scrolledUpDown(scrolled), 1);
}

QWidget* scrolledUpDown(QWidget* content) {
    auto* area = new ScrolledContent;
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setFocusPolicy(Qt::NoFocus);
    auto* holder = new QWidget;
    auto* layout = new QVBoxLayout(holder);
    layout->setContentsMargins(0, 0, 0, margin);
    layout->addWidget(content);
    layout->addStretch(1);
    area->setWidget(holder);
    return area;
}

void scrollToSection(const QWidget& panel, const QString& title) {
    const auto sections = panel.findChildren<QGroupBox*>();
    const auto section = std::ranges::find(sections, title, &QGroupBox::title);
    auto* area = panel.findChild<QScrollArea*>();
    if (section == sections.end() || area == nullptr) {
        return;
    }
    (new KeptAtTop(*area, **section))->scroll();
}

QWidget* labelled(const QString& text, QWidget* widget) {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* label = new QLabel(text);
    label->setBuddy(widget);
    label->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Preferred); // is never cut off
    layout->addWidget(label);
    layout->addWidget(widget, 1);
    return row;
}

QWidget* rowOf(const std::vector<QWidget*>& widgets) {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    for (std::size_t i = 0; i < widgets.size(); ++i) {
        layout->addWidget(widgets[i], i == 0 ? 1 : 0);
    }
    return row;
}

QLabel* hintLabel(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setWordWrap(true);
    label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}

QToolButton* textButton(const QString& text, const QString& toolTip, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setText(text);
    button->setToolTip(toolTip);
    button->setAccessibleName(toolTip);
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    return button;
}

} // namespace patina
