// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>

#include "lobe/painted_plot.h"
#include "measure/lobe/lobe_scale.h"
#include "measure/lobe/lobe_table.h"

namespace patina {

/// Draws reflectances over the angle of the half vector, to the right, and of the light from it,
/// upwards, as pictures beside each other: bright where much is reflected.
class SlicePlot final : public PaintedPlot {
    Q_OBJECT

  public:
    explicit SlicePlot(QWidget* parent = nullptr);

    void setScale(LobeScale scale);
    /// Takes slices of which one without cells keeps its place, and its colour.
    void setSlices(std::vector<NamedSlice> slices);
    const std::vector<NamedSlice>& slices() const { return slices_; }

    QString readingAt(const QPointF& place) const override;

    /// Returns the square of a material's slice in pixels of this widget.
    QRectF squareOf(std::size_t material) const { return squareOf(material, size()); }

  protected:
    void paint(QPainter& painter, const QSizeF& size) const override;
    QSize fileSize() const override; ///< is as high as the squares need

  private:
    QRectF squareOf(std::size_t material, const QSizeF& size) const;

    std::vector<NamedSlice> slices_;
    LobeScale scale_ = LobeScale::Linear;
};

} // namespace patina
