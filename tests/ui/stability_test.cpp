// SPDX-License-Identifier: GPL-3.0-or-later
// The check of a whole material and that of every pixel, with a user's model that breaks.
#include <algorithm>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QLabel>
#include <QProgressBar>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include "docks/stability_dock.h"
#include "ui/window_fixture.h"
#include "viewport/inspection_panel.h"

namespace patina::tests::stability_test {
namespace {

constexpr int sweepMs = 60000;

/// A model in the user's folder that is not a number at grazing angles.
class Stability : public WindowFixture {
  protected:
    void useBrokenModel() {
        const std::filesystem::path folder = home("XDG_DATA_HOME") / "patina/shaders/models";
        std::filesystem::create_directories(folder);
        writeFile(folder / "homemade.json", R"({
            "id": "homemade", "version": 1, "label": "Homemade", "summary": "For tests.",
            "applications": "Tests.", "source": "None", "doc": "For tests.",
            "parameters": [{"id": "limit", "label": "Limit", "type": "float", "default": 0.3,
                            "min": 0, "max": 1, "softMin": 0, "softMax": 1, "step": 0.01,
                            "decimals": 2, "group": "Colour", "doc": "For tests."}],
            "claims": ["finite"]})");
        writeFile(folder / "homemade.glsl", "// SPDX-License-"
                                            "Identifier: MIT-0\n#include \"lib/directions.glsl\"\n"
                                            "vec3 homemade(Directions d, Homemade p) {\n"
                                            "    return vec3(sqrt(d.nv - p.limit));\n}\n");
        document().setCatalog(std::make_shared<const Catalog>(loadCatalog(standardBlockRoots())));
        document().setModel(Side::A, "homemade");
    }

    StabilityDock& dock() {
        window().dock("stability")->show();
        return *window().dock("stability")->findChild<StabilityDock*>();
    }

    QString verdict() { return dock().findChild<QLabel*>("verdict")->text(); }

    void press(const QString& text) {
        for (QToolButton* button : dock().findChildren<QToolButton*>()) {
            if (button->text() == text) {
                button->click();
            }
        }
    }

    bool check() {
        dock().start();
        return QTest::qWaitFor([this] { return !dock().isRunning(); }, sweepMs);
    }

    void inspect(bool on) {
        QSignalSpy frames(&view().frames(), &FrameLoop::frameDrawn);
        window().findChild<QAction*>("inspect")->setChecked(on);
        EXPECT_TRUE(frames.wait(sweepMs));
    }

    void pointAt(QPoint place) {
        QMouseEvent move(QEvent::MouseMove, place, view().mapToGlobal(place), Qt::NoButton,
                         Qt::NoButton, Qt::NoModifier);
        QApplication::sendEvent(&view(), &move);
    }

    QString numbers() { return view().findChild<QLabel*>("probe")->text(); }
};

bool isGrey(QRgb pixel) {
    return std::max({qRed(pixel), qGreen(pixel), qBlue(pixel)}) -
               std::min({qRed(pixel), qGreen(pixel), qBlue(pixel)}) <
           8;
}

int colouredPixels(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            count += isGrey(image.pixel(x, y)) ? 0 : 1;
        }
    }
    return count;
}

TEST_F(Stability, CheckOfABrokenModel_ListsWhatBreaks) {
    useBrokenModel();
    ASSERT_TRUE(check());
    auto* list = dock().findChild<QTreeWidget*>();
    ASSERT_GT(list->topLevelItemCount(), 0);
    EXPECT_TRUE(list->topLevelItem(0)->text(0).contains("not a number"));
}

TEST_F(Stability, CheckOfAUsersModel_SaysThatOnlyTheDeviceWasAsked) {
    useBrokenModel();
    ASSERT_TRUE(check());
    EXPECT_TRUE(verdict().contains("graphics device only")) << verdict().toStdString();
}

TEST_F(Stability, CopiedCase_IsJsonOfThatModel) {
    useBrokenModel();
    ASSERT_TRUE(check());
    press("Copy case");
    EXPECT_TRUE(QApplication::clipboard()->text().contains("\"homemade\""));
}

TEST_F(Stability, CancelledCheck_SaysThatItStopped) {
    dock().start();
    press("Cancel");
    ASSERT_TRUE(QTest::qWaitFor([this] { return !dock().isRunning(); }, sweepMs));
    EXPECT_TRUE(verdict().startsWith("Stopped")) << verdict().toStdString();
}

TEST_F(Stability, ChangedMaterial_PutsTheResultOutOfDate) {
    useBrokenModel();
    ASSERT_TRUE(check());
    EXPECT_FALSE(verdict().contains("Out of date"));
    document().setValue(document().selection().currentPath(kinds::models), "limit", 0.2);
    EXPECT_TRUE(verdict().contains("Out of date"));
}

TEST_F(Stability, BlocksThatAreReadAgain_PutTheResultOutOfDateWhenTheyDiffer) {
    useBrokenModel();
    ASSERT_TRUE(check());
    const auto readAgain = [this] {
        document().setCatalog(std::make_shared<const Catalog>(loadCatalog(standardBlockRoots())));
    };
    readAgain();
    EXPECT_FALSE(verdict().contains("Out of date"));
    const std::filesystem::path file =
        home("XDG_DATA_HOME") / "patina/shaders/models/homemade.glsl";
    writeFile(file, readFile(file) + "// another\n");
    readAgain();
    EXPECT_TRUE(verdict().contains("Out of date"));
}

TEST_F(Stability, RunningCheck_ShowsItsProgressMeanwhile) {
    auto* progress = dock().findChild<QProgressBar*>();
    bool shownMeanwhile = false;
    QObject::connect(progress, &QProgressBar::valueChanged, progress, [&](int value) {
        shownMeanwhile = shownMeanwhile || (dock().isRunning() && value > 0);
    });
    ASSERT_TRUE(check());
    EXPECT_TRUE(shownMeanwhile);
}

TEST_F(Stability, NumericalCheckOfABrokenModel_PaintsItInColour) {
    useBrokenModel();
    newFrames(); // of a model that a process of its own has tried by then
    inspect(true);
    EXPECT_TRUE(
        QTest::qWaitFor([this] { return colouredPixels(view().grabPicture()) > 500; }, sweepMs));
}

TEST_F(Stability, NumericalCheckSwitchedOff_BringsThePictureBack) {
    newFrames();
    const QImage before = view().grabPicture();
    inspect(true);
    inspect(false);
    EXPECT_EQ(view().grabPicture(), before);
}

TEST_F(Stability, PointerInTheNumericalCheck_ReadsThePixel) {
    inspect(true);
    pointAt(view().rect().center());
    EXPECT_TRUE(QTest::qWaitFor([this] { return numbers().contains("Colour"); }, sweepMs));
}

TEST_F(Stability, PointerInTheNumericalCheck_DrawsNoFrame) {
    inspect(true);
    newFrames();
    pointAt(view().rect().center());
    EXPECT_EQ(newFrames(), 0);
}

} // namespace
} // namespace patina::tests::stability_test
