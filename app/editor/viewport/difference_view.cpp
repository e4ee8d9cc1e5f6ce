// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/difference_view.h"

#include <algorithm>
#include <cmath>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QSlider>

#include "text/display_number.h"

namespace patina {
namespace {

constexpr int stepsPerDecade = 20; ///< steps of the slider while the gain grows tenfold
constexpr double usualGain = 10.0;
constexpr QSize minSize{160, 120};

int stepOf(double gain) {
    return static_cast<int>(std::lround(stepsPerDecade * std::log10(gain)));
}

QString gainText(double gain) {
    return QStringLiteral("× %1").arg(roundText(gain));
}

} // namespace

DifferenceView::DifferenceView(ComparisonMeter& meter, Viewport& first, QWidget* parent)
    : QFrame(parent), meter_(meter), first_(first), head_(new QWidget(this)),
      title_(new QLabel(head_)), mode_(new QComboBox(head_)),
      slider_(new QSlider(Qt::Horizontal, head_)), number_(new QLabel(head_)) {
    setMinimumSize(minSize);
    setFocusPolicy(Qt::ClickFocus); // the keys of the views work here, too
    setAccessibleName(tr("The difference of the views"));
    layOut();
    connectParts();
    setGain(usualGain);
    showPicture();
}

void DifferenceView::layOut() {
    title_->setText(QStringLiteral("<b>&nbsp;\u0394&nbsp;</b>"));
    mode_->addItem(tr("Difference"));
    mode_->setItemData(0, tr("How far A and B are apart in linear light, times the gain"),
                       Qt::ToolTipRole);
    mode_->addItem(tr("Error"));
    mode_->setItemData(1,
                       tr("How wrong B is beside A, relative to A's light: black a millionth or "
                          "less, violet, red, orange and yellow ten times more each, white all of "
                          "it"),
                       Qt::ToolTipRole);
    mode_->setAccessibleName(tr("What of the difference is shown"));
    mode_->setMinimumContentsLength(5);
    slider_->setRange(0, stepOf(maxGain));
    slider_->setPageStep(stepsPerDecade);
    slider_->setMinimumWidth(40);
    slider_->setAccessibleName(tr("Gain of the difference"));
    slider_->setToolTip(tr("The difference is shown so many times brighter"));
    number_->setMinimumWidth(fontMetrics().horizontalAdvance(gainText(maxGain)));
    auto* row = new QHBoxLayout(head_);
    row->setContentsMargins(4, 1, 6, 1);
    row->setSpacing(6);
    row->addWidget(title_);
    row->addWidget(mode_);
    row->addWidget(slider_, 1);
    row->addWidget(number_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(2, 2, 2, 2);
    layout->setSpacing(0);
    layout->addWidget(head_);
    layout->addStretch(1);
}

void DifferenceView::connectParts() {
    connect(slider_, &QSlider::valueChanged, this, &DifferenceView::showPicture);
    connect(mode_, &QComboBox::currentIndexChanged, this, &DifferenceView::showPicture);
    connect(&meter_, &ComparisonMeter::framesChanged, this, &DifferenceView::showPicture);
}

DifferenceView::Mode DifferenceView::mode() const {
    return mode_->currentIndex() == 0 ? Mode::Difference : Mode::Error;
}

void DifferenceView::setMode(Mode mode) {
    mode_->setCurrentIndex(mode == Mode::Difference ? 0 : 1);
}

QString DifferenceView::caption() const {
    return mode_->currentText() + (mode() == Mode::Difference ? ' ' + gainText(gain()) : QString());
}

double DifferenceView::gain() const {
    return std::pow(10.0, double(slider_->value()) / stepsPerDecade);
}

void DifferenceView::setGain(double gain) {
    slider_->setValue(stepOf(std::clamp(gain, 1.0, maxGain)));
}

void DifferenceView::wishPicture() {
    meter_.setPictureSize(isVisible() ? place().size() * devicePixelRatioF() : QSize());
}

void DifferenceView::showPicture() {
    const bool isDifference = mode() == Mode::Difference;
    slider_->setEnabled(isDifference);
    number_->setText(isDifference ? gainText(gain()) : QString());
    picture_ = {};
    if (const FrameDifference* apart = difference()) {
        const std::vector<unsigned char> bytes =
            isDifference ? shownDifference(*apart, gain()) : shownErrors(*apart);
        const glm::ivec2 size = apart->size;
        picture_ = QImage(bytes.data(), size.x, size.y, 3 * size.x, QImage::Format_RGB888).copy();
    }
    update();
}

QRect DifferenceView::place() const {
    return contentsRect().adjusted(2, 2 + head_->height(), -2, -2);
}

void DifferenceView::paintEvent(QPaintEvent* event) {
    QFrame::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (!picture_.isNull()) {
        painter.drawImage(place(), picture_);
        return;
    }
    painter.fillRect(place(), Qt::black);
    painter.setPen(Qt::lightGray);
    painter.drawText(place(), Qt::AlignCenter | Qt::TextWordWrap,
                     meter_.problem().isEmpty() ? tr("Drawing the difference …")
                                                : meter_.problem());
}

void DifferenceView::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    wishPicture();
}

void DifferenceView::showEvent(QShowEvent* event) {
    QFrame::showEvent(event);
    wishPicture();
}

void DifferenceView::hideEvent(QHideEvent* event) {
    QFrame::hideEvent(event);
    wishPicture();
}

void DifferenceView::mousePressEvent(QMouseEvent* event) {
    first_.navigation().press(*event);
}

void DifferenceView::mouseMoveEvent(QMouseEvent* event) {
    first_.navigation().move(*event);
}

void DifferenceView::mouseReleaseEvent(QMouseEvent* event) {
    first_.navigation().release(*event);
}

void DifferenceView::wheelEvent(QWheelEvent* event) {
    first_.navigation().wheel(*event);
    event->accept();
}

} // namespace patina
