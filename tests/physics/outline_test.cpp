// SPDX-License-Identifier: GPL-3.0-or-later
// Which edges of a mesh get lines, and how wide ones.
#include <gtest/gtest.h>

#include <glm/trigonometric.hpp>

#include "physics_cases.h"

namespace patina::physics::outline_test {
namespace {

reference::Edge fold(double degrees) {
    reference::Edge edge;
    edge.dihedral = glm::radians(degrees);
    return edge;
}

glm::dvec2 widthsOf(const reference::Edge& edge, Values values = {}) {
    values.insert({{"width", 3.0}, {"crease.width", 2.0}});
    const Subject lines("outline", "ink-line", values);
    return lines.code->outline(edge, lines.parameters);
}

TEST(InkLine, FlatEdge_HasNone) {
    EXPECT_EQ(widthsOf(fold(0.0)), glm::dvec2(0.0));
}

TEST(InkLine, Silhouette_HasOneOutside) {
    reference::Edge edge = fold(5.0);
    edge.silhouette = true;
    EXPECT_EQ(widthsOf(edge), glm::dvec2(3.0, 0.0));
}

TEST(InkLine, Crease_HasOneFromItsAngleOn) {
    const Values angle{{"crease.angle", 30.0}};
    EXPECT_EQ(widthsOf(fold(29.99), angle), glm::dvec2(0.0));
    EXPECT_EQ(widthsOf(fold(30.01), angle), glm::dvec2(0.0, 2.0));
}

TEST(InkLine, CreaseOnTheSilhouette_HasBoth) {
    reference::Edge edge = fold(90.0);
    edge.silhouette = true;
    EXPECT_EQ(widthsOf(edge), glm::dvec2(3.0, 2.0));
}

TEST(InkLine, OpenEdge_HasBothUnlessSwitchedOff) {
    reference::Edge edge;
    edge.silhouette = true;
    edge.open = true;
    EXPECT_EQ(widthsOf(edge), glm::dvec2(3.0, 2.0));
    EXPECT_EQ(widthsOf(edge, {{"boundaries", false}}), glm::dvec2(0.0));
}

TEST(InkLine, Colour_IsTheChosenOne) {
    const Subject lines("outline", "ink-line", {{"color", glm::dvec3(0.25, 0.5, 0.75)}});
    EXPECT_EQ(lines.code->lineColor(lines.parameters), glm::dvec3(0.25, 0.5, 0.75));
}

} // namespace
} // namespace patina::physics::outline_test
