// SPDX-License-Identifier: GPL-3.0-or-later
// What artists come to do, from the first to the last click and key, with the picture that they
// get. Each task prints what it took; docs/tasks.md compares that with other editors.
#include <algorithm>
#include <iostream>
#include <set>

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QFileDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QTimer>
#include <QToolButton>

#include "catalog/ramp.h"
#include "library/preset_library.h"
#include "material/preset_file.h"
#include "parameters/handle_area.h"
#include "parameters/hex_box.h"
#include "parameters/number_box.h"
#include "parameters/parameter_row.h"
#include "parameters/preview_button.h"
#include "parameters/texture_line.h"
#include "parameters/value_slider.h"
#include "sheets/sheet_grid.h"
#include "sheets/sheets_dock.h"
#include "ui/hand.h"
#include "ui/preset_window.h"
#include "viewport/side_view.h"

namespace patina::tests::artist_tasks_test {
namespace {

namespace fs = std::filesystem;

constexpr int waitMs = 20000;

/// The editor, and a hand that counts.
class ArtistTask : public PresetWindow {
  protected:
    ArtistTask() : PresetWindow(Size::AsAtFirstStart) {}
    void TearDown() override {
        std::cout << "[   TASK   ] " << hand.clicks() << " clicks, " << hand.drags() << " drags, "
                  << hand.keys() << " keys, " << hand.wheels() << " notches of the wheel\n";
    }

    QImage picture(Side side = Side::A) {
        Viewport& viewport = window().views().view(side)->viewport();
        settle();
        EXPECT_TRUE(QTest::qWaitFor([&] { return viewport.frames().isUpToDate(); }, waitMs));
        return viewport.grabPicture();
    }
    const Material& material(Side side = Side::A) { return *document().material(side); }
    Value value(const std::string& id) {
        return document().value(document().selection().currentPath(kinds::models),
                                row(id).parameter());
    }
    double number(const std::string& id) { return std::get<double>(value(id)); }
    int steps() { return document().undoStack().count(); }

    void chooseModel(const QString& label) {
        auto* grid = window().dock("models")->widget()->findChild<QListWidget*>();
        const QListWidgetItem& item = *grid->findItems(label, Qt::MatchExactly).value(0);
        for (int i = 0; i < 100 && !grid->viewport()->rect().contains(placeIn(*grid, item)); ++i) {
            hand.turnWheel(*grid->viewport(), placeIn(*grid, item).y() < 0 ? 1 : -1);
        }
        hand.click(*grid->viewport(), placeIn(*grid, item));
    }
    ParameterRow& row(const std::string& id) {
        for (auto* row : window().dock("parameters")->findChildren<ParameterRow*>()) {
            if (row->parameter().id == id && row->isVisible()) {
                return *row;
            }
        }
        throw std::runtime_error("no row is shown of " + id);
    }
    void typeInto(QWidget& field, const QString& text) {
        hand.click(field);
        hand.key(field, Qt::Key_A, Qt::ControlModifier);
        hand.type(field, text);
        hand.key(field, Qt::Key_Return);
    }
    void dragSlider(const std::string& id, double from, double to) {
        auto& slider = *row(id).findChild<ValueSlider*>();
        const auto at = [&slider](double share) {
            return QPoint(int(share * (slider.width() - 1)), slider.height() / 2);
        };
        hand.drag(slider, at(from), at(to));
    }
    void search(const QString& words) {
        hand.click(PresetWindow::search());
        hand.type(PresetWindow::search(), words);
    }
    void searchAnew(const QString& words) {
        hand.click(PresetWindow::search());
        hand.key(PresetWindow::search(), Qt::Key_A, Qt::ControlModifier);
        hand.type(PresetWindow::search(), words);
    }

    /// Types a name into the next file dialog, and confirms it.
    void answerFileDialog(const fs::path& file) {
        auto* timer = new QTimer(&window());
        QObject::connect(timer, &QTimer::timeout, [this, timer, file] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            auto* name = dialog ? dialog->findChild<QLineEdit*>() : nullptr;
            if (name && dialog->windowHandle() && dialog->windowHandle()->isExposed()) {
                timer->deleteLater();
                QApplication::setActiveWindow(dialog);
                name->setFocus();
                name->selectAll();
                hand.type(*dialog, QString::fromStdString(file.string()));
                hand.key(*dialog, Qt::Key_Return);
                QApplication::setActiveWindow(&window());
            }
        });
        timer->start(20);
    }

    /// The file of the material's first image.
    std::string imageOf() {
        const auto& textures = material().textures;
        return textures.empty() ? std::string() : textures.begin()->second.file;
    }

    Hand hand;

