// SPDX-License-Identifier: GPL-3.0-or-later
#include "lobe/solid_plot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QFontMetricsF>
#include <QImage>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>

#include <glm/geometric.hpp>

#include "core/color.h"
#include "lobe/lobe_subjects.h"
#include "text/as_text.h"
#include "text/display_number.h"
#include "text/mixed_color.h"

namespace patina {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double lobeRoom = 1.14; ///< is the room about the lobes, over their length
constexpr double degreesPerPixel = 0.5;
constexpr double degreesPerKey = 5.0;
constexpr double overlaidOpacity = 0.7;
constexpr double fineDevicePixels = 1.75; ///< a point, from which on edges need no smoothing

double largestOf(const std::vector<NamedSolid>& solids) {
    double largest = 0.0;
    for (const NamedSolid& each : solids) {
        for (const glm::dvec3& f : each.solid.f) {
            largest = std::max(largest, luminance(f));
        }
    }
    return largest;
}

/// Returns the hue of a reflectance at full strength.
QColor hueOf(const glm::dvec3& f) {
    const double max = std::max({f.x, f.y, f.z});
    const auto share = [max](double x) { return static_cast<float>(max > 0.0 ? x / max : 1.0); };
    return QColor::fromRgbF(share(f.x), share(f.y), share(f.z));
}

bool isGrey(const LobeSolid& solid) {
    constexpr double rounding = 1e-6;
    return std::ranges::all_of(solid.f, [](const glm::dvec3& f) {
        const double max = std::max({f.x, f.y, f.z});
        return max - std::min({f.x, f.y, f.z}) <= rounding * max;
    });
}

QColor shaded(const QColor& color, double share) {
    return QColor::fromRgbF(static_cast<float>(color.redF() * share),
                            static_cast<float>(color.greenF() * share),
                            static_cast<float>(color.blueF() * share), color.alphaF());
}

} // namespace

class SolidPlot::Projection {
  public:
    Projection(double turn, double tilt, const QSizeF& size)
        : eye_(std::cos(tilt) * std::cos(turn), std::cos(tilt) * std::sin(turn), std::sin(tilt)),
          right_(-std::sin(turn), std::cos(turn), 0.0), up_(glm::cross(eye_, right_)),
          pixels_(std::min(0.5 * size.width() / lobeRoom, size.height() / (lobeRoom + below()))),
          middle_(0.5 * size.width(), size.height() - below() * pixels_) {}

    QPointF at(const glm::dvec3& point) const {
        return {middle_.x() + pixels_ * glm::dot(point, right_),
                middle_.y() - pixels_ * glm::dot(point, up_)};
    }
    double depth(const glm::dvec3& point) const { return glm::dot(point, eye_); }
    const glm::dvec3& eye() const { return eye_; }

  private:
    /// Returns how much room the disc of the horizon takes below the middle.
    double below() const { return eye_.z + 0.12; }

    glm::dvec3 eye_;
    glm::dvec3 right_;
    glm::dvec3 up_;
    double pixels_;
    QPointF middle_;
};

SolidPlot::SolidPlot(QWidget* parent) : PaintedPlot(parent) {
    setObjectName("solidPlot");
    setAccessibleName(tr("Reflectance over all viewers"));
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::SizeAllCursor);
}

void SolidPlot::setScale(LobeScale scale) {
    scale_ = scale;
    draw();
}

void SolidPlot::setDetails(QStringList details) {
    details_ = std::move(details);
    draw();
}

void SolidPlot::setSolids(std::vector<NamedSolid> solids, const Incoming& light) {
    solids_ = std::move(solids);
    light_ = light;
    draw();
}

void SolidPlot::setViewer(const std::optional<glm::dvec3>& viewer) {
    viewer_ = viewer;
    draw();
}

QPointF SolidPlot::placeOf(const glm::dvec3& point) const {
    return Projection(turn_ * degree, tilt_ * degree, size()).at(point);
}

