// SPDX-License-Identifier: GPL-3.0-or-later
// A type of parameter is a row: nothing else asks which one it is.
#include <set>

#include <gtest/gtest.h>

#include "source_tree.h"

namespace patina::tests::parameter_types_test {
namespace {

TEST(ParameterTypes, Program_SwitchesOverNone) {
    for (const SourceFile& file : filesUnder({"engine", "app"}, {".h", ".cpp"})) {
        const auto at = file.text.find("case ParameterType::");
        EXPECT_EQ(at, std::string::npos)
            << file.place(at) << ": what differs by type belongs in ParameterTypeInfo";
    }
}

/// Files that have to do with a type by its name, as a word of code.
std::set<std::string> filesWith(const std::set<std::string>& words) {
    std::set<std::string> files;
    for (const SourceFile& file : filesUnder({"engine", "app"}, {".h", ".cpp"})) {
        for (const std::string& word : words) {
            if (file.text.find(word) != std::string::npos) {
                files.insert(file.path);
            }
        }
    }
    return files;
}

TEST(ParameterTypes, CurveAndRamp_AreInFiveFilesAndTheSchema) {
    const std::set<std::string> curve{
        "engine/catalog/parameter_type.h", "engine/catalog/curve.h", "engine/catalog/curve.cpp",
        "app/editor/parameters/curve_editor.h", "app/editor/parameters/curve_editor.cpp"};
    const std::set<std::string> ramp{
        "engine/catalog/parameter_type.h", "engine/catalog/ramp.h", "engine/catalog/ramp.cpp",
        "app/editor/parameters/ramp_editor.h", "app/editor/parameters/ramp_editor.cpp"};
    EXPECT_EQ(filesWith({"type(Curve)", "infoOfCurve", "CurvePoints", "CurveEditor", "curveValue"}),
              curve);
    EXPECT_EQ(filesWith({"type(Ramp)", "infoOfRamp", "RampStop", "RampEditor", "rampValue"}), ramp);
}

} // namespace
} // namespace patina::tests::parameter_types_test
