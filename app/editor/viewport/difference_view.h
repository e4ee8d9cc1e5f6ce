// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QImage>

#include "viewport/comparison_meter.h"

class QComboBox;
class QLabel;
class QSlider;

namespace patina {

/// Shows pixel by pixel how far A is from another side, seen by A's camera, in a frame beside their
/// views. It follows changes a moment later.
class DifferenceView : public QFrame {
    Q_OBJECT

  public:
    /// `first` is side A's view; the mouse moves its camera here, too.
    DifferenceView(ComparisonMeter& meter, Viewport& first, QWidget* parent = nullptr);

    enum class Mode {
        Difference, ///< shows |A - B| in linear light, times the gain
        Error       ///< shows B's error relative to A in the colours of the accuracy chart
    };
    Mode mode() const;
    void setMode(Mode mode);

    static constexpr double maxGain = 1000.0;
    double gain() const; ///< 1 .. maxGain
    void setGain(double gain);

    /// Returns the difference as it was measured; null where there are no frames.
    const FrameDifference* difference() const {
        return meter_.frames() ? &meter_.frames()->difference : nullptr;
    }
    /// Returns the mode, and the gain where it applies.
    QString caption() const;
    /// Returns what is shown; null where nothing was measured.
    const QImage& picture() const { return picture_; }
    /// Tells whether the picture shows A and B as they are now.
    bool isUpToDate() const { return meter_.isUpToDate(); }
    /// Returns where the picture lies in this widget, in its coordinates.
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
