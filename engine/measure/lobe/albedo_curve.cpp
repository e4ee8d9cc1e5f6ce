// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/lobe/albedo_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <glm/common.hpp>

#include "core/vectors.h"
#include "measure/error/parallel.h"

namespace patina {
namespace {

/// Is the radius, in radians, from which on rings are spread by their logarithm.
constexpr double innermost = 1e-5;

double radiusOf(double u) {
    return innermost * std::sinh(u);
}

/// Integrates over rings about the mirror direction r: a viewer is cos(rho) r + sin(rho) (cos(psi)
/// e + sin(psi) b), with e towards the normal and b across the plane of incidence.
class Rings {
  public:
    Rings(const LobeModel& model, const Incoming& incoming, const IntegralAim& aim,
          const std::function<bool()>& isWanted)
        : model_(model), isWanted_(isWanted), light_(incoming.direction()),
          mirror_(incoming.across(incoming.angle)), angle_(incoming.angle), aim_(aim) {
        const double turn = incoming.azimuth;
        towardsNormal_ = {std::cos(angle_) * std::cos(turn), std::cos(angle_) * std::sin(turn),
                          std::sin(angle_)};
        across_ = {-std::sin(turn), std::cos(turn), 0.0};
    }

    Integral integral() {
        // A ring meets the horizon from pi/2 - angle on, and is below it from pi/2 +
        // angle on.
        const double touching = std::asinh((std::numbers::pi / 2.0 - angle_) / innermost);
        const double last = std::asinh((std::numbers::pi / 2.0 + angle_) / innermost);
        std::vector<double> ends{0.0};
        if (aim_.isSketch) {
            // Most light is in the outer rings; each factor of e is 1 of u.
            for (const double fromTouching : {6.0, 3.5, 2.0, 1.0}) {
                ends.push_back(std::max(touching - fromTouching, 0.0));
            }
        } else {
            for (const double share : {0.25, 0.5, 0.75}) {
                ends.push_back(share * touching);
            }
        }
        ends.push_back(touching);
        const int beyond = aim_.isSketch ? 4 : 2;
        for (int i = 1; i <= beyond; ++i) {
            ends.push_back(touching + (last - touching) * i / beyond);
        }
        range_ = last;
        Integral whole = adaptiveIntegral([this](double u) { return ring(u); }, ends, aim_);
        whole.uncertainty += uncertainty_;
        return whole;
    }

  private:
    glm::dvec3 ring(double u) {
        if (!isWanted_()) {
            return glm::dvec3(0.0); // so that the end is near
        }
        const double rho = radiusOf(u);
        const double s = std::sin(rho);
        const double c = std::cos(rho);
        const double weight = s * innermost * std::cosh(u);
        const double horizon = horizonOf(s, c);
        const auto integrand = [&](double psi) {
            const glm::dvec3 v =
                c * mirror_ + s * (std::cos(psi) * towardsNormal_ + std::sin(psi) * across_);
            return v.z > 0.0 ? model_.reflectance(light_, v) * (v.z * weight) : glm::dvec3(0.0);
        };
        const double firstEnd = aim_.isSketch ? 0.5 * horizon : horizon;
        const std::array<double, 4> ends =
            model_.isIsotropic()
                ? std::array<double, 4>{0.0, firstEnd, horizon, horizon}
                : std::array<double, 4>{-horizon, -0.3 * horizon, 0.3 * horizon, horizon};
        const double share = model_.isIsotropic() ? 2.0 : 1.0;
        // A tenth of the whole for all rings, the rest for what is between them.
        const IntegralAim aim{0.1 * aim_.tolerance / (share * range_), aim_.ringPanels,
                              aim_.ringPanels, aim_.isSketch};
        const Integral part = adaptiveIntegral(integrand, ends, aim);
        if (part.uncertainty > aim.tolerance) {
            uncertainty_ = std::max(uncertainty_, share * part.uncertainty * range_);
        }
        return share * part.value;
    }

