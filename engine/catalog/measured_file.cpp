// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/measured_file.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "core/table_number.h"

namespace patina {
namespace {

/// Is the mean of the eight bins around a place, of those that were measured. `x` has shares of the
/// axes, 0 .. 1; the azimuth is a ring. The device reads a texture, C++ the same table.
constexpr std::string_view meanOfBins = R"(    ivec3 bins = MEASURED_BINS;
    vec3 middle = x * vec3(bins) - 0.5;
    vec3 low = floor(middle);
    vec3 high = middle - low;
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        ivec3 side = ivec3(corner & 1, (corner >> 1) & 1, corner >> 2);
        ivec3 bin = ivec3(low) + side;
        bin.x = bin.x < 0 ? bins.x - 1 : bin.x >= bins.x ? 0 : bin.x;
        bin.y = clamp(bin.y, 0, bins.y - 1);
        bin.z = clamp(bin.z, 0, bins.z - 1);
        float weight = (side.x > 0 ? high.x : 1.0 - high.x) * (side.y > 0 ? high.y : 1.0 - high.y)
            * (side.z > 0 ? high.z : 1.0 - high.z);
        vec3 value = MEASURED_VALUE(bin);
        weight = value.x < 0.0 ? 0.0 : weight;
        sum += weight * value;
        weights += weight;
    }
    return weights > 0.0 ? max(sum / weights, vec3(0.0)) : vec3(0.0);
)";

constexpr std::string_view readTexture = R"(uniform sampler3D measuredTable;
#define MEASURED_BINS textureSize(measuredTable, 0)
#define MEASURED_VALUE(bin) texelFetch(measuredTable, bin, 0).rgb
)";

} // namespace

int tableOfFile(const Parameter& parameter, const std::string& file) {
    return tableNumber(file, parameter.role == grainRole ? TableForm::WithGrain
                                                         : TableForm::WithoutGrain);
}

const ParameterTypeInfo& infoOfMeasured() {
    static constexpr ShaderFunction function{
        .result = "vec3", .body = meanOfBins, .argument = "vec3", .before = readTexture};
    static const ParameterTypeInfo info = [] {
        ParameterTypeInfo row = infoOfTexture();
        row.word = "measured";
        row.components = 4; // the number of the file's table, and what fills a vec4
        row.glsl = "int";
        row.cpp = "const double*";
        row.expected = [](const Parameter&) {
            return std::string("a file of the MERL (.binary) or RGL (.bsdf) collection");
        };
        row.pack = [](const Parameter& parameter, const Value& value, double* out) {
            const auto* file = std::get_if<std::string>(&value);
            std::fill_n(out, 4, 0.0);
            out[0] = file != nullptr ? tableOfFile(parameter, *file) : 0.0;
        };
        row.isTable = true;
        row.function = &function;
        return row;
    }();
    return info;
}

} // namespace patina
