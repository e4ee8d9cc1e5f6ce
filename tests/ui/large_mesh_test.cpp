// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh that takes long to read and to draw must not keep the window waiting.
#include <algorithm>
#include <fstream>

#include <QFile>
#include <QImage>
#include <QSignalSpy>
#include <QTest>

#include "background/long_tasks.h"
#include "ui/window_fixture.h"

namespace patina::tests::large_mesh_test {
namespace {

constexpr int gridSide = 330; // 2 * 329^2 triangles: 216 000
constexpr int limitMs = 60000;

class LargeMesh : public WindowFixture {
  protected:
    LargeMesh() {
        std::ofstream obj(file_);
        for (int i = 0; i < gridSide * gridSide; ++i) {
            const int row = i / gridSide;
            const int column = i % gridSide;
            obj << "v " << 0.01 * row << ' ' << 0.01 * column << ' ' << 0.05 * (column / 40 % 2)
                << '\n';
        }
        for (int row = 0; row + 1 < gridSide; ++row) {
            for (int column = 0; column + 1 < gridSide; ++column) {
                const int a = row * gridSide + column + 1;
                const int b = a + gridSide;
                obj << "f " << a << ' ' << a + 1 << ' ' << b << "\nf " << a + 1 << ' ' << b + 1
                    << ' ' << b << '\n';
            }
        }
    }

    void drop() { window().files().drop({QString::fromStdString(file_.string())}, Side::A); }

    /// Drops the file and waits until its first frame has begun.
    bool dropAndWait() {
        drop();
        return QTest::qWaitFor([this] { return view().frames().isDrawing(); }, limitMs);
    }

    bool waitForFrame() {
        QSignalSpy frames(&view().frames(), &FrameLoop::frameDrawn);
        return frames.wait(limitMs);
    }

    /// Waits until nothing more is drawn.
    bool rests() {
        return QTest::qWaitFor([this] { return newFrames() == 0 && !view().frames().isDrawing(); },
                               limitMs);
    }

    /// Stops what is called so; false where nothing is.
    static bool cancel(const QString& name) {
        const std::vector<LongTasks::Row> rows = LongTasks::all().running();
        const auto found = std::ranges::find(rows, name, &LongTasks::Row::name);
        if (found == rows.end() || !found->canCancel) {
            return false;
        }
        LongTasks::all().cancel(found->number);
        return true;
    }

  private:
    std::filesystem::path file_ = home("large.obj");
};

TEST_F(LargeMesh, Dropped_IsDrawnOverSeveralTurns) {
    ASSERT_TRUE(dropAndWait());
    int turns = 0;
    while (view().frames().isDrawing() && turns < limitMs) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        ++turns;
    }
    EXPECT_GT(turns, 1);
    EXPECT_TRUE(document().scene().objects.front().mesh.ends_with("large.obj"));
}

TEST_F(LargeMesh, NotYetDrawn_LeavesTheLastPicture) {
    const QImage before = view().grabPicture();
    ASSERT_TRUE(dropAndWait());
    QCoreApplication::processEvents();
    ASSERT_TRUE(view().frames().isDrawing());
    EXPECT_EQ(view().grabPicture(), before);
}

TEST_F(LargeMesh, Drawn_ChangesThePicture) {
    const QImage before = view().grabPicture();
    ASSERT_TRUE(dropAndWait());
    ASSERT_TRUE(rests());
    EXPECT_NE(view().grabPicture(), before);
}

TEST_F(LargeMesh, UndoneWhileItIsDrawn_IsGone) {
    const std::vector<Object> before = document().scene().objects;
    ASSERT_TRUE(dropAndWait());
    const int frames = view().frames().frameCount();
    document().undoStack().undo();
    ASSERT_TRUE(rests());
    EXPECT_EQ(document().scene().objects, before);
    EXPECT_GT(view().frames().frameCount(), frames); // of what is there again
}

TEST_F(LargeMesh, CameraMovedWhileItIsDrawn_IsDrawnFromThere) {
    ASSERT_TRUE(dropAndWait());
    ASSERT_TRUE(rests());
    const QImage before = view().grabPicture();
    drag(Qt::LeftButton, Qt::NoModifier, {200, 0});
    ASSERT_TRUE(QTest::qWaitFor([this] { return view().frames().isDrawing(); }, limitMs));
    drag(Qt::LeftButton, Qt::NoModifier, {-200, 0});
    ASSERT_TRUE(rests());
    EXPECT_EQ(view().grabPicture(), before);
}

TEST_F(LargeMesh, ResizedWhileItIsDrawn_IsDrawnInTheNewSize) {
    ASSERT_TRUE(dropAndWait());
    window().resize(window().size() - QSize(60, 40));
    ASSERT_TRUE(waitForFrame());
    EXPECT_EQ(view().grabPicture().size(), view().size());
}

TEST_F(LargeMesh, CancelledWhileItIsRead_ChangesNothing) {
    const Scene before = document().scene();
    QSignalSpy messages(&window().documentFiles(), &DocumentFiles::message);
    drop();
    ASSERT_TRUE(cancel("Reading a mesh"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !messages.isEmpty(); }, limitMs));
    EXPECT_EQ(document().scene(), before);
    EXPECT_FALSE(document().isModified());
}