  private:
    static QPoint placeIn(const QListWidget& grid, const QListWidgetItem& item) {
        return grid.visualItemRect(&item).center();
    }
};

TEST_F(ArtistTask, BrushedMetalFromNothing) {
    const QImage before = picture();
    chooseModel("Ward");
    typeInto(*row("diffuse.color").findChild<HexBox*>(), "101010");
    typeInto(*row("specular.color").findChild<HexBox*>(), "c8c8c0");
    dragSlider("roughness.x", 0.3, 0.05);
    dragSlider("roughness.y", 0.5, 0.6);
    EXPECT_EQ(material().model.id, "ward");
    EXPECT_LT(number("roughness.x"), 0.2 * number("roughness.y"));
    EXPECT_EQ(steps(), 5);
    EXPECT_NE(picture(), before);
}

TEST_F(ArtistTask, ThreeClaysCompared) {
    hand.key(window(), Qt::Key_B, Qt::ControlModifier);
    hand.key(window(), Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier);
    settle();
    search("clay");
    settle();
    ASSERT_GE(count(), 3);
    std::set<std::string> names;
    std::vector<QImage> pictures;
    int at = 0;
    for (const Side side : {Side::A, Side::B, Side::C}) {
        hand.click(window().views().view(side)->viewport());
        hand.doubleClick(*view().viewport(), placeOf(at++));
        names.insert(material(side).name);
    }
    EXPECT_EQ(names.size(), 3u);
    EXPECT_NE(picture(Side::A), picture(Side::B));
    EXPECT_NE(picture(Side::B), picture(Side::C));
}

TEST_F(ArtistTask, VelvetFoundAndTuned) {
    search("velvet");
    settle();
    ASSERT_GE(count(), 1);
    int at = 0;
    while (at < count() && !shown(at).contains("elvet")) {
        ++at;
    }
    hand.doubleClick(*view().viewport(), placeOf(at));
    EXPECT_TRUE(nameOnA().contains("elvet")) << nameOnA().toStdString();
    const QImage before = picture();
    const Material found = material();
    ValueSlider* slider = nullptr;
    for (auto* row : window().dock("parameters")->findChildren<ParameterRow*>()) {
        auto* candidate = row->findChild<ValueSlider*>();
        slider =
            !slider && row->isVisible() && candidate && candidate->isEnabled() ? candidate : slider;
    }
    ASSERT_NE(slider, nullptr);
    const int middle = slider->height() / 2;
    hand.drag(*slider, {slider->width() / 5, middle}, {slider->width() * 4 / 5, middle});
    EXPECT_NE(material(), found);
    EXPECT_EQ(steps(), 2);
    EXPECT_NE(picture(), before);
    hand.key(window(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(material(), found);
}

TEST_F(ArtistTask, ProductIsLit) {
    const QImage before = picture();
    const std::size_t lights = document().scene().lights.size();
    const auto buttons = window().dock("lights")->findChildren<QToolButton*>();
    const auto add = std::ranges::find(buttons, QString("Add"), &QToolButton::text);
    ASSERT_NE(add, buttons.end());
    hand.chooseInNextPopup({"Spot"});
    hand.click(**add);
    ASSERT_EQ(document().scene().lights.size(), lights + 1);
    const Light placed = document().scene().lights.back();
    Viewport& view = window().views().first().viewport();
    hand.click(view);
    QTest::keyPress(&view, Qt::Key_L);
    hand.click(view, QPoint(view.width() * 45 / 100, view.height() * 4 / 10));
    QTest::keyRelease(&view, Qt::Key_L);
    EXPECT_NE(document().scene().lights.back(), placed);
    EXPECT_NE(picture(), before);
}

TEST_F(ArtistTask, PresetChangedInAllItsVariants) {
    searchAnew("grey card");
    settle();
    ASSERT_EQ(count(), 1);
    hand.click(*view().viewport(), placeOf(0));
    hand.key(view(), Qt::Key_D, Qt::ControlModifier);
    ASSERT_TRUE(QTest::qWaitFor([this] { return count() == 2; }, waitMs));
    const int copy = shown(0).endsWith("copy") ? 0 : 1;
    hand.click(*view().viewport(), placeOf(copy));
    hand.key(view(), Qt::Key_D, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(QTest::qWaitFor([this] { return count() == 3; }, waitMs));
    hand.chooseInNextPopup({"Open to edit this file"});
    hand.click(*view().viewport(), placeOf(copy), {}, Qt::RightButton);
    ASSERT_TRUE(QTest::qWaitFor([this] { return nameOnA().endsWith("copy"); }, waitMs));
    const QImage before = picture();
    typeInto(*row("diffuse.color").findChild<HexBox*>(), "a04020");
    EXPECT_NE(picture(), before);
    hand.key(window(), Qt::Key_S, Qt::ControlModifier);
    ASSERT_TRUE(QTest::qWaitFor(
        [this] { return notice().text().contains("changed with its parent"); }, waitMs))
        << notice().text().toStdString();
    for (const PresetPtr& entry : window().dockContext().presets.entries()) {
        if (entry->name.endsWith("variant")) {
            EXPECT_EQ(entry->material.model, material().model);
        }
    }
}

/// The share of a picture's pixels that are red, as the energy view paints them.
double redShare(const QImage& image) {
    int red = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QRgb pixel = image.pixel(x, y);
            red += qRed(pixel) > 2 * qGreen(pixel) && qRed(pixel) > 2 * qBlue(pixel) ? 1 : 0;
        }
    }
    return double(red) / (image.width() * image.height());
}

TEST_F(ArtistTask, TooBrightMetalIsMended) {
    document().setModel(Side::A, "phong");
    document().setValues(document().selection().currentPath(kinds::models),
                         {{"diffuse.color", glm::dvec3(0.9, 0.7, 0.4)},
                          {"specular.color", glm::dvec3(1.0, 0.8, 0.5)},
                          {"shininess", 8.0}},
                         "A metal");
    const QImage before = picture();
    const int made = steps();
    Viewport& view = window().views().first().viewport();
    hand.click(view);
    hand.key(view, Qt::Key_E, Qt::ShiftModifier);
    EXPECT_TRUE(QTest::qWaitFor([&] { return redShare(view.grabPicture()) > 0.05; }, waitMs));
    typeInto(*row("diffuse.color").findChild<HexBox*>(), "000000"); // a metal has no matte light
    EXPECT_TRUE(QTest::qWaitFor([&] { return redShare(view.grabPicture()) == 0.0; }, waitMs));
    hand.click(view);
    hand.key(view, Qt::Key_E, Qt::ShiftModifier);
    EXPECT_EQ(steps(), made + 1);
    EXPECT_NE(picture(), before);
}

TEST_F(ArtistTask, ToonWithARampOfItsOwn) {
    chooseModel("Toon");
    hand.click(*row("tones").findChild<QComboBox*>());
    ASSERT_TRUE(QTest::qWaitFor([] { return QApplication::activePopupWidget() != nullptr; }));
    hand.key(*QApplication::activePopupWidget(), Qt::Key_End);
    hand.key(*QApplication::activePopupWidget(), Qt::Key_Return);
    const QImage before = picture();
    const Value ramp = value("tone.ramp");
    ParameterRow& tones = row("tone.ramp");
    hand.click(*tones.findChild<PreviewButton*>());
    auto* area = tones.findChild<HandleArea*>();
    ASSERT_NE(area, nullptr);
    ASSERT_TRUE(QTest::qWaitForWindowExposed(area->window()));
    const auto at = [area](double x) { return area->pixelOf(Handle{x, 0.0, {}}).toPoint(); };
    const std::size_t stops = area->handles().size();
    hand.click(*area, at(0.9));
    hand.drag(*area, at(0.74), at(0.45));
    EXPECT_EQ(area->handles().size(), stops + 1);
    hand.key(*area, Qt::Key_Escape);
    EXPECT_NE(value("tone.ramp"), ramp);
    EXPECT_EQ(steps(), 4);
    EXPECT_NE(picture(), before);
}

TEST_F(ArtistTask, ImageOfMarbleIsSwapped) {
    search("marble");
    settle();
    hand.key(PresetWindow::search(), Qt::Key_Return);
    const std::string file = imageOf();
    ASSERT_NE(file, "");
    const QImage before = picture();
    QImage other(16, 16, QImage::Format_RGB32);
    other.fill(Qt::darkGreen);
    const fs::path replaced = home("XDG_DATA_HOME") / "green.png";
    fs::create_directories(replaced.parent_path());
    other.save(QString::fromStdString(replaced.string()));
    answerFileDialog(replaced);
    auto* line = window().dock("parameters")->findChild<TextureLine*>();
    hand.click(*line->findChild<QToolButton*>());
    ASSERT_TRUE(QTest::qWaitFor([&] { return imageOf() == replaced.string(); }, waitMs));
    EXPECT_TRUE(QTest::qWaitFor([&] { return picture() != before; }, waitMs));
    hand.key(window(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(imageOf(), file);
}

TEST_F(ArtistTask, SheetIsMadeAndACellTaken) {
    hand.key(*view().viewport(), Qt::Key_K, Qt::ControlModifier);
    auto* search = window().findChild<QDialog*>("commandPalette")->findChild<QLineEdit*>();
    hand.type(*search, "contact sheet");
    hand.key(*search, Qt::Key_Return);
    settle();
    auto* panel = window().findChild<SheetsDock*>();
    ASSERT_TRUE(panel != nullptr && panel->isVisible());
    ASSERT_TRUE(QTest::qWaitFor([&] { return panel->isIdle(); }, waitMs));
    const QImage before = picture();
    auto& grid = *panel->findChild<SheetGrid*>();
    const int stepsBefore = steps();
    hand.click(*grid.viewport(), grid.visualRect(grid.table().index(0, 0)).center());
    EXPECT_EQ(steps(), stepsBefore + 1);
    EXPECT_NE(picture(), before);
}

TEST_F(ArtistTask, ComparisonIsExported) {
    hand.key(window(), Qt::Key_B, Qt::ControlModifier);
    search("copper");
    settle();
    hand.click(window().views().view(Side::B)->viewport());
    hand.doubleClick(*view().viewport(), placeOf(0));
    ASSERT_NE(picture(Side::A), picture(Side::B));
    const fs::path file = home("XDG_DATA_HOME") / "two.html";
    answerFileDialog(file);
    hand.key(window(), Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(QTest::qWaitFor([&] { return fs::exists(file); }, waitMs));
    EXPECT_NE(readFile(file).find(material(Side::B).name), std::string::npos);
}

} // namespace
} // namespace patina::tests::artist_tasks_test
