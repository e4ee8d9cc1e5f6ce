// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QImage>
#include <QTimer>

#include "viewport/difference_worker.h"
#include "viewport/side_view.h"

class QComboBox;
class QLabel;
class QSlider;

namespace patina {

/// C beside A and B: how far they are apart, pixel by pixel, seen from where A looks. It follows
/// what changes, some moments later.
class DifferenceView : public QFrame {
    Q_OBJECT

  public:
    /// `first` is side A's view, whose camera the mouse moves here, too.
    DifferenceView(const ViewSources& sources, Viewport& first, std::filesystem::path programCache,
                   QWidget* parent = nullptr);

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
    const FrameDifference* difference() const { return difference_.get(); }
    /// Says what the picture is of.
    QString caption() const;
    /// Returns what is shown, as a picture.
    const QImage& picture() const { return picture_; }
    /// Tells whether that is of A and B as they are now.
    bool isUpToDate() const;

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

  private:
    void layOut();
    void connectParts();
    void refreshSoon();
    void ask();
    void take(std::shared_ptr<const FrameDifference> difference, const QString& problem);
    void showPicture();
    QRect place() const;
    DifferenceWorker::Side sideOf(Side side);

    Document& document_;
    Viewport& first_;
    MeshLibrary& meshes_;
    TextureLibrary& textures_;
    EnvironmentLibrary& environments_;
    EffectSwitches& switches_;
    ProgramEffects& effects_;
    DifferenceWorker worker_;
    QTimer settle_; ///< changes are gathered
    std::shared_ptr<const FrameDifference> difference_;
    QString problem_;
    QImage picture_;
    QWidget* head_;
    QLabel* title_;
    QComboBox* mode_;
    QSlider* slider_;
    QLabel* number_;
};

} // namespace patina
