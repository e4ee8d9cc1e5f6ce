// SPDX-License-Identifier: GPL-3.0-or-later
// The names beside the points of a chart.
#include "cli/plot_labels.h"

#include <gtest/gtest.h>

namespace patina::tests {
namespace {

constexpr glm::ivec2 chart{400, 300};
constexpr glm::dvec3 white{1.0};

TEST(PlotLabels, PointsUponEachOther_ShareALabel) {
    const std::vector<PlotShape> labels = labelsOf(
        {{{100.0, 100.0}, "fast"}, {{100.5, 99.5}, "exact", true}, {{99.5, 100.0}, "table"}},
        chart, white);
    ASSERT_EQ(labels.size(), 1u);
    EXPECT_EQ(labels.front().text, "exact and 2 more");
}

TEST(PlotLabels, PointsFarApart_HaveTheirOwn) {
    const std::vector<PlotShape> labels =
        labelsOf({{{50.0, 50.0}, "fast"}, {{300.0, 250.0}, "exact", true}}, chart, white);
    ASSERT_EQ(labels.size(), 2u);
    EXPECT_EQ(labels.front().text, "fast");
    EXPECT_EQ(labels.back().text, "exact");
}

} // namespace
} // namespace patina::tests