void SolidPlot::addFacets(std::vector<Facet>& all, std::size_t material, double largest,
                          const Projection& projection) const {
    const LobeSolid& solid = solids_[material].solid;
    if (solid.f.empty()) {
        return;
    }
    std::vector<glm::dvec3> points(solid.f.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i] = solid.directions[i] * lobeLength(scale_, luminance(solid.f[i]), largest);
    }
    const bool hasHue = solids_.size() == 1 && !isGrey(solid);
    const QColor own = lobeColor(material, palette());
    for (int ring = 0; ring < solid.fineness.rings; ++ring) {
        for (int segment = 0; segment < solid.fineness.segments; ++segment) {
            const std::size_t corners[] = {
                solid.place(ring, segment), solid.place(ring + 1, segment),
                solid.place(ring + 1, segment + 1), solid.place(ring, segment + 1)};
            const glm::dvec3 normal = glm::cross(points[corners[2]] - points[corners[0]],
                                                 points[corners[3]] - points[corners[1]]);
            const double area = glm::length(normal);
            if (!(area > 0.0)) {
                continue;
            }
            Facet facet;
            for (const std::size_t corner : corners) {
                facet.outline << projection.at(points[corner]);
                facet.depth += 0.25 * projection.depth(points[corner]);
            }
            const double facing = std::abs(glm::dot(normal, projection.eye())) / area;
            QColor color = hasHue ? hueOf(solid.f[corners[2]]) : own;
            color.setAlphaF(static_cast<float>(solids_.size() > 1 ? overlaidOpacity : 1.0));
            facet.color = shaded(color, 0.4 + 0.6 * facing);
            facet.material = material;
            facet.direction = corners[2];
            all.push_back(std::move(facet));
        }
    }
}

std::vector<SolidPlot::Facet> SolidPlot::facets(const Projection& projection) const {
    const double largest = largestOf(solids_);
    std::vector<Facet> all;
    for (std::size_t i = 0; i < solids_.size(); ++i) {
        addFacets(all, i, largest, projection);
    }
    std::ranges::sort(all, {}, &Facet::depth);
    return all;
}

void SolidPlot::drawFacets(QPainter& painter, const std::vector<Facet>& facets,
                           const QSizeF& size) {
    if (painter.paintEngine()->type() != QPaintEngine::Raster) {
        for (const Facet& facet : facets) {
            // The outline in the same colour closes the seams between facets.
            painter.setPen(QPen(facet.color, 0.6));
            painter.setBrush(facet.color);
            painter.drawPolygon(facet.outline);
        }
        return;
    }
    // Without antialiasing, facets that share an edge neither overlap nor leave a seam, and take a
    // fraction of the time. Pixels that are large are supersampled.
    const double pixels = painter.device()->devicePixelRatioF();
    const double samples = pixels < fineDevicePixels ? 2.0 * pixels : pixels;
    QImage image((size * samples).toSize(), QImage::Format_ARGB32_Premultiplied);
    image.setDevicePixelRatio(samples);
    image.fill(Qt::transparent);
    QPainter filler(&image);
    filler.setPen(Qt::NoPen);
    for (const Facet& facet : facets) {
        filler.setBrush(facet.color);
        filler.drawConvexPolygon(facet.outline);
    }
    filler.end();
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(QRectF({}, size), image);
}

