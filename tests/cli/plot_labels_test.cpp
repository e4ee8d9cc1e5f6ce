// SPDX-License-Identifier: GPL-3.0-or-later
// The names beside the points of a chart.
#include "cli/plot_labels.h"

#include <gtest/gtest.h>

namespace patina::tests::plot_labels_test {
namespace {

constexpr glm::ivec2 chart{400, 300};
constexpr glm::dvec3 white{1.0};

TEST(PlotLabels, PointsUponEachOther_ShareALabel) {
    const std::vector<PlotShape> labels = labelsOf(
        {{{100.0, 100.0}, "fast"}, {{100.5, 99.5}, "exact", true}, {{99.5, 100.0}, "table"}},
        {}, chart, white);
    ASSERT_EQ(labels.size(), 1u);
    EXPECT_EQ(labels.front().text, "exact and 2 more");
}

TEST(PlotLabels, PointsFarApart_HaveTheirOwn) {
    const std::vector<PlotShape> labels =
        labelsOf({{{50.0, 50.0}, "fast"}, {{300.0, 250.0}, "exact", true}}, {}, chart, white);
    ASSERT_EQ(labels.size(), 2u);
    EXPECT_EQ(labels.front().text, "fast");
    EXPECT_EQ(labels.back().text, "exact");
}

/// Of a mark to the right, it goes to the left.
TEST(PlotLabels, MarkBesideAPoint_IsNotCovered) {
    const glm::dvec2 point{200.0, 100.0};
    const auto placed = [&point](const std::vector<glm::dvec2>& marks) {
        return labelsOf({{point, "fast"}}, marks, chart, white).at(0).from;
    };
    EXPECT_GT(placed({point}).x, point.x);
    EXPECT_LT(placed({point, point + glm::dvec2(16.0, -8.0), point + glm::dvec2(16.0, 8.0)}).x,
              point.x);
}

TEST(PlotLabels, PointWithoutRoom_HasNone) {
    const std::vector<PlotShape> labels = labelsOf(
        {{{200.0, 100.0}, "fast"}, {{212.0, 100.0}, std::string(60, 'a')}}, {}, chart, white);
    ASSERT_EQ(labels.size(), 1u);
    EXPECT_EQ(labels.front().text, "fast");
}

} // namespace
} // namespace patina::tests::plot_labels_test
