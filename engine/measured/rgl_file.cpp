// SPDX-License-Identifier: GPL-3.0-or-later
#include "measured/rgl_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/color.h"
#include "measured/sampled_table.h"
#include "measured/spectrum_color.h"
#include "measured/tensor_file.h"
#include "measured/warp_table.h"

namespace patina {
namespace {

using std::numbers::pi;

/// Bounds what a grazing light divides by: a file holds f times the cosine, which fades more slowly
/// in the interpolation.
constexpr double minCosine = 1e-4;

/// Maps a polar angle of 0 .. pi/2 to 0 .. 1, with more room near the normal.
double unitOfPolar(double theta) {
    return std::sqrt(theta * 2.0 / pi);
}

double polarOfUnit(double unit) {
    return unit * unit * 0.5 * pi;
}

double unitOfAzimuth(double phi) {
    const double unit = (phi + pi) / (2.0 * pi);
    return unit - std::floor(unit);
}

double azimuthOfUnit(double unit) {
    return (2.0 * unit - 1.0) * pi;
}

double polarOf(const glm::dvec3& d) {
    return std::atan2(std::hypot(d.x, d.y), d.z);
}

double azimuthOf(const glm::dvec3& d) {
    return std::atan2(d.y, d.x);
}

glm::dvec3 direction(double polar, double azimuth) {
    return {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
            std::cos(polar)};
}

/// Returns the place of the number that is nearest.
std::size_t nearestIn(const std::vector<float>& numbers, double wanted) {
    const auto nearest = std::ranges::min_element(
        numbers, {}, [wanted](float number) { return std::abs(double(number) - wanted); });
    return static_cast<std::size_t>(nearest - numbers.begin());
}

/// Holds the tables of a file.
struct RglTables {
    SquareTable normals;                 ///< is the distribution of normals, over the half vector
    SquareTable area;                    ///< is what of them the eye sees, over its direction
    WarpTable seenNormals;               ///< are normals seen, over the half vector, per eye
    std::array<SquareTable, 3> channels; ///< are linear Rec. 709, over the warped square, per eye
    std::string description;
};

class RglReflectance : public MeasuredReflectance {
  public:
    explicit RglReflectance(RglTables tables) : tables_(std::move(tables)) {}

    glm::dvec3 evaluate(const DirectionPair& pair) const override {
        if (!(pair.l.z > 0.0 && pair.v.z > 0.0)) {
            return glm::dvec3(0.0);
        }
        const glm::dvec3 h = glm::normalize(pair.l + pair.v);
        const double eyePolar = polarOf(pair.v);
        const double eyeAzimuth = azimuthOf(pair.v);
        const SquareTable::Slices slices =
            tables_.seenNormals.density().slicesAt(eyeAzimuth, eyePolar);
        const glm::dvec2 half(unitOfPolar(polarOf(h)),
                              unitOfAzimuth(azimuthOf(h) - (isIsotropic() ? eyeAzimuth : 0.0)));
        return value(tables_.seenNormals.inverse(half, slices), slices, half,
                     {unitOfPolar(eyePolar), unitOfAzimuth(eyeAzimuth)}) /
               std::max(pair.l.z, minCosine);
    }

    std::optional<DirectionPair> nearestSample(const DirectionPair& pair) const override {
        const SquareTable& grid = tables_.channels[0];
        const double eyeAzimuth = azimuthOf(pair.v);
        const std::size_t azimuth = isIsotropic() ? 0 : nearestIn(grid.first(), eyeAzimuth);
        const std::size_t polar = nearestIn(grid.second(), polarOf(pair.v));
        const glm::dvec3 h = glm::normalize(pair.l + pair.v);
        const glm::dvec2 half(unitOfPolar(polarOf(h)),
                              unitOfAzimuth(azimuthOf(h) - (isIsotropic() ? eyeAzimuth : 0.0)));
        const glm::dvec2 warped = tables_.seenNormals.inverse(
            half,
            tables_.seenNormals.density().slicesAt(grid.first()[azimuth], grid.second()[polar]));
        const glm::ivec2 point(glm::round(warped * glm::dvec2(grid.size() - 1)));
        return pairAt({azimuth, polar}, point);
    }

    HalfDifferenceTable table(TableForm form) const override { return sampledTable(*this, form); }

    bool isIsotropic() const override { return tables_.seenNormals.density().first().size() <= 2; }

    std::string description() const override { return tables_.description; }

  private:
    glm::dvec3 value(const glm::dvec2& warped, const SquareTable::Slices& slices,
                     const glm::dvec2& half, const glm::dvec2& eye) const {
        const SquareTable::Slices one;
        const double area = tables_.area.at(eye, one);
        if (!(area > 0.0)) {
            return glm::dvec3(0.0);
        }
        glm::dvec3 light;
        for (int c = 0; c < 3; ++c) {
            light[c] = tables_.channels[static_cast<std::size_t>(c)].at(warped, slices);
        }
        return glm::max(light, glm::dvec3(0.0)) * tables_.normals.at(half, one) / (4.0 * area);
    }

