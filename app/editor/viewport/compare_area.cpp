// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/compare_area.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QSplitter>

#include "viewport/comparison_meter.h"
#include "viewport/comparison_readout.h"
#include "viewport/composed_view.h"
#include "viewport/difference_view.h"

namespace patina {
namespace {

constexpr double keyStep = 0.05; ///< of a mode's range
constexpr double keyTurn = 15.0; ///< degrees
constexpr int flipKey = Qt::Key_Space;

} // namespace

CompareArea::CompareArea(const ViewSources& sources, QWidget* parent)
    : QWidget(parent), sources_(sources), document_(sources.document), cameras_(document_),
      turntable_(document_), rows_(new QSplitter(Qt::Vertical, this)),
      upper_(new QSplitter(Qt::Horizontal, rows_)), lower_(new QSplitter(Qt::Horizontal, rows_)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(rows_);
    for (QSplitter* splitter : {rows_, upper_, lower_}) {
        splitter->setChildrenCollapsible(false);
        splitter->setHandleWidth(3);
    }
    lower_->hide();
    views_[0] = addView(Side::A);
    onChange(document_, DocumentChange::Comparing | DocumentChange::Scene, this,
             &CompareArea::showSides);
    showSides();
}

CompareArea::~CompareArea() = default;

std::vector<SideView*> CompareArea::views() {
    std::vector<SideView*> made;
    std::ranges::copy_if(views_, std::back_inserter(made), [](SideView* view) { return view; });
    return made;
}

SideView& CompareArea::active() {
    SideView* active = view(document_.selection().side());
    return active != nullptr ? *active : first();
}

void CompareArea::setMouseHabits(const MouseHabits& habits) {
    habits_ = habits;
    for (SideView* view : views()) {
        view->viewport().navigation().setHabits(habits);
    }
}

void CompareArea::setInspected(std::optional<Inspected> shown) {
    inspected_ = shown;
    for (SideView* view : views()) {
        view->setInspected(shown);
    }
}

SideView* CompareArea::addView(Side side) {
    auto* view = new SideView(sources_, {modes_, turntable_}, side, upper_);
    upper_->insertWidget(static_cast<int>(indexOf(side)), view);
    connect(&view->viewport(), &Viewport::resized, this, [this] {
        if (isComposed()) {
            placeComposed();
        }
    });
    view->viewport().navigation().setHabits(habits_);
    cameras_.add(*view);
    connect(view, &SideView::filesDropped, this,
            [this, side](const QStringList& files) { Q_EMIT filesDropped(files, side); });
    return view;
}

void CompareArea::setDifferenceWanted(bool wanted) {
    if (wanted != std::exchange(wantsDifference_, wanted)) {
        showSides();
        Q_EMIT differenceWantedChanged(wanted);
    }
}

void CompareArea::setLook(const CompareLook& look) {
    if (look == look_) {
        return;
    }
    const bool isOtherPlace = look.mode != look_.mode || look.arrangement != look_.arrangement;
    look_ = look;
    if (composed_) {
        composed_->setLook(look_);
    }
    if (isOtherPlace) {
        showSides();
    }
    Q_EMIT lookChanged(look_);
}

/// Modes of one picture are of A and B.
bool CompareArea::isShown(Side side) const {
    const bool isThere = indexOf(side) < document_.shownSides();
    if (!document_.isComparing() || look_.mode == CompareMode::SideBySide) {
        return isThere;
    }
    return look_.mode != CompareMode::Difference && side <= Side::B;
}

bool CompareArea::makeMissingViews() {
    bool isMade = false;
    for (const Side side : sides) {
        SideView*& made = views_[indexOf(side)];
        if (made != nullptr || indexOf(side) >= document_.shownSides()) {
            continue;
        }
        made = addView(side);
        made->setInspected(inspected_);
        if (meter_ == nullptr) {
            makeMeter();
        }
        watch(made->viewport());
        isMade = true;
        Q_EMIT viewAdded(made);
    }
    return isMade;
}

void CompareArea::showSides() {
    showFurtherSide();
    bool isMoved = makeMissingViews();
    const bool comparing = document_.isComparing();
    const bool isComposed = comparing && rowOf(look_.mode).isComposed();
    if (second() != nullptr) {
        showComposed(isComposed);
    }
    isMoved |= placeViews();
    for (const Side side : sides) {
        if (SideView* shown = view(side)) {
            shown->setTitleVisible(comparing && !isComposed);
            shown->setVisible(isShown(side));
        }
    }
    if (isMoved) {
        shareRoom();
    }
    showDifference(comparing && (wantsDifference_ || look_.mode == CompareMode::Difference));
    cameras_.fitNarrowViews();
}

/// Who asks for a third view wants to see it.
void CompareArea::showFurtherSide() {
    const std::size_t before = std::exchange(sideCount_, document_.shownSides());
    if (sideCount_ > std::max(before, indexOf(Side::C)) && look_.mode != CompareMode::SideBySide) {
        look_.mode = CompareMode::SideBySide;
        Q_EMIT lookChanged(look_);
    }
}

/// Puts every view into its row; the difference stays the last of the upper one. Tells whether
/// something stands elsewhere now.
bool CompareArea::placeViews() {
    const bool isGrid = look_.arrangement == ViewArrangement::Grid;
    const auto way = look_.arrangement == ViewArrangement::Column ? Qt::Vertical : Qt::Horizontal;
    const bool hasLower = isGrid && isShown(Side::C);
    bool isMoved = upper_->orientation() != way || lower_->isHidden() == hasLower;
    upper_->setOrientation(way);
    lower_->setVisible(hasLower);
    for (const Side side : sides) {
        SideView* placed = view(side);
        QSplitter* row = isGrid && side > Side::B ? lower_ : upper_;
        if (placed == nullptr || placed->parentWidget() == row ||
            (side == Side::B && isComposed())) {
            continue;
        }
        const std::size_t place = indexOf(side) - (row == lower_ ? indexOf(Side::C) : 0);
        row->insertWidget(static_cast<int>(place), placed);
        isMoved = true;
    }
    return isMoved;
}

/// Gives as much to each view, and none to what is hidden.
void CompareArea::shareRoom() {
    for (QSplitter* splitter : {rows_, upper_, lower_}) {
        QList<int> sizes;
        for (int i = 0; i < splitter->count(); ++i) {
            sizes << (splitter->widget(i)->isHidden() ? 0 : 1);
        }
        splitter->setSizes(sizes);
    }
}

void CompareArea::makeMeter() {
    meter_ = new ComparisonMeter(sources_, first().viewport(), this);
    readout_ = std::make_unique<ComparisonReadout>(document_, *meter_);
    connect(readout_.get(), &ComparisonReadout::changed, this, &CompareArea::numbersShown);
    watch(first().viewport());
}

void CompareArea::watch(Viewport& view) {
    readout_->watch(view, [&view] { return view.rect(); });
}

void CompareArea::showDifference(bool shown) {
    const bool was = difference_ && !difference_->isHidden();
    if (shown == was) {
        return;
    }
    if (!difference_) {
        difference_ = new DifferenceView(*meter_, first().viewport(), upper_);
        difference_->setMouseTracking(true);
        readout_->watch(*difference_, [this] { return difference_->place(); });
        upper_->addWidget(difference_);
    }
    difference_->setVisible(shown);
    shareRoom();
}

/// Side B's view then lies where side A's is, below it: it draws there as it does elsewhere.
void CompareArea::showComposed(bool shown) {
    if (shown == isComposed()) {
        return;
    }
    if (!composed_) {
        composed_ = new ComposedView(document_, sources_.switches, first(), *second(), this);
        composed_->setLook(look_);
        connect(composed_, &ComposedView::lookWished, this, &CompareArea::setLook);
    }
    if (shown) {
        second()->setParent(this);
        second()->lower();
        composed_->raise();
        layout()->activate();
        placeComposed();
    }
    for (SideView* view : {&first(), second()}) {
        view->viewport().frames().surface().setCovered(shown);
    }
    composed_->setVisible(shown);
}

bool CompareArea::isComposed() const {
    return composed_ && !composed_->isHidden();
}

void CompareArea::placeComposed() {
    const auto placeOf = [this](const QWidget& widget) {
        return QRect(widget.mapTo(this, QPoint()), widget.size());
    };
    second()->setGeometry(placeOf(first()));
    composed_->setGeometry(placeOf(first().viewport()));
}

void CompareArea::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (isComposed()) {
        layout()->activate();
        placeComposed();
    }
}

void CompareArea::keyPressEvent(QKeyEvent* event) {
    const QString text = event->text();
    if (!isComposed() && event->key() == Qt::Key_Space) {
        cameras_.reset(document_.selection().side());
    } else if (!isComposed()) {
        QWidget::keyPressEvent(event);
    } else if (event->key() == flipKey) {
        composed_->setFlipped(true);
    } else if (text == "[" || text == "]") {
        setLook(withAmount(look_, amountOf(look_) + (text == "[" ? -keyStep : keyStep)));
    } else if (look_.mode == CompareMode::Wipe && (text == "{" || text == "}")) {
        CompareLook turned = look_;
        turned.wipeAngle = wrappedAngle(look_.wipeAngle + (text == "{" ? -keyTurn : keyTurn));
        setLook(turned);
    } else {
        QWidget::keyPressEvent(event);
    }
}

void CompareArea::keyReleaseEvent(QKeyEvent* event) {
    if (isComposed() && event->key() == flipKey) {
        if (!event->isAutoRepeat()) {
            composed_->setFlipped(false);
        }
    } else {
        QWidget::keyReleaseEvent(event);
    }
}

} // namespace patina
