// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include <QDirIterator>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "gl/driver.h"
#include "ui/window_fixture.h"
#include "viewport/program_worker.h"

namespace patina::tests::program_worker_test {
namespace {

constexpr int compilingMs = 20000;
constexpr int writingMs = 500; ///< what a driver still has to write would be there by then

/// The files below a folder and their sizes.
std::map<QString, qint64> filesIn(const QString& folder) {
    std::map<QString, qint64> files;
    QDirIterator next(folder, QDir::Files, QDirIterator::Subdirectories);
    while (next.hasNext()) {
        const QFileInfo file(next.next());
        files[file.filePath()] = file.size();
    }
    return files;
}

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
    const int before = view().frames().waitCount();
    changeModel();
    EXPECT_EQ(newFrames(), 1);
    EXPECT_EQ(view().frames().waitCount(), before + 1);
    EXPECT_EQ(view().frames().report().compiled, 0);
    EXPECT_TRUE(view().frames().report().messages.empty());
}

TEST_F(ProgramsMadeElsewhere, WhileTheyAreMade_TheLastPictureStays) {
    const int frames = view().frames().frameCount();
    QSignalSpy waited(&view().frames(), &FrameLoop::frameDrawn);
    const int before = view().frames().waitCount();
    changeModel();
    ASSERT_TRUE(QTest::qWaitFor([&] { return view().frames().waitCount() > before; }, compilingMs));
    EXPECT_EQ(view().frames().frameCount(), frames);
    EXPECT_TRUE(view().frames().isDrawing());
    EXPECT_TRUE(waited.wait(compilingMs));
}

TEST_F(ProgramsMadeElsewhere, AnotherModelMeanwhile_IsTheOneThatIsShown) {
    const std::string first = document().material(Side::A)->model.id;
    const int before = view().frames().waitCount();
    changeModel();
    ASSERT_TRUE(QTest::qWaitFor([&] { return view().frames().waitCount() > before; }, compilingMs));
    document().setModel(Side::A, first);
    newFrames();
    EXPECT_TRUE(std::ranges::count(view().frames().report().effects, "models/" + first) == 1);
}

TEST_F(ProgramsMadeElsewhere, Cancelled_KeepTheLastPictureUntilTheNextChange) {
    const int frames = view().frames().frameCount();
    const int before = view().frames().waitCount();
    changeModel();
    ASSERT_TRUE(QTest::qWaitFor([&] { return view().frames().waitCount() > before; }, compilingMs));
    const auto rows = LongTasks::all().running();
    const auto row = std::ranges::find(rows, "Preparing shaders", &LongTasks::Row::name);
    ASSERT_NE(row, rows.end());
    EXPECT_TRUE(row->canCancel);
    LongTasks::all().cancel(row->number);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !view().frames().isDrawing(); }, compilingMs));
    QTest::qWait(100);
    EXPECT_EQ(view().frames().frameCount(), frames);
    EXPECT_EQ(view().frames().waitCount(), before + 1);
    view().frames().refresh();
    EXPECT_EQ(newFrames(), 1);
    EXPECT_EQ(view().frames().report().compiled, 0);
}

TEST_F(ProgramsMadeElsewhere, WindowClosedMeanwhile_LeavesNothingBehind) {
    const int before = view().frames().waitCount();
    changeModel();
    ASSERT_TRUE(QTest::qWaitFor([&] { return view().frames().waitCount() > before; }, compilingMs));
    close();
    open();
    EXPECT_EQ(view().frames().frameCount(), 1);
}

/// A view that looked for it too early would compile it again, in the window.
TEST_F(ProgramsMadeElsewhere, WhatTheDriverMade_IsOnTheDiskWhenTheyAreFinished) {
    const bool isSoftware = [this] {
        const ViewContext::Current current(view().viewed().sources().context);
        return gl::isSoftware();
    }();
    const QTemporaryDir driver;
    const QByteArray before = qgetenv("MESA_SHADER_CACHE_DIR");
    qputenv("MESA_SHADER_CACHE_DIR", driver.path().toUtf8());
    ProgramWorker worker({});
    QSignalSpy finished(&worker, &ProgramWorker::finished);
    const Scene scene = document().scene(Side::A);
    ProgramWorker::Frame frame{scene, {}, View(), {}, 1, nullptr};
    frame.catalog = std::make_shared<const Catalog>(document().catalog());
    frame.meshes.assign(scene.objects.size(), {glm::vec3(-1.0f), glm::vec3(1.0f)});
    worker.ask(std::move(frame));
    EXPECT_TRUE(finished.wait(compilingMs));
    const auto written = filesIn(driver.path());
    QTest::qWait(writingMs);
    EXPECT_EQ(filesIn(driver.path()), written);
    EXPECT_TRUE(!isSoftware || !written.empty());
    before.isNull() ? qunsetenv("MESA_SHADER_CACHE_DIR") : qputenv("MESA_SHADER_CACHE_DIR", before);
}

} // namespace
} // namespace patina::tests::program_worker_test
