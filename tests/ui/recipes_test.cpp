// SPDX-License-Identifier: GPL-3.0-or-later
// What CONTRIBUTING.md shows how to add to the editor, as it stands there.
#include "docks/object_count_dock.h"
#include "ui/window_fixture.h"
#include "window/lazy_dock.h"

namespace patina::tests::recipes_test {
namespace {

class RecipesTest : public WindowFixture {};

TEST_F(RecipesTest, DockOfTheGuide_FollowsTheDocument) {
    const auto make = [](const DockContext& context) { return new ObjectCountDock(context); };
    LazyDock dock({"object-count", "Objects", DockPlace::Bottom, make}, window().dockContext(),
                  &window());
    window().addDockWidget(Qt::BottomDockWidgetArea, &dock);
    dock.show();
    const auto* label = qobject_cast<QLabel*>(dock.widget());
    ASSERT_NE(label, nullptr);
    EXPECT_EQ(label->text(), "1 object(s)");
    window().files().addBeside(Object());
    EXPECT_EQ(label->text(), "2 object(s)");
}

} // namespace
} // namespace patina::tests::recipes_test