void SolidPlot::paint(QPainter& painter, const QSizeF& size) const {
    const Projection projection(turn_ * degree, tilt_ * degree, size);
    const QColor base = palette().color(QPalette::Base);
    const QColor text = palette().color(QPalette::Text);
    painter.setRenderHint(QPainter::Antialiasing);
    QPolygonF horizon;
    for (int i = 0; i < 72; ++i) {
        const double angle = 5.0 * i * degree;
        horizon << projection.at({std::cos(angle), std::sin(angle), 0.0});
    }
    painter.setPen(mixed(base, text, 0.3));
    painter.setBrush(mixed(base, text, 0.06));
    painter.drawPolygon(horizon);
    drawFacets(painter, facets(projection), size);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(mixed(base, text, 0.6), 1.2, Qt::DashLine));
    const QPointF from = projection.at(light_.direction());
    painter.drawLine(from, projection.at({0.0, 0.0, 0.0}));
    const QString light = tr("light %1°").arg(roundText(light_.angle / degree));
    const QFontMetricsF metrics(font());
    const auto drawName = [&](const QPointF& place, const QString& name) {
        QPainterPath letters;
        letters.addText(place, font(), name);
        painter.strokePath(letters, QPen(base, 3.0)); // a lobe may lie below
        painter.fillPath(letters, mixed(base, text, 0.8));
    };
    drawName(from - QPointF(0.5 * metrics.horizontalAdvance(light), 4.0), light);
    if (viewer_) {
        drawName(projection.at(*viewer_) + QPointF(4.0, -4.0), tr("viewer"));
        painter.setPen(QPen(mixed(base, text, 0.7), 1.2, Qt::DotLine));
        painter.drawLine(projection.at({0.0, 0.0, 0.0}), projection.at(*viewer_));
    }
    double top = metrics.ascent() + 4.0;
    for (std::size_t i = 0; i < solids_.size() && solids_.size() > 1; ++i) {
        painter.setPen(lobeColor(i, palette()));
        const QString detail = details_.value(static_cast<qsizetype>(i));
        painter.drawText(QPointF(8.0, top),
                         asText(solids_[i].name) +
                             (solids_[i].solid.f.empty() ? tr(": no lobe") : QString()) +
                             (detail.isEmpty() ? QString() : tr(", %1").arg(detail)));
        top += metrics.lineSpacing();
    }
}

QString SolidPlot::readingAt(const QPointF& place) const {
    const std::vector<Facet> all = facets({turn_ * degree, tilt_ * degree, size()});
    const auto hit = std::find_if(all.rbegin(), all.rend(), [&place](const Facet& facet) {
        return facet.outline.containsPoint(place, Qt::OddEvenFill);
    });
    if (hit == all.rend()) {
        return {};
    }
    const glm::dvec3& v = solids_[hit->material].solid.directions[hit->direction];
    const double around = std::atan2(v.y, v.x) / degree;
    QStringList lines{tr("viewer %1° from the normal, %2° from the tangent")
                          .arg(roundText(std::acos(std::min(v.z, 1.0)) / degree),
                               roundText(around < 0.0 ? around + 360.0 : around))};
    for (const NamedSolid& each : solids_) {
        if (each.solid.f.empty()) {
            continue;
        }
        lines << tr("%1: %2 1/sr").arg(asText(each.name), valueText(each.solid.f[hit->direction]));
    }
    return lines.join('\n');
}

void SolidPlot::turnBy(double turn, double tilt) {
    turn_ = std::remainder(turn_ + turn, 360.0);
    tilt_ = std::clamp(tilt_ + tilt, 0.0, 90.0);
    draw();
}

void SolidPlot::mousePressEvent(QMouseEvent* event) {
    dragged_ = event->position();
}

void SolidPlot::mouseMoveEvent(QMouseEvent* event) {
    if (!event->buttons().testFlag(Qt::LeftButton)) {
        return PaintedPlot::mouseMoveEvent(event);
    }
    const QPointF moved = degreesPerPixel * (event->position() - dragged_);
    dragged_ = event->position();
    turnBy(-moved.x(), moved.y());
}

void SolidPlot::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Left:
        return turnBy(degreesPerKey, 0.0);
    case Qt::Key_Right:
        return turnBy(-degreesPerKey, 0.0);
    case Qt::Key_Up:
        return turnBy(0.0, degreesPerKey);
    case Qt::Key_Down:
        return turnBy(0.0, -degreesPerKey);
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace patina
