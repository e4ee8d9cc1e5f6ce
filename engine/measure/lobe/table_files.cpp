// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/lobe/table_files.h"

#include <bit>
#include <cstdint>

#include <fmt/format.h>

namespace patina {
namespace {

std::string axisText(TableAxes axes, bool isLight) {
    const char* const direction = isLight ? "l" : "v";
    return axes == TableAxes::NormalCosines ? fmt::format("n.{}, 0 .. 1", direction)
                                            : fmt::format("{}.t, -1 .. 1", direction);
}

/// Writes the numbers of an OpenEXR file, the low byte first.
class ExrBytes {
  public:
    template <class Number>
    void add(Number number) {
        for (std::size_t i = 0; i < sizeof(Number); ++i) {
            bytes_ += static_cast<char>(number >> (8 * i) & 0xff);
        }
    }
    void add(float number) { add(std::bit_cast<std::uint32_t>(number)); }
    void addName(const std::string& text) { bytes_ += text + '\0'; }

    /// Adds an attribute of the header.
    void attribute(const std::string& name, const std::string& type, const std::string& data) {
        addName(name);
        addName(type);
        add(static_cast<std::uint32_t>(data.size()));
        bytes_ += data;
    }

    std::string& bytes() { return bytes_; }

  private:
    std::string bytes_;
};

template <class... Numbers>
std::string exrData(Numbers... numbers) {
    ExrBytes data;
    (data.add(numbers), ...);
    return data.bytes();
}

std::string exrChannels() {
    constexpr std::uint32_t floats = 2;
    ExrBytes data;
    for (const char* channel : {"B", "G", "R"}) {
        data.addName(channel);
        data.add(floats);
        data.add(std::uint32_t(0)); // neither perceptually linear nor anything else
        data.add(std::uint32_t(1));
        data.add(std::uint32_t(1));
    }
    data.bytes() += '\0';
    return data.bytes();
}

void addExrHeader(ExrBytes& file, const ReflectanceTable& table, const std::string& name) {
    file.add(std::uint32_t(20000630)); // says that it is OpenEXR
    file.add(std::uint32_t(2));        // version 2, one part of scan lines
    const auto last = static_cast<std::uint32_t>(table.size - 1);
    const std::string window = exrData(std::uint32_t(0), std::uint32_t(0), last, last);
    file.attribute("channels", "chlist", exrChannels());
    file.attribute("compression", "compression", std::string(1, '\0'));
    file.attribute("dataWindow", "box2i", window);
    file.attribute("displayWindow", "box2i", window);
    file.attribute("lineOrder", "lineOrder", std::string(1, '\0'));
    file.attribute("patina.error", "string",
                   fmt::format("{:.3g} at most, {:.3g} in the mean, of pi f n.l", table.maxError,
                               table.meanError));
    file.attribute("patina.material", "string", name);
    file.attribute("patina.tangent", "string",
                   fmt::format("{:g} degrees from the surface's", table.tangentDegrees));
    file.attribute("patina.value", "string", table.hasCosine ? "pi f n.l" : "pi f");
    file.attribute("patina.x", "string", axisText(table.axes, false) + ", at middles of texels");
    file.attribute("patina.y", "string",
                   axisText(table.axes, true) + ", at middles of texels, the first row first");
    file.attribute("pixelAspectRatio", "float", exrData(1.0f));
    file.attribute("screenWindowCenter", "v2f", exrData(0.0f, 0.0f));
    file.attribute("screenWindowWidth", "float", exrData(1.0f));
    file.bytes() += '\0';
}

} // namespace

std::string tableExr(const ReflectanceTable& table, const std::string& name) {
    ExrBytes file;
    addExrHeader(file, table, name);
    const auto size = static_cast<std::size_t>(table.size);
    const std::size_t rowBytes = size * 3 * sizeof(float);
    const std::size_t first = file.bytes().size() + size * sizeof(std::uint64_t);
    for (std::size_t row = 0; row < size; ++row) {
        file.add(static_cast<std::uint64_t>(first + row * (rowBytes + 8)));
    }
    for (std::size_t row = 0; row < size; ++row) {
        file.add(static_cast<std::uint32_t>(row));
        file.add(static_cast<std::uint32_t>(rowBytes));
        for (const int channel : {2, 1, 0}) {
            for (std::size_t column = 0; column < size; ++column) {
                file.add(static_cast<float>(table.values[row * size + column][channel]));
            }
        }
    }
    return file.bytes();
}

std::string tableCode(const ReflectanceTable& table, const std::string& name) {
    const bool isOfNormal = table.axes == TableAxes::NormalCosines;
    const std::string tangent =
        table.tangentDegrees == 0.0
            ? std::string("the surface's tangent")
            : fmt::format("the tangent, turned by {:g} degrees in the surface",
                          table.tangentDegrees);
    return fmt::format(
        "// pi f cos(theta_l) of {}: {}.\n"
        "// Linear filter, clamped to the edge; the file's first row is the texture's first.\n"
        "uniform sampler2D reflectanceTable;\n\n"
        "// Unit n, l and v, away from the surface{}.\n"
        "vec3 tabledReflectance(vec3 n, {}vec3 l, vec3 v) {{\n"
        "    float nl = dot(n, l);\n"
        "    if (nl <= 0.0 || dot(n, v) <= 0.0) {{\n        return vec3(0.0);\n    }}\n"
        "    vec2 place = {};\n"
        "    return texture(reflectanceTable, place).rgb{};\n}}\n",
        name, tableText(table), isOfNormal ? "" : "; t is " + tangent, isOfNormal ? "" : "vec3 t, ",
        isOfNormal ? "vec2(dot(n, v), nl)" : "0.5 * vec2(dot(v, t), dot(l, t)) + 0.5",
        table.hasCosine ? "" : " * nl");
}

} // namespace patina
