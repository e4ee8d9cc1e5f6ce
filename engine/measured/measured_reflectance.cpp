// SPDX-License-Identifier: GPL-3.0-or-later
#include "measured/measured_reflectance.h"

#include "core/ordinary_file.h"
#include "measured/merl_file.h"
#include "measured/rgl_file.h"
#include "measured/tensor_file.h"

namespace patina {

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
