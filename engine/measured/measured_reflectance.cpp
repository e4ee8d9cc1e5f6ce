// SPDX-License-Identifier: GPL-3.0-or-later
#include "measured/measured_reflectance.h"

#include "core/ordinary_file.h"
#include "measured/half_difference.h"
#include "measured/merl_file.h"
#include "measured/rgl_file.h"
#include "measured/tensor_file.h"

namespace patina {

std::vector<DirectionPair> MeasuredReflectance::samples(std::size_t maxCount) const {
    constexpr std::size_t triesEach = 8; // a file may have values in a corner only
    std::vector<DirectionPair> pairs;
    for (std::size_t i = 1; pairs.size() < maxCount && i <= triesEach * maxCount; ++i) {
        const DirectionPair wanted = spreadPair(i);
        const bool isAbove = wanted.l.z > 0.0 && wanted.v.z > 0.0;
        if (const auto nearest = isAbove ? nearestSample(wanted) : std::nullopt) {
            pairs.push_back(*nearest);
        }
    }
    return pairs;
}

Result<std::shared_ptr<const MeasuredReflectance>> readMeasured(const std::filesystem::path& file) {
    const Result<std::string> bytes = readFile(file, maxAssetBytes);
    if (!bytes) {
        return tl::unexpected(bytes.error());
    }
    auto reading = isTensorFile(*bytes) ? rglReflectance(*bytes) : merlReflectance(*bytes);
    if (!reading) {
        reading.error().file = file.string();
    }
    return reading;
}

bool isMeasuredFile(const std::filesystem::path& file) {
    return file.extension() == ".binary" || file.extension() == ".bsdf";
}

} // namespace patina
