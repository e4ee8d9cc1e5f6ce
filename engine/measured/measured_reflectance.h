// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "core/error.h"
#include "measured/half_difference_table.h"

namespace patina {

/// Holds the directions to the light and to the eye, both unit, in a frame whose z is the normal
/// and whose x is the tangent.
struct DirectionPair {
    glm::dvec3 l{0.0, 0.0, 1.0};
    glm::dvec3 v{0.0, 0.0, 1.0};
};

/// Is the reflectance of a real surface, as a file holds it.
class MeasuredReflectance {
  public:
    virtual ~MeasuredReflectance() = default;

    /// Returns f(l, v) in 1/sr for linear Rec. 709, 0 or more, interpolated between what was
    /// measured; 0 where l or v is not above the surface.
    virtual glm::dvec3 evaluate(const DirectionPair& directions) const = 0;

    /// Returns the pair of directions near these at which evaluate() is what the file holds;
    /// nothing where the file has no value there, or one direction would not be above the surface.
    virtual std::optional<DirectionPair> nearestSample(const DirectionPair& directions) const = 0;

    /// Returns at most `maxCount` pairs of directions at which evaluate() is what the file holds:
    /// the samples nearest to those of spreadPair(), so that surfaces in files of either format are
    /// looked at alike; some may be there twice.
    std::vector<DirectionPair> samples(std::size_t maxCount) const;

    /// Returns the reflectance in bins, for graphics cards: those that a MERL file has, else those
    /// of sampledTable(). Without a grain an anisotropic surface is averaged over its turns, so
    /// that it loses its direction.
    virtual HalfDifferenceTable table(TableForm form) const = 0;

    /// Tells whether only the difference of both azimuths counts.
    virtual bool isIsotropic() const = 0;

    /// Returns what the file says of itself, or its format and size.
    virtual std::string description() const = 0;
};

/// Reads a file of the MERL collection (.binary; Matusik et al. 2003) or of RGL's (.bsdf; Dupuy and
/// Jakob 2018, RGB or spectral). Errors name the file and, where its bytes are wrong, the place.
Result<std::shared_ptr<const MeasuredReflectance>> readMeasured(const std::filesystem::path& file);

/// Tells by its ending whether a file is one that readMeasured() reads.
bool isMeasuredFile(const std::filesystem::path& file);

} // namespace patina
