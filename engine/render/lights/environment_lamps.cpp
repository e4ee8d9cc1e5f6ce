// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/lights/environment_lamps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <optional>

#include <glm/geometric.hpp>

#include "core/color.h"

namespace patina {
namespace {

using std::numbers::pi;

constexpr std::size_t maxLamps = 4;

/// These constants define the search for the limit. It begins at `firstFactor` times the brightness
/// that `usualShare` of all directions stay below, and grows by `stepFactor` in each step.
constexpr double usualShare = 0.75;
constexpr double firstFactor = 2.0;
constexpr double stepFactor = 1.25;
constexpr int steps = 60;

/// Is the least length of the mean direction of a lamp's light, where 1 means a single direction.
constexpr double compactness = 0.92;

/// A part with a smaller share of the light above the limit is no lamp; its light goes to the
/// nearest lamp.
constexpr double minShare = 0.02;

/// Lamps with a smaller share of all the light are dropped.
constexpr double minShareOfAll = 0.01;

/// Gives the brightness, direction and solid angle of each texel of a small picture.
class Sky {
  public:
    explicit Sky(const EnvironmentRadiance& environment) : environment_(environment) {
        brightness_.reserve(environment.texels.size());
        for (const glm::vec4& texel : environment.texels) {
            const double each = luminance(glm::dvec3(texel));
            brightness_.push_back(std::isfinite(each) ? each : 0.0);
        }
    }

    std::size_t count() const { return brightness_.size(); }
    glm::ivec2 size() const { return environment_.size; }
    double brightness(std::size_t i) const { return brightness_[i]; }
    glm::dvec3 color(std::size_t i) const { return glm::dvec3(environment_.texels[i]); }

    double solidAngle(std::size_t i) const {
        const std::size_t row = i / std::size_t(size().x);
        return (std::cos(pi * double(row) / size().y) - std::cos(pi * double(row + 1) / size().y)) *
               2.0 * pi / size().x;
    }

    glm::dvec3 direction(std::size_t i) const {
        const std::size_t row = i / std::size_t(size().x);
        const double down = pi * (double(row) + 0.5) / size().y;
        const double across =
            ((double(i % std::size_t(size().x)) + 0.5) / size().x - 0.5) * 2.0 * pi;
        return {std::sin(down) * std::sin(across), std::cos(down),
                -std::sin(down) * std::cos(across)};
    }

    double flux() const {
        double sum = 0.0;
        for (std::size_t i = 0; i < count(); ++i) {
            sum += brightness(i) * solidAngle(i);
        }
        return sum;
    }

    /// Returns the luminance that `share` of all directions stays below.
    double below(double share) const {
        std::vector<std::size_t> order(count());
        std::iota(order.begin(), order.end(), std::size_t(0));
        std::ranges::sort(order, {}, [this](std::size_t i) { return brightness(i); });
        double sum = 0.0;
        for (const std::size_t i : order) {
            sum += solidAngle(i);
            if (sum >= share * 4.0 * pi) {
                return brightness(i);
            }
        }
        return 0.0;
    }

  private:
    const EnvironmentRadiance& environment_;
    std::vector<double> brightness_;
};

/// Holds the sums over a connected part of the sky, of its light above a limit.
struct Part {
    double flux = 0.0;       ///< is the integral of the luminance
    double square = 0.0;     ///< is the integral of the squared luminance
    glm::dvec3 mean{0.0};    ///< is the integral of the direction, weighted by luminance
    glm::dvec3 moments[3]{}; ///< are the same integral for each colour channel

    void add(const Sky& sky, std::size_t i, double limit) {
        const double excess = sky.brightness(i) - limit;
        const double above = excess * sky.solidAngle(i);
        const glm::dvec3 direction = sky.direction(i);
        const glm::dvec3 color = sky.color(i) * (above / sky.brightness(i));
        flux += above;
        square += excess * above;
        mean += above * direction;
        for (int channel = 0; channel < 3; ++channel) {
            moments[channel] += color[channel] * direction;
        }
    }

    void add(const Part& other) {
        flux += other.flux;
        mean += other.mean;
        for (int channel = 0; channel < 3; ++channel) {
            moments[channel] += other.moments[channel];
        }
    }