    /// Is a direction of the eye that the file has, by its places in the arrays of angles.
    struct Eye {
        std::size_t azimuth = 0;
        std::size_t polar = 0;
    };

    /// Returns the directions of a grid point, counted in columns and rows; nothing where the light
    /// would be below the surface.
    std::optional<DirectionPair> pairAt(const Eye& eye, const glm::ivec2& point) const {
        const SquareTable& grid = tables_.channels[0];
        const glm::dvec2 warped = glm::dvec2(point) / glm::dvec2(grid.size() - 1);
        const double eyePolar = grid.second()[eye.polar];
        const double eyeAzimuth = grid.first()[eye.azimuth];
        const SquareTable::Slices slices =
            tables_.seenNormals.density().slicesAt(eyeAzimuth, eyePolar);
        const glm::dvec2 half = tables_.seenNormals.forward(warped, slices);
        const glm::dvec3 v = direction(eyePolar, eyeAzimuth);
        const glm::dvec3 h = direction(polarOfUnit(half.x),
                                       azimuthOfUnit(half.y) + (isIsotropic() ? eyeAzimuth : 0.0));
        const glm::dvec3 l = 2.0 * glm::dot(v, h) * h - v;
        constexpr double grazing = 1e-3;
        return l.z > grazing && v.z > grazing && glm::dot(v, h) > grazing
                   ? std::optional(DirectionPair{l, v})
                   : std::nullopt;
    }

    RglTables tables_;
};

/// Takes the arrays of a file apart, and remembers the first thing that is wrong.
class RglReader {
  public:
    explicit RglReader(TensorFields fields) : fields_(std::move(fields)) {}

    Result<RglTables> tables() {
        std::vector<float> azimuths = numbers("phi_i", {0});
        std::vector<float> polars = numbers("theta_i", {0});
        checkRising("phi_i", azimuths);
        checkRising("theta_i", polars);
        SquareTable normals = square("ndf", {}, {});
        SquareTable area = square("sigma", {}, {});
        SquareTable seen = square("vndf", azimuths, polars);
        std::optional<std::array<SquareTable, 3>> channels = colours(azimuths, polars);
        if (problem_ || !channels) {
            return tl::unexpected(problem_.value_or(Error{{}, 0, 0, "has no colours", {}}));
        }
        const double turn = azimuths.size() > 2 ? azimuths.back() - azimuths.front() : 2.0 * pi;
        if (std::abs(turn - 2.0 * pi) > 0.5) {
            return failure(fmt::format("\"phi_i\" covers {:.3} radians", turn), "a whole turn");
        }
        const auto text = fields_.find("description");
        const bool hasText = text != fields_.end() && text->second.type == TensorField::Type::Bytes;
        return RglTables{std::move(normals), std::move(area), WarpTable(std::move(seen)),
                         std::move(*channels), hasText ? text->second.bytes : std::string("RGL")};
    }

  private:
    void note(std::string problem) {
        if (!problem_) {
            problem_ = Error{{}, 0, 0, std::move(problem), "an RGL file"};
        }
    }

    /// Says what is wrong with a number of an array of floats, and at which byte of the file.
    std::string wrongAt(const std::string& name, std::ptrdiff_t index,
                        const std::string& what) const {
        const auto found = fields_.find(name);
        const std::size_t start = found != fields_.end() ? found->second.offset : 0;
        return fmt::format("byte {}: \"{}\" {} there",
                           start + static_cast<std::size_t>(index) * sizeof(float), name, what);
    }

    /// Returns the numbers of an array of floats with these sizes; 0 stands for any.
    std::vector<float> numbers(const std::string& name, const std::vector<std::size_t>& shape) {
        const auto found = fields_.find(name);
        const bool fits =
            found != fields_.end() && found->second.type == TensorField::Type::Floats &&
            std::ranges::equal(found->second.shape, shape, [](std::size_t has, std::size_t wanted) {
                return wanted == 0 || has == wanted;
            });
        if (!fits) {
            note(found == fields_.end() ? fmt::format("the array \"{}\" is missing", name)
                 : found->second.type != TensorField::Type::Floats
                     ? fmt::format("byte {}: \"{}\" is of {}, not of float32",
                                   found->second.typePlace, name, typeText(found->second))
                     : wrongAt(name, 0, "has another shape"));
            return {};
        }
        return found->second.floats;
    }

    std::vector<std::size_t> shapeOf(const std::string& name) const {
        const auto found = fields_.find(name);
        return found != fields_.end() ? found->second.shape : std::vector<std::size_t>();
    }

    void checkRising(const std::string& name, const std::vector<float>& values) {
        const auto fall = std::ranges::adjacent_find(values, std::greater_equal());
        if (values.empty() || fall != values.end()) {
            note(wrongAt(name, values.empty() ? 0 : fall - values.begin(), "does not rise"));
        }
    }

