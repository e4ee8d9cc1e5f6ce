// SPDX-License-Identifier: GPL-3.0-or-later
// The double-precision code, generated once more with a folder that holds one more model.
#include <gtest/gtest.h>

#include <vector>

#include "reference/reference.h"

namespace patina::tests::two_files_test {
namespace {

const reference::Block* added() { return reference::findBlock("models", "half-bright"); }

/// Light and viewer 30 degrees to either side of the normal.
reference::Geometry symmetric() {
    return reference::geometry({0, 0, 1}, {1, 0, 0}, {0.5, 0, 0.8660254037844386},
                               {-0.5, 0, 0.8660254037844386});
}

double valueWith(double gain, double look) {
    const std::vector<double> parameters{gain, look, 0.0, 0.0};
    return reference::shade(*added(), symmetric(), parameters, {}).x;
}

TEST(AddedModel, TwoFiles_AreInTheReference) {
    ASSERT_NE(added(), nullptr);
    EXPECT_NE(reference::findBlock("models", "lambert"), nullptr);
}

TEST(AddedModel, ItsFields_FollowItsDescriptor) {
    ASSERT_EQ(added()->fields.size(), 2u);
    EXPECT_EQ(added()->fields[0], (reference::Field{"gain", 0, 1}));
    EXPECT_EQ(added()->fields[1], (reference::Field{"look", 1, 1}));
    EXPECT_EQ(added()->size, 4u);
}

TEST(AddedModel, ItsGates_FollowItsDescriptor) {
    EXPECT_TRUE(added()->lightGate);
    EXPECT_FALSE(added()->viewGate);
}

TEST(AddedModel, ItsFormula_IsEvaluated) {
    EXPECT_DOUBLE_EQ(valueWith(3.0, 0.0), 1.5);
}

TEST(AddedModel, ItsEnum_IsCompared) {
    EXPECT_EQ(valueWith(3.0, 1.0), 0.0);
}

} // namespace
} // namespace patina::tests::two_files_test
