// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <cstring>

#include <gtest/gtest.h>

#include "cli/patina_program.h"

namespace patina::tests::table_test {
namespace {

/// Reads a number of a file, the low byte first.
template <class Number>
Number at(const std::string& bytes, std::size_t place) {
    Number number{};
    std::memcpy(&number, bytes.data() + place, sizeof(Number));
    return number;
}

TEST(TableCommand, File_HasItsAxesAndItsValues) {
    const TemporaryFolder folder;
    const std::string file = (folder / "t.exr").string();
    const Outcome made = patina({"table", "--model", "lambert", "--set", "diffuse.color=0.5,0.25,1",
                                 "--size", "4", "-o", file});
    ASSERT_EQ(made.exitCode, 0) << made.err;
    EXPECT_NE(made.out.find("pi f over n.v and n.l, 4 x 4 texels"), std::string::npos) << made.out;
    const std::string bytes = readFile(file);
    EXPECT_TRUE(bytes.starts_with("\x76\x2f\x31\x01"));
    EXPECT_NE(bytes.find("n.v, 0 .. 1, at middles of texels"), std::string::npos);
    // The rows are the end of the file: 4 times a place, a length, and blue, green and red.
    const std::size_t row = 8 + 4 * 3 * 4;
    const std::size_t first = bytes.size() - 4 * row;
    EXPECT_EQ(at<std::uint32_t>(bytes, first), 0u);
    EXPECT_EQ(at<std::uint32_t>(bytes, first + row), 1u);
    EXPECT_EQ(at<std::uint32_t>(bytes, first + 4), 4u * 3u * 4u);
    EXPECT_FLOAT_EQ(at<float>(bytes, first + 8), 1.0f);
    EXPECT_FLOAT_EQ(at<float>(bytes, first + 8 + 16), 0.25f);
    EXPECT_FLOAT_EQ(at<float>(bytes, first + 8 + 32), 0.5f);
}

TEST(TableCommand, Exr_IsReadByThePictureReader) {
    const TemporaryFolder folder;
    const std::string file = (folder / "t.exr").string();
    ASSERT_EQ(patina({"table", "--model", "lambert", "-o", file}).exitCode, 0);
    const std::string picture = (folder / "p.png").string();
    const Outcome drawn = patina({"render", "--model", "lambert", "--texture",
                                  "diffuse.color=" + file, "--size", "16x16", "-o", picture});
    EXPECT_EQ(drawn.exitCode, 0) << drawn.err;
    EXPECT_EQ(drawn.err, "");
}

TEST(TableCommand, Code_ReadsTheTangentsOfFibres) {
    const Outcome made = patina({"table", "--model", "heidrich-seidel", "--code"});
    ASSERT_EQ(made.exitCode, 0) << made.err;
    EXPECT_NE(made.out.find("vec3 tabledReflectance(vec3 n, vec3 t, vec3 l, vec3 v)"),
              std::string::npos)
        << made.out;
    EXPECT_NE(made.out.find("0.5 * vec2(dot(v, t), dot(l, t)) + 0.5"), std::string::npos);
}

TEST(TableCommand, ModelOfMoreThanTwoNumbers_IsRefused) {
    const Outcome made = patina({"table", "--model", "cook-torrance"});
    EXPECT_EQ(made.exitCode, 1);
    EXPECT_NE(made.err.find("decided neither by n.l and n.v nor by l.t and v.t"), std::string::npos)
        << made.err;
}

} // namespace
} // namespace patina::tests::table_test
