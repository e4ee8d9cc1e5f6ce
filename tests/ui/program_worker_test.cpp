// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <QSignalSpy>
#include <QTest>

#include "ui/window_fixture.h"

namespace patina::tests {
namespace {

constexpr int compilingMs = 20000;

class ProgramsMadeElsewhere : public WindowFixture {
  protected:
    /// A model that no program was made for yet.
    void changeModel() {
        const std::string model = document().material(Side::A)->model.id;
        for (const Block& block : document().catalog().blocks) {
            if (block.kind == "models" && block.id != model) {
                document().setModel(Side::A, block.id);
                return;
            }
        }
    }
};

TEST_F(ProgramsMadeElsewhere, NewModel_CompilesNothingInTheWindow) {
    const int before = view().waitCount();
    changeModel();
    EXPECT_EQ(newFrames(), 1);
    EXPECT_EQ(view().waitCount(), before + 1);
    EXPECT_EQ(view().report().compiled, 0);
    EXPECT_TRUE(view().report().messages.empty());
}

TEST_F(ProgramsMadeElsewhere, WhileTheyAreMade_TheLastPictureStays) {
    const int frames = view().frameCount();
    QSignalSpy waited(&view(), &Viewport::frameDrawn);
    const int before = view().waitCount();
    changeModel();
    ASSERT_TRUE(QTest::qWaitFor([&] { return view().waitCount() > before; }, compilingMs));
    EXPECT_EQ(view().frameCount(), frames);
    EXPECT_TRUE(view().isDrawing());
    EXPECT_TRUE(waited.wait(compilingMs));
}

TEST_F(ProgramsMadeElsewhere, AnotherModelMeanwhile_IsTheOneThatIsShown) {
    const std::string first = document().material(Side::A)->model.id;
    const int before = view().waitCount();
    changeModel();
    ASSERT_TRUE(QTest::qWaitFor([&] { return view().waitCount() > before; }, compilingMs));
    document().setModel(Side::A, first);
    newFrames();
    EXPECT_TRUE(std::ranges::count(view().report().effects, "models/" + first) == 1);
}

TEST_F(ProgramsMadeElsewhere, WindowClosedMeanwhile_LeavesNothingBehind) {
    const int before = view().waitCount();
    changeModel();
    ASSERT_TRUE(QTest::qWaitFor([&] { return view().waitCount() > before; }, compilingMs));
    close();
    open();
    EXPECT_EQ(view().frameCount(), 1);
}

} // namespace
} // namespace patina::tests