class LargeMeshExport : public LargeMesh {
  protected:
    void SetUp() override {
        ASSERT_TRUE(dropAndWait());
        const auto isShown = [this] { return newFrames() == 0 && view().frames().isUpToDate(); };
        ASSERT_TRUE(QTest::qWaitFor(isShown, limitMs));
    }

    void save() { window().pictures().save(name_, pictureOf(view())); }
    QImage written() const { return QImage(name_).convertToFormat(QImage::Format_RGB888); }
    bool isThere() const { return QFile::exists(name_); }

  private:
    QString name_ = QString::fromStdString(home("large.png").string());
};

TEST_F(LargeMeshExport, Picture_IsDrawnOverSeveralTurns) {
    save();
    int turns = 0;
    while (view().frames().isDrawing() && turns < limitMs) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        ++turns;
    }
    EXPECT_GT(turns, 1);
}

TEST_F(LargeMeshExport, Picture_IsWhatTheViewShows) {
    QSignalSpy saved(&window().pictures(), &PictureExport::saved);
    const QImage shown = view().grabPicture().convertToFormat(QImage::Format_RGB888);
    save();
    ASSERT_TRUE(saved.wait(limitMs));
    const QImage picture = written();
    ASSERT_EQ(picture.size(), shown.size());
    int largest = 0;
    for (int y = 0; y < shown.height(); ++y) {
        for (int i = 0; i < 3 * shown.width(); ++i) {
            const int wanted = shown.constScanLine(y)[i];
            largest = std::max(largest, std::abs(picture.constScanLine(y)[i] - wanted));
        }
    }
    EXPECT_EQ(largest, 0);
}

TEST_F(LargeMeshExport, ViewResizedMeanwhile_IsExportedInItsNewSize) {
    QSignalSpy saved(&window().pictures(), &PictureExport::saved);
    save();
    window().resize(window().size() - QSize(60, 40));
    ASSERT_TRUE(saved.wait(limitMs));
    EXPECT_EQ(written().size(), view().size());
}

TEST_F(LargeMeshExport, Cancelled_WritesNothingAndSaysNothing) {
    save();
    ASSERT_TRUE(cancel("Drawing a picture"));
    ASSERT_TRUE(rests());
    EXPECT_FALSE(isThere());
    EXPECT_EQ(window().messages().count(), 0);
}

TEST_F(LargeMeshExport, Done_IsNoTaskAnyMore) {
    QSignalSpy saved(&window().pictures(), &PictureExport::saved);
    save();
    ASSERT_TRUE(saved.wait(limitMs));
    const std::vector<LongTasks::Row> rows = LongTasks::all().running();
    EXPECT_EQ(std::ranges::count(rows, QStringLiteral("Drawing a picture"), &LongTasks::Row::name),
              0);
}

TEST_F(LargeMesh, DoubleClicked_PutsThePivotOnItsSurface) {
    ASSERT_TRUE(dropAndWait());
    ASSERT_TRUE(rests());
    const glm::dvec3 before = camera().pivot;
    QTest::mouseDClick(&view(), Qt::LeftButton, Qt::NoModifier, view().rect().center());
    EXPECT_NE(camera().pivot, before);
}

} // namespace
} // namespace patina::tests::large_mesh_test
