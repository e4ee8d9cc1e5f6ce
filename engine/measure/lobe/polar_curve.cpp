// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/lobe/polar_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>

namespace patina {
namespace {

constexpr double rightAngle = std::numbers::pi / 2.0;

/// Is half of the least distance between points, in radians: a lobe as narrow as that of an
/// exponent of 1e9 is some of them wide.
constexpr double narrowestStep = 1e-6;

/// Lists distances from the mirror direction and from the light at which a narrow lobe is looked
/// for, in radians.
constexpr double looks[] = {0.0, 1e-5, 1e-4, 5e-4, 2e-3, 5e-3, 1e-2};

double largestOf(const glm::dvec3& v) {
    return std::max({v.x, v.y, v.z});
}

class PolarPoints {
  public:
    PolarPoints(const DirectionsValue& value, const Incoming& incoming,
                const CurveFineness& fineness)
        : value_(value), incoming_(incoming), light_(incoming.direction()), fineness_(fineness) {}

    std::vector<LobePoint> points() {
        const std::vector<double> starts = startingAngles();
        std::vector<LobePoint> all;
        all.push_back(at(starts.front()));
        for (std::size_t i = 1; i < starts.size(); ++i) {
            all.push_back(at(starts[i]));
        }
        std::size_t added = 1;
        while (added > 0 && all.size() < fineness_.points) {
            const std::size_t before = all.size();
            all = refined(all);
            added = all.size() - before;
        }
        return all;
    }

  private:
    LobePoint at(double angle) const { return {angle, value_(light_, incoming_.across(angle))}; }

    std::vector<double> startingAngles() const {
        std::vector<double> angles;
        for (int i = 0; i <= fineness_.steps; ++i) {
            angles.push_back(rightAngle * (2.0 * i / fineness_.steps - 1.0));
        }
        for (const double center : {incoming_.angle, -incoming_.angle}) {
            for (const double look : looks) {
                angles.push_back(center - look);
                angles.push_back(center + look);
            }
        }
        std::erase_if(angles, [](double angle) { return std::abs(angle) > rightAngle; });
        std::ranges::sort(angles);
        angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
        return angles;
    }

    /// Halves each step whose middle is off the line between its ends.
    std::vector<LobePoint> refined(const std::vector<LobePoint>& points) const {
        double peak = 0.0;
        for (const LobePoint& point : points) {
            peak = std::max(peak, largestOf(point.f));
        }
        std::vector<LobePoint> finer{points.front()};
        for (std::size_t i = 1; i < points.size(); ++i) {
            const LobePoint& left = points[i - 1];
            const LobePoint& right = points[i];
            const bool isRoom = finer.size() + (points.size() - i) < fineness_.points;
            if (isRoom && right.angle - left.angle > 2.0 * narrowestStep &&
                bends(left, right, peak)) {
                finer.push_back(at(0.5 * (left.angle + right.angle)));
            }
            finer.push_back(right);
        }
        return finer;
    }

    bool bends(const LobePoint& left, const LobePoint& right, double peak) const {
        const double limit = fineness_.tolerance * peak;
        if (largestOf(glm::abs(right.f - left.f)) <= limit) {
            return false;
        }
        const LobePoint middle = at(0.5 * (left.angle + right.angle));
        return largestOf(glm::abs(middle.f - 0.5 * (left.f + right.f))) > limit;
    }

    const DirectionsValue& value_;
    Incoming incoming_;
    glm::dvec3 light_;
    CurveFineness fineness_;
};

} // namespace

glm::dvec3 Incoming::direction() const {
    return across(-angle);
}

glm::dvec3 Incoming::across(double angleFromNormal) const {
    const double s = -std::sin(angleFromNormal);
    return {s * std::cos(azimuth), s * std::sin(azimuth), std::max(std::cos(angleFromNormal), 0.0)};
}

std::vector<LobePoint> polarCurve(const DirectionsValue& value, const Incoming& incoming,
                                  const CurveFineness& fineness) {
    Incoming lit = incoming;
    lit.angle = std::clamp(incoming.angle, 0.0, maxIncoming);
    return PolarPoints(value, lit, fineness).points();
}

std::vector<LobePoint> polarCurve(const LobeModel& model, const Incoming& incoming,
                                  const CurveFineness& fineness) {
    const DirectionsValue value = [&model](const glm::dvec3& l, const glm::dvec3& v) {
        return model.reflectance(l, v);
    };
    return polarCurve(value, incoming, fineness);
}

} // namespace patina
