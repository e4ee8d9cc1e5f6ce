// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of an object that the view does not show.

#include "gpu_fixture.h"
#include "render/surfaces/object_rows.h"

namespace patina::outside_rows_test {
namespace {

class OutsideRowsTest : public GpuTest {
  protected:
    /// A ball beside the one that is looked at.
    Scene ballAt(double x) const {
        Scene scene = simpleScene("phong");
        scene.exposure = 0.5;
        scene.objects.push_back(object("phong"));
        scene.objects[1].translation.x = x;
        return scene;
    }

    std::vector<EffectRow> rows(const Scene& scene, double aspect) {
        return objectRows(scene, 1, *catalog, meshSource(), {}, aspect);
    }
};

TEST_F(OutsideRowsTest, ObjectBesideThePicture_HasNothingButThePictureIn) {
    for (const EffectRow& row : rows(ballAt(9.0), 1.0)) {
        EXPECT_EQ(row.in, row.line.effect == "exposure") << row.line.effect;
        if (row.line.effect == "models/phong") {
            EXPECT_EQ(row.line.reason, "The object is outside the view: it is not drawn.");
            EXPECT_FALSE(row.removable);
        }
    }
}

TEST_F(OutsideRowsTest, PictureThatIsWider_ShowsIt) {
    const Scene scene = ballAt(2.8);
    EXPECT_FALSE(rows(scene, 1.0).front().in);
    EXPECT_TRUE(rows(scene, 2.0).front().in);
}

TEST_F(OutsideRowsTest, ShapeOfThePictureUnknown_TakesNothingOut) {
    EXPECT_TRUE(rows(ballAt(9.0), 0.0).front().in);
}

/// The frame leaves out the same objects.
TEST_F(OutsideRowsTest, FrameOfThatShape_DrawsAsManyObjects) {
    makeRenderer();
    for (const double x : {0.5, 2.1, 2.3, 9.0}) {
        const Scene scene = ballAt(x);
        capture(scene);
        EXPECT_EQ(renderer->report().drawnObjects, rows(scene, 1.0).front().in ? 2 : 1) << x;
    }
}

} // namespace
} // namespace patina::outside_rows_test
