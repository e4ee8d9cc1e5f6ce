// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/compare_area.h"

#include <algorithm>
#include <utility>

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QSplitter>

#include "viewport/camera_moves.h"
#include "viewport/comparison_meter.h"
#include "viewport/comparison_text.h"
#include "viewport/composed_view.h"
#include "viewport/difference_view.h"

namespace patina {
namespace {

constexpr double keyStep = 0.05; ///< of a mode's range
constexpr double keyTurn = 15.0; ///< degrees
constexpr int flipKey = Qt::Key_Space;

} // namespace

CompareArea::CompareArea(const ViewSources& sources, std::filesystem::path programCache,
                         QWidget* parent)
    : QWidget(parent), sources_(sources), document_(sources.document),
      programCache_(std::move(programCache)), home_(document_.scene().camera),
      row_(new QSplitter(Qt::Horizontal, this)), first_(addView(Side::A)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(row_);
    row_->setChildrenCollapsible(false);
    row_->setHandleWidth(3);
    onChange(document_, DocumentChange::Comparing, this, &CompareArea::showSides);
    onChange(document_, DocumentChange::Camera, this, &CompareArea::showCamera);
    onChange(document_, DocumentChange::Scene, this, [this] {
        home_ = document_.scene().camera;
        showSides();
        showCamera();
        realignCameras();
    });
    showSides();
}

SideView& CompareArea::active() {
    return document_.activeSide() == Side::B && second_ ? *second_ : *first_;
}

void CompareArea::setCamerasLinked(bool linked) {
    if (linked != linked_) {
        linked_ = linked;
        if (linked) {
            realignCameras();
        }
        Q_EMIT linkChanged(linked);
    }
}

void CompareArea::setInspecting(bool on) {
    inspecting_ = on;
    first_->setInspecting(on);
    if (second_) {
        second_->setInspecting(on);
    }
}

void CompareArea::realignCameras() {
    if (second_) {
        second_->viewport().setCamera(first_->viewport().camera());
    }
}

void CompareArea::resetCamera(Side side) {
    moveCamera(side, shownFrom(home_));
}

SideView* CompareArea::addView(Side side) {
    auto* view = new SideView(sources_, side, programCache_, row_);
    row_->addWidget(view);
    connect(view, &SideView::cameraWished, this,
            [this, side](const Camera& shown) { moveCamera(side, shown); });
    connect(&view->viewport(), &Viewport::resized, this, [this] {
        if (isComposed()) {
            placeComposed();
        }
        fitNarrowViews();
    });
    connect(view, &SideView::resetWished, this, [this, side] { resetCamera(side); });
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
    const bool isOtherMode = look.mode != look_.mode;
    look_ = look;
    if (composed_) {
        composed_->setLook(look_);
    }
    if (isOtherMode) {
        showSides();
    }
    Q_EMIT lookChanged(look_);
}

void CompareArea::showSides() {
    const bool comparing = document_.isComparing();
    if (comparing && !second_) {
        second_ = addView(Side::B);
        second_->viewport().setCamera(first_->viewport().camera());
        second_->setInspecting(inspecting_);
        row_->setSizes({1, 1});
        Q_EMIT viewAdded(second_);
        makeMeter();
    }
    const bool isComposed = comparing && rowOf(look_.mode).isComposed();
    const bool isDifferenceAlone = comparing && look_.mode == CompareMode::Difference;
    first_->setTitleVisible(comparing && !isComposed);
    first_->setVisible(!isDifferenceAlone);
    if (second_) {
        showComposed(isComposed);
        second_->setVisible(comparing && !isDifferenceAlone);
    }
    showDifference(comparing && (wantsDifference_ || isDifferenceAlone));
    fitNarrowViews();
}

void CompareArea::makeMeter() {
    meter_ = new ComparisonMeter(sources_, first_->viewport(), programCache_, this);
    connect(meter_, &ComparisonMeter::framesChanged, this, &CompareArea::showNumbers);
    connect(meter_, &ComparisonMeter::numbersChanged, this, &CompareArea::showNumbers);
    for (SideView* view : {first_, second_}) {
        view->viewport().installEventFilter(this);
    }
}

void CompareArea::showNumbers() {
    const bool isPixelKnown = pointer_ && meter_->isUpToDate() && document_.isComparing();
    Q_EMIT numbersShown(isPixelKnown ? pixelText(*meter_->frames(), *pointer_)
                                     : comparisonText(meter_->numbers()),
                        comparisonDetails(meter_->numbers()));
}

/// Follows the pointer over the pictures.
bool CompareArea::eventFilter(QObject* watched, QEvent* event) {
    const bool isOver = event->type() == QEvent::MouseMove;
    if (isOver || event->type() == QEvent::Leave) {
        const QRect place =
            watched == difference_ ? difference_->place() : static_cast<QWidget*>(watched)->rect();
        pointer_.reset();
        if (isOver && !place.isEmpty()) {
            const QPointF at =
                static_cast<QMouseEvent*>(event)->position() - QPointF(place.topLeft());
            pointer_ = QPointF(at.x() / place.width(), at.y() / place.height());
        }
        showNumbers();
    }
    return QWidget::eventFilter(watched, event);
}

void CompareArea::showDifference(bool shown) {
    const bool was = difference_ && !difference_->isHidden();
    if (shown == was) {
        return;
    }
    if (!difference_) {
        difference_ = new DifferenceView(*meter_, first_->viewport(), row_);
        difference_->setMouseTracking(true);
        difference_->installEventFilter(this);
        row_->addWidget(difference_);
    }
    difference_->setVisible(shown);
    row_->setSizes({1, 1, shown ? 1 : 0});
}

/// Side B's view then lies where side A's is, below it: it draws there as it does elsewhere.
void CompareArea::showComposed(bool shown) {
    const bool was = composed_ && !composed_->isHidden();
    if (shown == was) {
        return;
    }
    if (!composed_) {
        composed_ = new ComposedView(document_, *first_, *second_, this);
        composed_->setLook(look_);
        connect(composed_, &ComposedView::lookWished, this, &CompareArea::setLook);
    }
    second_->setTitleVisible(!shown);
    if (shown) {
        second_->setParent(this);
        second_->lower();
        composed_->raise();
        layout()->activate();
        placeComposed();
    } else {
        row_->insertWidget(1, second_);
        row_->setSizes({1, 1, difference_ && !difference_->isHidden() ? 1 : 0});
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
    second_->setGeometry(placeOf(*first_));
    composed_->setGeometry(placeOf(first_->viewport()));
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
    if (!isComposed()) {
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

/// The field of view is the height's: where a view is narrower than high all step back, so that
/// what is in a square is not cut off. The document's camera stays where it is.
void CompareArea::fitNarrowViews() {
    double aspect = 1.0; // of the narrowest
    for (SideView* view : {first_, second_}) {
        if (view && !view->isHidden()) {
            const QSize size = view->viewport().size();
            aspect = std::min(aspect, std::max(size.width(), 1) / double(size.height()));
        }
    }
    const double stepBack = 1.0 / aspect;
    const double change = stepBack / std::exchange(stepBack_, stepBack);
    if (change != 1.0 && second_ && !linked_) {
        second_->viewport().setCamera(dollied(second_->viewport().camera(), change));
    }
    if (change != 1.0) {
        showCamera();
    }
}

Camera CompareArea::shownFrom(const Camera& camera) const {
    return stepBack_ == 1.0 ? camera : dollied(camera, stepBack_);
}

/// The document's camera in the views that follow it.
void CompareArea::showCamera() {
    const Camera shown = shownFrom(document_.scene().camera);
    first_->viewport().setCamera(shown);
    if (second_ && linked_) {
        second_->viewport().setCamera(shown);
    }
}

/// To where a view shall show the scene from.
void CompareArea::moveCamera(Side side, const Camera& shown) {
    if (side == Side::B && !linked_) {
        second_->viewport().setCamera(shown);
        return;
    }
    document_.setCamera(stepBack_ == 1.0 ? shown : dollied(shown, 1.0 / stepBack_));
    showCamera();
}

} // namespace patina
