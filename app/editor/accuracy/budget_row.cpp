// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/budget_row.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "accuracy/bound_box.h"
#include "accuracy/cost_text.h"
#include "docks/panel.h"
#include "text/as_text.h"

namespace patina {
namespace {

constexpr double usualMilliseconds = 2.0;
constexpr double usualShare = 1.0 / 255.0; ///< one step of 8 bits

/// Holds an image size that a budget can be given for, in pixels.
struct PictureSize {
    const char* name;
    int width;
    int height;
};
constexpr PictureSize sizes[] = {
    {"720p", 1280, 720}, {"1080p", 1920, 1080}, {"1440p", 2560, 1440}, {"2160p", 3840, 2160}};
constexpr int usualEntry = 1;

/// Writes the time of a picture that is `pictures` times as large as the measured one.
QString pictureTimeText(const ChoiceCost& cost, double pictures) {
    const QString time = digitsText(cost.milliseconds.median * pictures);
    return cost.belowNoise ? BudgetRow::tr("at most %1 ms").arg(time)
                           : BudgetRow::tr("%1 ms").arg(time);
}

} // namespace

BudgetRow::BudgetRow(QWidget* parent)
    : QWidget(parent), timed_(new QCheckBox(tr("At most"), this)),
      milliseconds_(new BoundBox(BoundBox::Of::Milliseconds, usualMilliseconds, this)),
      size_(new QComboBox(this)), on_(new QLabel(tr("on"), this)), card_(new QComboBox(this)),
      bounded_(new QCheckBox(tr("Error below"), this)),
      share_(new BoundBox(BoundBox::Of::Share, usualShare, this)),
      use_(textButton(tr("Use it"), tr("Take what the budget buys"), this)),
      text_(new QLabel(this)) {
    timed_->setToolTip(tr("The most accurate way that is fast enough"));
    milliseconds_->setObjectName("milliseconds");
    milliseconds_->setAccessibleName(tr("Milliseconds for a picture"));
    size_->setAccessibleName(tr("Size of the picture"));
    for (const PictureSize& size : sizes) {
        size_->addItem(QString::fromLatin1(size.name), size.width * size.height);
        size_->setItemData(size_->count() - 1,
                           tr("%1 × %2 pixels").arg(size.width).arg(size.height), Qt::ToolTipRole);
    }
    size_->setCurrentIndex(usualEntry);
    size_->setToolTip(tr("The picture's size, filled as the measured one is"));
    card_->setObjectName("card");
    card_->setAccessibleName(tr("Graphics card of the times"));
    card_->setToolTip(tr("Times as measured on this machine, or as predicted for a graphics card "
                         "that need not be here; errors are those measured"));
    card_->addItem(tr("this machine"));
    for (const CardOfFamily& each : graphicsCards()) {
        card_->addItem(asText(each.text()));
    }
    bounded_->setToolTip(tr("The fastest way of which 99 of 100 pixels are off by no more"));
    share_->setObjectName("share");
    share_->setAccessibleName(tr("Greatest relative error"));
    share_->setToolTip(tr("As a fraction, a number or percents: 1/255, 0.004, 0.4 %"));
    use_->setFocusPolicy(Qt::StrongFocus); // a click takes what is typed first
    text_->setObjectName("budget");
    text_->setWordWrap(true);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    layOut();
    connectParts();
    refresh();
}

void BudgetRow::layOut() {
    auto* fields = new QHBoxLayout;
    fields->setSpacing(4);
    for (QWidget* field : std::initializer_list<QWidget*>{timed_, milliseconds_}) {
        fields->addWidget(field);
    }
    fields->addWidget(new QLabel(tr("at"), this));
    fields->addWidget(size_);
    fields->addWidget(on_);
    fields->addWidget(card_);
    fields->addSpacing(10);
    fields->addWidget(bounded_);
    fields->addWidget(share_);
    fields->addSpacing(10);
    fields->addWidget(use_);
    fields->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(fields);
    layout->addWidget(text_);
}

void BudgetRow::connectParts() {
    const auto changed = [this] {
        refresh();
        if (answer_) {
            Q_EMIT answered(static_cast<int>(answer_->point));
        }
    };
    connect(timed_, &QCheckBox::toggled, this, changed);
    connect(bounded_, &QCheckBox::toggled, this, changed);
    connect(milliseconds_, &BoundBox::valueChanged, this, changed);
    connect(share_, &BoundBox::valueChanged, this, changed);
    connect(size_, &QComboBox::currentIndexChanged, this, changed);
    connect(card_, &QComboBox::currentIndexChanged, this, &BudgetRow::cardChosen);
    connect(use_, &QToolButton::clicked, this, [this] {
        if (answer_) {
            Q_EMIT wished(static_cast<int>(answer_->point));
        }
    });
}

std::optional<CardOfFamily> BudgetRow::card() const {
    const int chosen = card_->currentIndex() - 1; // the first entry is this machine
    return chosen < 0 ? std::nullopt
                      : std::optional(graphicsCards()[static_cast<std::size_t>(chosen)]);
}

void BudgetRow::hideCards() {
    on_->hide();
    card_->hide();
}

void BudgetRow::setChart(const CostChart& chart, bool stale) {
    chart_ = chart;
    stale_ = stale;
    refresh();
}

/// Returns the wanted number of pixels as a multiple of the measured picture's.
double BudgetRow::pictures() const {
    const double measured = double(chart_.size.x) * double(chart_.size.y);
    return measured > 0.0 ? size_->currentData().toDouble() / measured : 1.0;
}

/// Returns the budget in milliseconds of the measured picture, not of the wanted size.
CostBudget BudgetRow::budget() const {
    CostBudget budget;
    if (timed_->isChecked()) {
        budget.milliseconds = milliseconds_->value() / pictures();
    }
    if (bounded_->isChecked()) {
        budget.error = share_->value();
    }
    return budget;
}

void BudgetRow::refresh() {
    milliseconds_->setEnabled(timed_->isChecked());
    size_->setEnabled(timed_->isChecked());
    share_->setEnabled(bounded_->isChecked());
    const bool asked = timed_->isChecked() || bounded_->isChecked();
    answer_ = asked ? bestFor(budget(), chart_.points) : std::nullopt;
    use_->setEnabled(answer_.has_value() && !stale_);
    text_->setVisible(asked);
    text_->setText(answer_ ? answerText(chart_.points[answer_->point], answer_->fits)
                           : tr("Measure first: then the budget picks a way."));
}

/// Says what the point takes, and what is given up compared with the exact one.
QString BudgetRow::answerText(const CostPoint& point, bool fits) const {
    const CostPoint& exact = chart_.points.front();
    const QString time = pictureTimeText(point.cost, pictures());
    const QString exactTime = pictureTimeText(exact.cost, pictures());
    const QString name = fits ? settingName(point, chart_)
                              : tr("Nothing fits. Nearest: %1").arg(settingName(point, chart_));
    if (point.isExact()) {
        return tr("%1, %2 a picture. It gives up nothing.").arg(name, time);
    }
    return tr("%1, %2 a picture instead of %3. It gives up: 99 of 100 pixels are off by up to %4, "
              "and %5 of all differ on the screen.")
        .arg(name, time, exactTime, shareText(point.error.p99), shareText(point.error.stepShare));
}

} // namespace patina
