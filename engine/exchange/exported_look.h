// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh_material.h"
#include "core/progress.h"
#include "material/material.h"

namespace patina {

/// Says how much of something is left in another program's file.
enum class Kept { Exact, Approximated, Dropped };

/// Returns "exact", "approximated" or "dropped".
std::string_view wordOf(Kept kept);

/// Says what becomes of one parameter, image or effect of a material.
struct ExportLine {
    Kept kept = Kept::Exact;
    std::string what; ///< names it as the editor does
    std::string how;  ///< says where it stands in the file, or what is lost

    friend bool operator==(const ExportLine&, const ExportLine&) = default;
};

/// Is a material in the words of mesh files, of which each format writes those that it has.
struct ExportedLook {
    MeshMaterial material;                          ///< has no images: they are below
    std::map<std::string, TextureUse> images;       ///< have the words of values, "normal" ...
    std::map<std::string, TextureChannel> channels; ///< says which counts of each of them
    std::map<std::string, std::string> labels;      ///< maps a word to the parameter's label
    std::vector<ExportLine> lines;
    nlohmann::json preset;        ///< is the whole material, whose images have full paths
    std::set<std::string> fitted; ///< has the words whose values are not the material's own

    /// Tells whether light passes through and is refracted.
    bool isTransmissive() const { return material.values.contains("transmission"); }

    /// Returns the image on a word's value; null where there is none.
    TextureUse* image(const std::string& word);
    const TextureUse* image(const std::string& word) const;

    void tell(Kept kept, std::string what, std::string how);
    /// Tells what becomes of a word's value, under the parameter's label; of a fitted one nothing
    /// is exact.
    void tellOf(const std::string& word, Kept kept, std::string how);
    /// Returns a word's value; `missing` where the material has none.
    glm::dvec3 value(const std::string& word, const glm::dvec3& missing = glm::dvec3(0.0)) const;
};

/// Says which looks a format has.
struct KnownLooks {
    std::span<const std::string_view> ofModels;
    bool hasTransmission = false; ///< says that what refracts can be told with a dielectric
};

/// Returns a material as the first of its model's looks that is among `looks` and says all its
/// values. Where none does, the models of `looks` are fitted to it, and the nearest is taken, with
/// its error in the lines; a drawing has no reflectance to be fitted, and leaves its colours. Fails
/// where the model is not known, or `looks` cannot be read. A cancelled fit is what it was till
/// then.
Result<ExportedLook> exportedLook(const Material& material, const KnownLooks& looks,
                                  const Catalog& catalog, const Progress& progress);

} // namespace patina
