// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "support/program.h"

namespace patina {

/// Copies the shipped shaders and makes them show invalid numbers. Frames hide these: a NaN is
/// stored as no light, is cut at 0 when lights are summed, and is gone after a clamp. In the copy
/// nothing is cut, and each pixel shows whether a number that led to it was invalid; all other
/// pixels are black.
class ExaminedShaders {
  public:
    enum class Stage {
        /// Shows red for a colour that is not finite, green for a negative one, blue for a point or
        /// a light that is not finite, or for a normal that is not unit or does not face the eye by
        /// half of MIN_NV: slivers blend normals to more than length 1.
        Surface,
        Display ///< shows white where the tone mapping gives what is not finite or negative
    };

    explicit ExaminedShaders(Stage stage) {
        namespace fs = std::filesystem;
        fs::copy(PATINA_SOURCE_DIR "/shaders", folder_.path(), fs::copy_options::recursive);
        if (stage == Stage::Surface) {
            examineSurfaces();
        } else {
            replace("passes/display.frag", "void main() {", std::string(checks) + R"(
vec3 examined(vec3 x) {
    return vec3(float(!finite(x) || negative(x)));
}
void main() {)");
            replace("passes/display.frag", "toneMapped(min(light, vec3(1e30)))",
                    "examined(toneMapped(min(light, vec3(1e30))))");
        }
    }

    const std::filesystem::path& path() const { return folder_.path(); }

  private:
    /// Checks by bits: a compiler may assume the result of comparing a number with itself.
    static constexpr const char* checks = R"(
bool finite(float x) {
    return (floatBitsToUint(x) & 0x7f800000u) != 0x7f800000u;
}
bool finite(vec3 x) {
    return finite(x.r) && finite(x.g) && finite(x.b);
}
bool negative(vec3 x) {
    return x.r < 0.0 || x.g < 0.0 || x.b < 0.0;
}
)";

    void examineSurfaces() {
        replace("passes/surface_point.glsl", "struct Surface {",
                std::string(checks) + "bool unsound = false;\nstruct Surface {");
        replace("passes/surface.glsl", "    return s;\n",
                "    unsound = !(finite(s.x) && finite(s.v) && finite(s.range) && finite(s.n)\n"
                "        && finite(s.t) && finite(s.b)) || !(abs(dot(s.n, s.n) - 1.0) < 1e-5)\n"
                "        || !(dot(s.n, s.v) > 0.5 * MIN_NV);\n    return s;\n");
        replace("passes/surface.glsl", "void store(vec3 color, float alpha) {", R"(
void store(vec3 color, float alpha) {
    storedColor = vec4(float(!finite(color)), float(negative(color)), float(unsound), 1.0);
    return;)");
        for (const std::string name : {"litAnyway", "lit", "litWhereItArrives"}) {
            const std::string head = "vec3 " + name + "(Surface s, Illumination light, Model p) {";
            replace("passes/lit.glsl", head, head + R"(
    unsound = unsound || !finite(light.l) || !finite(light.radiance)
        || negative(light.radiance);)");
        }
        replace("passes/lit.glsl", "CUT_AT_ZERO(shadeModel(d, p))", "shadeModel(d, p)");
        replace("passes/ambient.glsl", "CUT_AT_ZERO(shadeModel(", "(shadeModel(");
    }

    void replace(const std::string& file, const std::string& from, const std::string& to) {
        std::string text = tests::readFile(folder_ / file);
        const auto place = text.find(from);
        ASSERT_NE(place, std::string::npos) << file << " has no " << from;
        tests::writeFile(folder_ / file, text.replace(place, from.size(), to));
    }

    tests::TemporaryFolder folder_;
};

} // namespace patina
