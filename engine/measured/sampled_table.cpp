// SPDX-License-Identifier: GPL-3.0-or-later
#include "measured/sampled_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <thread>
#include <utility>

#include "measured/half_difference.h"

namespace patina {
namespace {

using std::numbers::pi;

constexpr glm::ivec3 binsWithoutGrain{180, 90, 90};
constexpr glm::ivec3 binsOfATurn{20, 32, 64};
/// Count the azimuths of the half vector along each axis of a table, as the shader does.
constexpr glm::ivec3 turnsAlong{5, 4, 3};
static_assert(grainTurns == 5 * 4 * 3);
/// Also has the azimuth's other end at both ends, and an empty bin behind the other angles.
constexpr glm::ivec3 partOfATurn{20 + 2, 32 + 1, 64 + 1};
constexpr int averagedTurns = 8; ///< counts the azimuths over which a grain is averaged

glm::dvec3 turned(const glm::dvec3& d, double azimuth) {
    const double c = std::cos(azimuth);
    const double s = std::sin(azimuth);
    return {d.x * c - d.y * s, d.x * s + d.y * c, d.z};
}

/// Returns the directions in the middle of a bin of so many, whose half vector lies over the
/// tangent.
DirectionPair middleOf(const glm::ivec3& bin, const glm::ivec3& bins) {
    const glm::dvec3 share = (glm::dvec3(bin) + 0.5) / glm::dvec3(bins);
    return directionsAt({share.z * share.z * 0.5 * pi, share.y * 0.5 * pi, share.x * pi});
}

/// Samples a reflectance in the bins of a table.
class TableSampler {
  public:
    TableSampler(const MeasuredReflectance& measured, TableForm form)
        : measured_(measured), hasGrain_(form == TableForm::WithGrain),
          bins_(hasGrain_ ? binsOfATurn : binsWithoutGrain) {
        table_.form = form;
        table_.isIsotropic = measured.isIsotropic();
        table_.bins = hasGrain_ ? partOfATurn * turnsAlong : bins_;
        table_.texels.assign(std::size_t(table_.bins.x) * std::size_t(table_.bins.y) *
                                 std::size_t(table_.bins.z),
                             glm::vec3(-1.0f));
    }

    HalfDifferenceTable table() {
        const int parts = int(std::clamp(std::thread::hardware_concurrency(), 1u, 16u));
        std::vector<std::jthread> threads;
        for (int part = 1; part < parts; ++part) {
            threads.emplace_back([this, part, parts] { fillFrom(part, parts); });
        }
        fillFrom(0, parts);
        threads.clear();
        return std::move(table_);
    }

  private:
    void fillFrom(int first, int step) {
        glm::ivec3 bin;
        for (bin.z = first; bin.z < bins_.z; bin.z += step) {
            for (bin.y = 0; bin.y < bins_.y; ++bin.y) {
                for (bin.x = 0; bin.x < bins_.x; ++bin.x) {
                    const DirectionPair pair = middleOf(bin, bins_);
                    if (pair.l.z > 0.0 && pair.v.z > 0.0) {
                        fill(bin, pair);
                    }
                }
            }
        }
    }

    void fill(const glm::ivec3& bin, const DirectionPair& pair) {
        if (!hasGrain_) {
            texel(bin) = glm::vec3(meanOverTurns(pair));
            return;
        }
        for (int turn = 0; turn < grainTurns; ++turn) {
            fillTurn(bin, turn, glm::vec3(meanOf(pair, 2.0 * pi * turn / grainTurns)));
        }
    }

    void fillTurn(const glm::ivec3& bin, int turn, const glm::vec3& value) {
        const glm::ivec3 part(turn % turnsAlong.x, turn / turnsAlong.x % turnsAlong.y,
                              turn / (turnsAlong.x * turnsAlong.y));
        const glm::ivec3 start = part * partOfATurn;
        texel(start + glm::ivec3(bin.x + 1, bin.y, bin.z)) = value;
        if (bin.x == bins_.x - 1) {
            texel(start + glm::ivec3(0, bin.y, bin.z)) = value;
        }
        if (bin.x == 0) {
            texel(start + glm::ivec3(bins_.x + 1, bin.y, bin.z)) = value;
        }
    }

    glm::vec3& texel(const glm::ivec3& bin) {
        return table_.texels[std::size_t((bin.z * table_.bins.y + bin.y) * table_.bins.x + bin.x)];
    }

    glm::dvec3 meanOverTurns(const DirectionPair& pair) const {
        const int turns = measured_.isIsotropic() ? 1 : averagedTurns;
        glm::dvec3 sum(0.0);
        for (int turn = 0; turn < turns; ++turn) {
            sum += meanOf(pair, 2.0 * pi * turn / turns);
        }
        return sum / double(turns);
    }

    /// Returns the mean of both orders of the directions, which a table does not tell apart:
    /// between what was measured a file's own interpolation does, by as much as it is off.
    glm::dvec3 meanOf(const DirectionPair& pair, double azimuth) const {
        const glm::dvec3 l = turned(pair.l, azimuth);
        const glm::dvec3 v = turned(pair.v, azimuth);
        return 0.5 * (measured_.evaluate({l, v}) + measured_.evaluate({v, l}));
    }

    const MeasuredReflectance& measured_;
    bool hasGrain_;
    glm::ivec3 bins_; ///< counts those of one turn
    HalfDifferenceTable table_;
};

} // namespace

HalfDifferenceTable sampledTable(const MeasuredReflectance& measured, TableForm form) {
    return TableSampler(measured, form).table();
}

} // namespace patina
