// SPDX-License-Identifier: GPL-3.0-or-later
// F5 after another program has written a file that is shown.
#include <algorithm>
#include <fstream>

#include <QImage>
#include <QTest>

#include "background/long_tasks.h"
#include "document/scene_edits.h"
#include "ui/window_fixture.h"

namespace patina::tests::read_again_test {
namespace {

constexpr int limitMs = 20000;

class ReadAgain : public WindowFixture {
  protected:
    ReadAgain() { focusView(); }

    QColor middle() {
        newFrames();
        const QImage picture = view().grabPicture();
        return picture.pixelColor(picture.rect().center());
    }

    /// A plane of one colour, larger than the view, whose left edge is at x.
    std::string writePlane(double x) {
        std::ofstream obj(home("plane.obj"));
        obj << "v " << x << " -3 0\nv 3 -3 0\nv 3 3 0\nv " << x << " 3 0\nf 1 2 3\nf 1 3 4\n";
        return home("plane.obj").string();
    }

    std::string writeImage(const QColor& color) {
        QImage picture(4, 4, QImage::Format_RGB32);
        picture.fill(color);
        const std::string file = home("paint.png").string();
        EXPECT_TRUE(picture.save(QString::fromStdString(file)));
        return file;
    }

    void pressKey() { QTest::keyClick(&view(), Qt::Key_F5); }
};

TEST_F(ReadAgain, ChangedImage_IsOnTheObject) {
    const BlockPath model = document().selection().currentPath(kinds::models);
    document().setModel(Side::A, "lambert");
    TextureUse paint;
    // Blue, which no picture before it is: neither that of the first material nor Lambert's own.
    paint.file = writeImage(Qt::blue);
    document().setTexture(model, "diffuse.color", paint);
    ASSERT_TRUE(QTest::qWaitFor([&] { return middle().blue() > 2 * middle().red(); }, limitMs));
    const int steps = document().undoStack().count();
    writeImage(Qt::green);
    EXPECT_GT(middle().blue(), middle().green()) << "images are not watched";
    pressKey();
    EXPECT_TRUE(QTest::qWaitFor([&] { return middle().green() > 2 * middle().blue(); }, limitMs));
    EXPECT_EQ(document().undoStack().count(), steps);
}

TEST_F(ReadAgain, ChangedMesh_IsTheObject) {
    document().setModel(Side::A, "lambert");
    changeObjects(document(), {0}, "mesh", [&](Object& object) {
        object.mesh = writePlane(-3.0);
        object.fitUnitBox = false;
    });
    const auto isRead = [&] {
        return window().meshes().view(document().scene().objects[0]).indices.size() == 6;
    };
    ASSERT_TRUE(QTest::qWaitFor(isRead, limitMs));
    const QColor covered = middle();
    writePlane(1.5);
    EXPECT_EQ(middle(), covered) << "meshes are not watched";
    pressKey();
    EXPECT_TRUE(QTest::qWaitFor([&] { return middle() != covered; }, limitMs));
    EXPECT_EQ(document().undoStack().count(), 2);
}

TEST_F(ReadAgain, Presets_AreReadFromTheirFolders) {
    const auto isReading = [] {
        const std::vector<LongTasks::Row> rows = LongTasks::all().running();
        return std::ranges::find(rows, "Reading presets", &LongTasks::Row::name) != rows.end();
    };
    ASSERT_TRUE(QTest::qWaitFor([&] { return !isReading(); }, limitMs));
    pressKey();
    EXPECT_TRUE(isReading());
}

} // namespace
} // namespace patina::tests::read_again_test