    void checkDensity(const std::string& name, const std::vector<float>& values) {
        const auto below = std::ranges::find_if(values, [](float value) { return value < 0.0f; });
        if (below != values.end()) {
            note(wrongAt(name, below - values.begin(), fmt::format("is {}, below 0", *below)));
        } else if (!values.empty() && std::ranges::max(values) == 0.0f) {
            note(fmt::format("byte {}: \"{}\" is 0 everywhere", fields_.at(name).offset, name));
        }
    }

    /// Looks for light below none. A colour outside of Rec. 709 has a channel below 0, which counts
    /// as none, but no luminance below 0; what is next to nothing may be the instrument's noise.
    void checkLight(const std::string& name, const std::vector<float>& values, std::size_t channels,
                    std::size_t points) {
        const double noise = 1e-3 * double(std::ranges::max(values));
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (double(values[i]) >= -noise) {
                continue;
            }
            const std::size_t first = i / (channels * points) * channels * points + i % points;
            const double light = channels != 3 ? double(values[i])
                                               : luminance({values[first], values[first + points],
                                                            values[first + 2 * points]});
            if (light < -noise) {
                note(wrongAt(name, std::ptrdiff_t(i), fmt::format("is {}, below 0", values[i])));
                return;
            }
        }
    }

    /// Reads an array over the unit square; with parameters, one for each pair of them.
    SquareTable square(const std::string& name, const std::vector<float>& azimuths,
                       const std::vector<float>& polars) {
        std::vector<std::size_t> shape{0, 0};
        if (!azimuths.empty()) {
            shape = {azimuths.size(), polars.size(), 0, 0};
        }
        std::vector<float> values = numbers(name, shape);
        checkDensity(name, values);
        const std::vector<std::size_t> has = shapeOf(name);
        return {std::move(values), gridOf(name, has), azimuths, polars};
    }

    /// Returns the columns and rows that the last two sizes of an array are.
    glm::ivec2 gridOf(const std::string& name, const std::vector<std::size_t>& shape) {
        constexpr std::size_t maxSize = 1u << 14;
        if (shape.size() < 2 || shape.back() < 2 || shape[shape.size() - 2] < 2 ||
            shape.back() > maxSize || shape[shape.size() - 2] > maxSize) {
            note(wrongAt(name, 0, "has no grid"));
            return glm::ivec2(2);
        }
        return {int(shape.back()), int(shape[shape.size() - 2])};
    }

    /// Returns the colours over the warped square: those of an RGB file, or those that a spectrum
    /// has for the eye.
    std::optional<std::array<SquareTable, 3>> colours(const std::vector<float>& azimuths,
                                                      const std::vector<float>& polars) {
        const bool isSpectral = fields_.contains("spectra");
        const std::string name = isSpectral ? "spectra" : "rgb";
        const std::vector<std::size_t> shape = shapeOf(name);
        const std::vector<float> values =
            numbers(name, {azimuths.size(), polars.size(), isSpectral ? 0u : 3u, 0, 0});
        const std::vector<float> wavelengths =
            isSpectral ? numbers("wavelengths", {shape.size() > 2 ? shape[2] : 1})
                       : std::vector<float>();
        const glm::ivec2 grid = gridOf(name, shape);
        const std::size_t points = std::size_t(grid.x) * std::size_t(grid.y);
        if (!problem_) {
            checkLight(name, values, shape[2], points);
        }
        if (problem_) {
            return std::nullopt;
        }
        const std::vector<glm::dvec3> weights =
            isSpectral ? spectrumWeights(wavelengths)
                       : std::vector<glm::dvec3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        const std::size_t slices = azimuths.size() * polars.size();
        std::array<std::vector<float>, 3> colours;
        for (std::size_t c = 0; c < 3; ++c) {
            colours[c].resize(slices * points);
            for (std::size_t i = 0; i < colours[c].size(); ++i) {
                const std::size_t start = i / points * weights.size() * points + i % points;
                double sum = 0.0;
                for (std::size_t k = 0; k < weights.size(); ++k) {
                    sum += weights[k][int(c)] * double(values[start + k * points]);
                }
                colours[c][i] = float(sum);
            }
        }
        const auto table = [&](std::size_t c) {
            return SquareTable(std::move(colours[c]), grid, azimuths, polars);
        };
        return std::array{table(0), table(1), table(2)};
    }

    TensorFields fields_;
    std::optional<Error> problem_;
};

} // namespace

Result<std::shared_ptr<const MeasuredReflectance>> rglReflectance(std::string_view bytes) {
    auto fields = tensorFields(bytes);
    if (!fields) {
        return tl::unexpected(fields.error());
    }
    Result<RglTables> tables = RglReader(std::move(*fields)).tables();
    if (!tables) {
        return tl::unexpected(tables.error());
    }
    return std::make_shared<const RglReflectance>(std::move(*tables));
}

} // namespace patina
