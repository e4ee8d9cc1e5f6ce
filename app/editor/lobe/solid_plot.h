// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QPolygonF>
#include <QStringList>

#include "lobe/painted_plot.h"
#include "measure/lobe/lobe_scale.h"
#include "measure/lobe/lobe_table.h"

namespace patina {

/// Draws reflectances over all viewers as surfaces, which a drag turns, as do the arrow keys. The
/// distance of a surface from the middle is the reflectance.
class SolidPlot final : public PaintedPlot {
    Q_OBJECT

  public:
    explicit SolidPlot(QWidget* parent = nullptr);

    void setScale(LobeScale scale);

    /// Takes lobes that have the same directions; one without any keeps its place, and its colour.
    void setSolids(std::vector<NamedSolid> solids, const Incoming& light);
    const std::vector<NamedSolid>& solids() const { return solids_; }

    /// Takes what is written behind the name of each material; nothing without an entry.
    void setDetails(QStringList details);

    /// Marks the direction of a viewer, unit; none without one.
    void setViewer(const std::optional<glm::dvec3>& viewer);

    QString readingAt(const QPointF& place) const override;

    double turn() const { return turn_; } ///< degrees about the normal
    double tilt() const { return tilt_; } ///< degrees of the eye above the surface

    /// Returns where a point of the lobes' room is drawn, in pixels of this widget; the normal is
    /// +z, and 1 the length of what is reflected most.
    QPointF placeOf(const glm::dvec3& point) const;

  protected:
    void paint(QPainter& painter, const QSizeF& size) const override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    /// Shows the lobes' room on a rectangle from the eye's side.
    class Projection;

    /// Is a piece of a surface on the picture.
    struct Facet {
        QPolygonF outline;
        QColor color;
        double depth = 0.0; ///< is larger nearer to the eye
        std::size_t material = 0;
        std::size_t direction = 0; ///< is one of its corners
    };

    /// Returns the pieces of all surfaces, the farthest first.
    std::vector<Facet> facets(const Projection& projection) const;
    static void drawFacets(QPainter& painter, const std::vector<Facet>& facets, const QSizeF& size);
    void addFacets(std::vector<Facet>& all, std::size_t material, double largest,
                   const Projection& projection) const;
    void turnBy(double turn, double tilt);

    std::vector<NamedSolid> solids_;
    QStringList details_;
    Incoming light_;
    std::optional<glm::dvec3> viewer_;
    LobeScale scale_ = LobeScale::Linear;
    double turn_ = 65.0;
    double tilt_ = 22.0;
    QPointF dragged_;
};

} // namespace patina