    bool isCompact() const { return glm::length(mean) >= compactness * flux; }
};

/// Returns the connected parts of the sky that are brighter than a limit, the strongest first.
/// Neighbours share an edge or a corner, also across the left and right end.
std::vector<Part> partsAbove(const Sky& sky, double limit) {
    std::vector<Part> parts;
    std::vector<bool> isTaken(sky.count(), false);
    std::vector<std::size_t> open;
    const glm::ivec2 size = sky.size();
    for (std::size_t first = 0; first < sky.count(); ++first) {
        if (isTaken[first] || sky.brightness(first) <= limit) {
            continue;
        }
        Part& part = parts.emplace_back();
        isTaken[first] = true;
        open.assign(1, first);
        while (!open.empty()) {
            const std::size_t i = open.back();
            open.pop_back();
            part.add(sky, i, limit);
            const int column = static_cast<int>(i % std::size_t(size.x));
            const int row = static_cast<int>(i / std::size_t(size.x));
            for (int y = std::max(row - 1, 0); y <= std::min(row + 1, size.y - 1); ++y) {
                for (int x = column - 1; x <= column + 1; ++x) {
                    const std::size_t next =
                        std::size_t(y) * std::size_t(size.x) + std::size_t((x + size.x) % size.x);
                    if (!isTaken[next] && sky.brightness(next) > limit) {
                        isTaken[next] = true;
                        open.push_back(next);
                    }
                }
            }
        }
    }
    std::ranges::sort(parts, std::greater(), &Part::flux);
    return parts;
}

/// Returns the lamps, or nothing when a part that is strong enough is not compact, or when there
/// are more than maxLamps. The light of weak parts is added to the nearest lamp.
std::optional<std::vector<Part>> lampsAmong(const std::vector<Part>& parts) {
    double all = 0.0;
    for (const Part& part : parts) {
        all += part.flux;
    }
    std::vector<Part> lamps;
    for (const Part& part : parts) {
        if (part.flux >= minShare * all) {
            if (lamps.size() == maxLamps || !part.isCompact()) {
                return std::nullopt;
            }
            lamps.push_back(part);
        }
    }
    const std::vector<Part> found = lamps;
    for (std::size_t i = found.size(); i < parts.size(); ++i) {
        const auto nearest = std::ranges::max_element(found, {}, [&](const Part& lamp) {
            return glm::dot(glm::normalize(lamp.mean), parts[i].mean);
        });
        lamps[static_cast<std::size_t>(nearest - found.begin())].add(parts[i]);
    }
    return lamps;
}

EnvironmentLamp lampOf(const Part& part) {
    EnvironmentLamp lamp;
    lamp.direction = glm::normalize(part.mean);
    for (int channel = 0; channel < 3; ++channel) {
        lamp.radiance[channel] =
            std::max(glm::dot(part.moments[channel], lamp.direction), 0.0) / pi;
    }
    const double solidAngle = part.flux * part.flux / part.square; // is that of a disc with uniform
                                                                   // brightness
    lamp.width = 2.0 * std::acos(std::clamp(1.0 - solidAngle / (2.0 * pi), -1.0, 1.0));
    return lamp;
}

} // namespace

EnvironmentLamps environmentLamps(const EnvironmentRadiance& environment) {
    EnvironmentLamps result;
    if (environment.texels.empty()) {
        return result;
    }
    const Sky sky(environment);
    const double all = sky.flux();
    double limit = std::max(firstFactor * sky.below(usualShare), 1e-3 * all / (4.0 * pi));
    for (int step = 0; step < steps; ++step, limit *= stepFactor) {
        const std::vector<Part> parts = partsAbove(sky, limit);
        if (parts.empty()) {
            return result;
        }
        if (const auto lamps = lampsAmong(parts)) {
            double theirs = 0.0;
            for (const Part& lamp : *lamps) {
                theirs += lamp.flux;
            }
            if (theirs < minShareOfAll * all) {
                return result;
            }
            result.limit = limit;
            std::ranges::transform(*lamps, std::back_inserter(result.lamps), lampOf);
            return result;
        }
    }
    return result;
}

} // namespace patina
