// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheets/axis_row.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "docks/panel.h"
#include "parameters/choice_box.h"
#include "parameters/number_box.h"
#include "sheet/axis_steps.h"
#include "sheets/check_menu.h"
#include "text/as_text.h"
#include "text/short_text.h"

namespace patina {
namespace {

constexpr int wideEnough = 420; ///< pixels from which the row is one line
constexpr int decimals = 3;
constexpr int minSteps = 2;
constexpr int longestEntries = 14; ///< letters

NumberBox* stepBox(const QString& name, const QString& toolTip, int digits, int letters,
                   QWidget* parent) {
    auto* box = new NumberBox(digits, {}, parent);
    box->setAccessibleName(name);
    box->setToolTip(toolTip);
    box->setFixedWidth(box->fontMetrics().horizontalAdvance(QString(letters, '0')) + 18);
    return box;
}

bool isOf(const AxisOffer& offer, const SheetAxis& axis) {
    return offer.axis.kind == axis.kind && offer.axis.value == axis.value;
}

} // namespace

AxisRow::AxisRow(Direction direction, QWidget* parent)
    : QWidget(parent), direction_(direction), what_(new ChoiceBox(this)), steps_(new QWidget(this)),
      from_(stepBox(tr("From"), tr("The value of the first cells"), decimals, 6, steps_)),
      to_(stepBox(tr("To"), tr("The value of the last cells"), decimals, 6, steps_)),
      count_(
          stepBox(tr("Steps"), tr("So many cells, from 2 to %1").arg(maxSheetSteps), 0, 3, steps_)),
      entries_(textButton({}, tr("What the axis goes through"), steps_)),
      menu_(new CheckMenu(entries_)), layout_(new QBoxLayout(QBoxLayout::TopToBottom, this)) {
    const bool isAcross = direction == Direction::Right;
    setObjectName(isAcross ? "x" : "y");
    what_->setAccessibleName(isAcross ? tr("What changes from left to right")
                                      : tr("What changes from top to bottom"));
    what_->setToolTip(what_->accessibleName());
    entries_->setMenu(menu_);
    entries_->setPopupMode(QToolButton::InstantPopup);
    layOut();
    connectParts();
}

void AxisRow::layOut() {
    auto* arrow =
        new QLabel(direction_ == Direction::Right ? QStringLiteral("→") : QStringLiteral("↓"));
    arrow->setBuddy(what_);
    arrow->setFixedWidth(fontMetrics().horizontalAdvance(QStringLiteral("→")) + 4);
    auto* choice = new QHBoxLayout;
    choice->setSpacing(2);
    choice->addWidget(arrow);
    choice->addWidget(what_, 1);
    auto* line = new QHBoxLayout(steps_);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(4);
    line->addSpacing(arrow->width() - 2);
    line->addWidget(from_);
    line->addWidget(new QLabel(QStringLiteral("–")));
    line->addWidget(to_);
    line->addWidget(new QLabel(QStringLiteral("×")));
    line->addWidget(count_);
    line->addWidget(entries_);
    line->addStretch(1);
    layout_->setContentsMargins(0, 0, 0, 0);
    layout_->setSpacing(3);
    layout_->addLayout(choice, 1);
    layout_->addWidget(steps_);
}

void AxisRow::connectParts() {
    connect(what_, &QComboBox::activated, this, &AxisRow::choose);
    const auto connectBox = [this](NumberBox* box, auto changed) {
        connect(box, &NumberBox::typed, this, [this, changed](double value) {
            if (axis_ && axis_->range) {
                wishRange(changed(*axis_->range, value));
            }
        });
        connect(box, &NumberBox::stepped, this, [this, box, changed](double steps) {
            if (axis_ && axis_->range) {
                const double step = box == count_ ? 1.0 : number_ ? number_->step : 0.01;
                const double by = box == count_ ? std::copysign(1.0, steps) : steps * step;
                wishRange(changed(*axis_->range, box->value() + by));
            }
        });
    };
    connectBox(from_, [](SheetRange range, double value) {
        range.from = value;
        return range;
    });
    connectBox(to_, [](SheetRange range, double value) {
        range.to = value;
        return range;
    });
    connectBox(count_, [](SheetRange range, double value) {
        range.steps = static_cast<int>(
            std::lround(std::clamp(value, double(minSteps), double(maxSheetSteps))));
        return range;
    });
}

void AxisRow::show(const std::optional<SheetAxis>& axis, const Subject& subject) {
    axis_ = axis;
    const auto offer = std::ranges::find_if(
        subject.offers, [&](const AxisOffer& each) { return axis && isOf(each, *axis); });
    number_ = offer == subject.offers.end() ? std::nullopt : offer->of;
    fillChoices(subject);
    fillEntries(subject);
    const bool isRange = axis_ && axis_->range;
    for (QWidget* widget : steps_->findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
        widget->setVisible(widget == entries_ ? axis_ && !isRange && !listed_.empty() : isRange);
    }
    steps_->setVisible(axis_.has_value());
    showRange();
}

/// Lists all that an axis may be of, and on top what this one is of where that is not among it.
void AxisRow::fillChoices(const Subject& subject) {
    offers_ = subject.offers;
    const bool isKnown = !axis_ || std::ranges::any_of(offers_, [this](const AxisOffer& each) {
        return isOf(each, *axis_);
    });
    if (!isKnown) {
        const auto planned = plannedAxis(*axis_, subject.scene, subject.object, subject.catalog);
        offers_.insert(offers_.begin(), {*axis_, planned ? planned->title : axis_->value});
    }
    QStringList labels;
    if (direction_ == Direction::Down) {
        labels << tr("Nothing");
    }
    int current = 0;
    for (const AxisOffer& each : offers_) {
        current = axis_ && isOf(each, *axis_) ? static_cast<int>(labels.size()) : current;
        labels << asText(each.label);
    }
    QStringList before;
    for (int i = 0; i < what_->count(); ++i) {
        before << what_->itemText(i);
    }
    if (labels != before) {
        what_->clear();
        what_->addItems(labels);
    }
    what_->setCurrentIndex(current);
}

/// Lists what the axis may go through: the members of a kind, a choice or a switch, or the values
/// of a list.
void AxisRow::fillEntries(const Subject& subject) {
    const auto steps = [&](const std::vector<std::string>& entries) {
        const auto planned = plannedAxis({axis_->kind, axis_->value, {}, entries}, subject.scene,
                                         subject.object, subject.catalog);
        return planned ? planned->steps : std::vector<SheetStep>();
    };
    std::vector<SheetStep> listed;
    if (axis_ && !axis_->range) {
        listed = number_ ? listed : steps({});
        for (const SheetStep& step : steps(axis_->entries)) {
            if (std::ranges::find(listed, step.entry, &SheetStep::entry) == listed.end()) {
                listed.push_back(step);
            }
        }
    }
    if (listed != listed_) { // else the menu may stay open
        listed_ = std::move(listed);
        fillMenu();
    }
    showEntries();
}

void AxisRow::fillMenu() {
    menu_->clear();
    for (const SheetStep& step : listed_) {
        QAction* check = menu_->addCheck(asText(step.label), true);
        connect(check, &QAction::triggered, this,
                [this, entry = step.entry](bool on) { wishEntry(entry, on); });
    }
    if (number_ && !listed_.empty()) {
        menu_->addSeparator();
        menu_->addAction(tr("From one number to another"), this, [this] {
            wishRange({number_->softMin, number_->softMax, usualSheetSteps});
        });
    }
}

/// Shows which entries the axis goes through.
void AxisRow::showEntries() {
    QStringList chosen;
    for (std::size_t i = 0; i < listed_.size(); ++i) {
        const bool isOn = isChosen(listed_[i].entry);
        menu_->actions()[static_cast<qsizetype>(i)]->setChecked(isOn);
        if (isOn) {
            chosen << asText(listed_[i].label);
        }
    }
    const bool isAll = chosen.size() == static_cast<qsizetype>(listed_.size());
    entries_->setText(isAll ? tr("All %1").arg(listed_.size())
                            : shortened(chosen.join(QStringLiteral(", ")), longestEntries));
}

bool AxisRow::isChosen(const std::string& entry) const {
    return axis_->entries.empty() ||
           std::ranges::find(axis_->entries, entry) != axis_->entries.end();
}

void AxisRow::choose(int index) {
    const int offer = index - (direction_ == Direction::Down ? 1 : 0);
    if (offer < 0) {
        Q_EMIT wished(std::nullopt);
        return;
    }
    const SheetAxis& wanted = offers_[static_cast<std::size_t>(offer)].axis;
    if (!axis_ || wanted.kind != axis_->kind || wanted.value != axis_->value) {
        Q_EMIT wished(wanted);
    }
}

/// Asks for a range, kept in the hard range of the number, and whole where the number is.
void AxisRow::wishRange(SheetRange range) {
    if (number_) {
        const bool isWhole = infoOf(number_->type).isWhole;
        for (double* end : {&range.from, &range.to}) {
            *end = std::clamp(isWhole ? std::round(*end) : *end, number_->min, number_->max);
        }
    }
    SheetAxis axis = *axis_;
    axis.range = range;
    axis.entries.clear();
    wish(std::move(axis));
}

/// Asks for the axis with an entry or without it. The entries are in the order in which they are
/// listed, and there is always one of them.
void AxisRow::wishEntry(const std::string& entry, bool isOn) {
    SheetAxis axis = *axis_;
    axis.entries.clear();
    for (const SheetStep& each : listed_) {
        if (each.entry == entry ? isOn : isChosen(each.entry)) {
            axis.entries.push_back(each.entry);
        }
    }
    if (axis.entries.empty()) {
        axis.entries = {entry};
    }
    if (axis.entries.size() == listed_.size() && !number_) {
        axis.entries.clear(); // all there are, whatever comes
    }
    wish(std::move(axis));
}

/// Asks for an axis. Where that is nothing new, the widgets show again what was accepted.
void AxisRow::wish(SheetAxis axis) {
    if (axis == *axis_) {
        showRange();
        showEntries();
    } else {
        Q_EMIT wished(axis);
    }
}

void AxisRow::showRange() {
    if (axis_ && axis_->range) {
        from_->setValue(axis_->range->from);
        to_->setValue(axis_->range->to);
        count_->setValue(axis_->range->steps);
    }
}

void AxisRow::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const auto wanted = width() < wideEnough ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight;
    if (layout_->direction() != wanted) {
        layout_->setDirection(wanted);
    }
}

} // namespace patina
