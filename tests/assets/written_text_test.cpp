// SPDX-License-Identifier: GPL-3.0-or-later
// How programs write text: marks before it, and commas where numbers have points.
#include <gtest/gtest.h>

#include "mesh_files.h"

namespace patina::tests::written_text_test {
namespace {

constexpr const char* mark = "\xef\xbb\xbf";

/// A mesh as text, in one of the formats.
struct Text {
    const char* name;
    const char* file;
    const char* content;
};
void PrintTo(const Text& text, std::ostream* stream) { *stream << text.name; }

class MarkedText : public testing::TestWithParam<Text> {};

TEST_P(MarkedText, ReadsAsWithoutItsMark) {
    const auto plain = loaded(GetParam().file, GetParam().content);
    const auto marked = loaded(GetParam().file, std::string(mark) + GetParam().content);
    ASSERT_TRUE(plain) << plain.error().text();
    ASSERT_TRUE(marked) << marked.error().text();
    EXPECT_EQ((*marked)->view().indices.size(), (*plain)->view().indices.size());
    EXPECT_EQ((*marked)->view().bounds.lower, (*plain)->view().bounds.lower);
    EXPECT_EQ((*marked)->view().bounds.upper, (*plain)->view().bounds.upper);
}

constexpr const char* fbx = R"(; FBX 7.3.0 project file
FBXHeaderExtension:  {
	FBXHeaderVersion: 1003
	FBXVersion: 7300
}
Objects:  {
	Geometry: 10, "Geometry::", "Mesh" {
		Vertices: *9 {
			a: 0.5,0,0.7,1.5,0,0,0.9,1.2,0
		}
		PolygonVertexIndex: *3 {
			a: 0,1,-3
		}
		GeometryVersion: 124
	}
	Model: 20, "Model::Tri", "Mesh" {
		Version: 232
	}
}
Connections:  {
	C: "OO",20,0
	C: "OO",10,20
}
)";

INSTANTIATE_TEST_SUITE_P(
    Formats, MarkedText,
    testing::Values(
        Text{"plainObj", "a.obj", "v 0.5 0 0.7\nv 1.5 0 0\nv 0.9 1.2 0\nf 1 2 3\n"},
        Text{"generalObj", "a.obj", squareObj},
        Text{"objWithBarePoints", "a.obj", "v .5 0 0 1\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
        Text{"ply", "a.ply",
             "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
             "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
             "end_header\n0.5 0 0.7\n1.5 0 0\n0.9 1.2 0\n3 0 1 2\n"},
        Text{"stl", "a.stl",
             "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0.5 0 0.7\nvertex 1.5 0 0\n"
             "vertex 0.9 1.2 0\nendloop\nendfacet\nendsolid a\n"},
        Text{"off", "a.off", "OFF\n3 1 3\n0.5 0 0.7\n1.5 0 0\n0.9 1.2 0\n3 0 1 2\n"},
        Text{"fbx", "a.fbx", fbx}),
    [](const auto& test) { return std::string(test.param.name); });

/// The message about an OBJ file, without the folder it lay in.
std::string messageAbout(const std::string& content) {
    const auto mesh = loaded("a.obj", content);
    if (mesh) {
        return "it loaded";
    }
    const std::string text = mesh.error().text();
    return text.substr(text.rfind("a.obj"));
}

TEST(CommasInAnObj, ThroughoutInPlaceOfPoints_AreDecimalCommas) {
    const auto mesh = loaded("a.obj", "v 0,5 0 0,25\nv 1,5 0 0\nv 0 1,125 0\nf 1 2 3\n");
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->view().bounds.upper, glm::vec3(1.5f, 1.125f, 0.25f));
}

TEST(CommasInAnObj, BetweenNumbers_Separate) {
    const auto mesh = loaded("a.obj", "v 0.5, 0, 0.25\nv 1.5, 0, 0\nv 0, 1.125, 0\nf 1 2 3\n");
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ((*mesh)->view().bounds.upper, glm::vec3(1.5f, 1.125f, 0.25f));
}

TEST(CommasInAnObj, BesidePoints_AreAnErrorAtTheFirst) {
    EXPECT_EQ(messageAbout("# one, two\nv 0 0 0\nv 2 1,500 0\nv 0.5 1 0\nf 1 2 3\n"),
              "a.obj:3:6: a comma stands inside a number; expected a decimal point");
}

TEST(CommasInAnObj, InANumberWithAPoint_AreAnError) {
    EXPECT_EQ(messageAbout("v 0 0 0\nv 1,000.5 0 0\nv 0 1 0\nf 1 2 3\n"),
              "a.obj:2:4: a comma stands inside a number; expected a decimal point");
}

TEST(CommasInAnObj, BetweenNumbersWithoutBlanks_AreAnError) {
    EXPECT_EQ(messageAbout("v 0,5,1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
              "a.obj:1:4: a comma stands inside a number; expected a decimal point");
}

TEST(CommasInAnObj, InNamesAndRemarks_MeanNothing) {
    EXPECT_EQ(messageAbout("# 1,5\ng a,b 1,5\nv 0 0 0\nv 1.5 0 0\nv 0 1 0\nf 1 2 3\n"),
              "it loaded");
}

} // namespace
} // namespace patina::tests::written_text_test