    /// Returns the largest psi at which a ring is above the surface.
    double horizonOf(double sinRho, double cosRho) const {
        const double below = -cosRho * std::cos(angle_);
        const double reach = sinRho * std::sin(angle_);
        if (below <= -reach) {
            return std::numbers::pi;
        }
        return below >= reach ? 0.0 : std::acos(std::clamp(below / reach, -1.0, 1.0));
    }

    const LobeModel& model_;
    const std::function<bool()>& isWanted_;
    glm::dvec3 light_;
    glm::dvec3 mirror_;
    glm::dvec3 towardsNormal_{0.0};
    glm::dvec3 across_{0.0};
    double angle_ = 0.0;
    IntegralAim aim_;
    double range_ = 1.0;
    double uncertainty_ = 0.0; ///< is the worst of a ring that did not reach its aim
};

/// Is the integral of a straight line's albedo over the share of the sky between two angles.
glm::dvec3 skyPart(const AlbedoPoint& a, const AlbedoPoint& b) {
    const double from = std::sin(a.angle);
    const double to = std::sin(b.angle);
    return 0.5 * (a.albedo + b.albedo) * (to * to - from * from);
}

} // namespace

AlbedoPoint directionalAlbedo(const LobeModel& model, const Incoming& incoming,
                              const IntegralAim& aim, const std::function<bool()>& isWanted) {
    Incoming lit = incoming;
    lit.angle = std::clamp(incoming.angle, 0.0, maxIncoming);
    const Integral integral = Rings(model, lit, aim, isWanted).integral();
    return {lit.angle, isFinite(integral.value) ? integral.value : glm::dvec3(0.0),
            integral.uncertainty};
}

std::vector<double> albedoAngles(double stepDegrees) {
    std::vector<double> angles;
    constexpr double evenUpTo = 85.0;
    const int steps = std::max(static_cast<int>(std::lround(evenUpTo / stepDegrees)), 1);
    for (int i = 0; i <= steps; ++i) {
        angles.push_back(evenUpTo * i / steps * std::numbers::pi / 180.0);
    }
    for (const double degrees : {86.5, 88.0, 89.0, 89.5}) {
        angles.push_back(degrees * std::numbers::pi / 180.0);
    }
    angles.push_back(maxIncoming);
    return angles;
}

std::vector<AlbedoPoint> albedoCurve(const LobeModel& model, double azimuth,
                                     std::span<const double> angles, const IntegralAim& aim,
                                     const std::function<bool()>& isWanted) {
    std::vector<std::optional<AlbedoPoint>> found(angles.size());
    // Neighbours take about as long as each other, so each core takes every other angle.
    inParallel(angles.size(), [&](std::size_t part, std::size_t, std::size_t) {
        for (std::size_t i = part; i < angles.size() && isWanted(); i += parallelParts()) {
            const AlbedoPoint point = directionalAlbedo(model, {angles[i], azimuth}, aim, isWanted);
            if (isWanted()) {
                found[i] = point;
            }
        }
    });
    std::vector<AlbedoPoint> curve;
    for (std::size_t i = 0; i < found.size() && found[i]; ++i) {
        curve.push_back(*found[i]);
    }
    return curve;
}

EnergyRange energyRange(std::span<const AlbedoPoint> curve) {
    EnergyRange range{curve.front().albedo, glm::dvec3(0.0), curve.front().albedo};
    double sky = 0.0;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        range.min = glm::min(range.min, curve[i].albedo);
        range.max = glm::max(range.max, curve[i].albedo);
        if (i > 0) {
            range.mean += skyPart(curve[i - 1], curve[i]);
            const double from = std::sin(curve[i - 1].angle);
            const double to = std::sin(curve[i].angle);
            sky += to * to - from * from;
        }
    }
    range.mean /= std::max(sky, 1e-300);
    return range;
}

} // namespace patina
