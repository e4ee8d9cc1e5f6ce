// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QImage>

#include "viewport/comparison_meter.h"

class QComboBox;
class QLabel;
class QSlider;

namespace patina {

/// Shows beside A and another side how far they are apart, pixel by pixel, seen from where A looks.
/// It follows what changes, some moments later.
class DifferenceView : public QFrame {
    Q_OBJECT

  public:
    /// `first` is side A's view, whose camera the mouse moves here, too.
    DifferenceView(ComparisonMeter& meter, Viewport& first, QWidget* parent = nullptr);

    enum class Mode {
        Difference, ///< |A - B| in linear light, times the gain
        Error       ///< of B against A, as the chart of what accuracy costs has it, as colours
    };
    Mode mode() const;
    void setMode(Mode mode);

    static constexpr double maxGain = 1000.0;
    double gain() const; ///< 1 .. maxGain
    void setGain(double gain);

    /// Returns what is shown, as it was measured; null before that.
    const FrameDifference* difference() const {
        return meter_.frames() ? &meter_.frames()->difference : nullptr;
    }
    /// Says what the picture is of.
    QString caption() const;
    /// Returns what is shown, as a picture.
    const QImage& picture() const { return picture_; }
    /// Tells whether that is of A and B as they are now.
    bool isUpToDate() const { return meter_.isUpToDate(); }
    /// Where it is within the view.
    QRect place() const;

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

  private:
    void layOut();
    void connectParts();
    void wishPicture();
    void showPicture();

    ComparisonMeter& meter_;
    Viewport& first_;
    QImage picture_;
    QWidget* head_;
    QLabel* title_;
    QComboBox* mode_;
    QSlider* slider_;
    QLabel* number_;
};

} // namespace patina
