// SPDX-License-Identifier: GPL-3.0-or-later
// The reflectance of what is on screen, as plots.
#include <algorithm>
#include <numbers>
#include <regex>
#include <sstream>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QDropEvent>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QRegularExpression>
#include <QTabWidget>
#include <QTest>
#include <QToolButton>
#include <QUrl>

#include "accuracy/plot_library.h"
#include "core/color.h"
#include "document/compare_edits.h"
#include "document/scene_edits.h"
#include "document/snapshot_edits.h"
#include "lobe/energy_bar.h"
#include "lobe/lobe_dock.h"
#include "lobe/lobe_subjects.h"
#include "lobe/picked_incidence.h"
#include "lobe/polar_plot.h"
#include "lobe/share_plot.h"
#include "lobe/slice_plot.h"
#include "lobe/solid_plot.h"
#include "shading/effects/key_light.h"
#include "text/display_number.h"
#include "ui/fixtures.h"
#include "ui/window_fixture.h"
#include "viewport/frame_loop.h"
#include "viewport/light_pose.h"

namespace patina::tests::lobe_test {
namespace {

constexpr int waitMs = 20000;

/// Names the tabs of the dock.
enum Tab { Polar, Solid, Albedo, Fresnel, Spectrum, Slice, Float32, Float16 };

class LobePanel : public WindowFixture {
  protected:
    LobePanel() {
        document().setModel(Side::A, "phong");
        window().dock("lobe")->show();
        window().dock("lobe")->raise();
        settle();
    }

    LobeDock& dock() { return *window().dock("lobe")->findChild<LobeDock*>(); }
    PolarPlot& polar() { return *dock().findChild<PolarPlot*>(); }
    SharePlot& albedo() { return *dock().findChild<SharePlot*>("albedoPlot"); }
    SolidPlot& solid() { return *dock().findChild<SolidPlot*>(); }
    SlicePlot& slice() { return *dock().findChild<SlicePlot*>(); }
    SharePlot& fresnel() { return *dock().findChild<SharePlot*>("fresnelPlot"); }
    SharePlot& spectrum() { return *dock().findChild<SharePlot*>("spectrumPlot"); }
    EnergyBar& energy() { return *dock().findChild<EnergyBar*>(); }
    QString note() { return dock().findChild<QLabel*>("note")->text(); }
    void openTab(Tab index) { dock().findChild<QTabWidget*>()->setCurrentIndex(index); }
    bool wait() {
        return QTest::qWaitFor([this] { return dock().isUpToDate(); }, waitMs);
    }
    /// Drops presets on the dock at once, by their paths in the folder of presets.
    void drop(const QStringList& presets) {
        QMimeData files;
        QList<QUrl> urls;
        for (const QString& preset : presets) {
            urls << QUrl::fromLocalFile(PATINA_SOURCE_DIR "/presets/" + preset + ".patina.json");
        }
        files.setUrls(urls);
        QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &files, Qt::LeftButton,
                              Qt::NoModifier);
        QApplication::sendEvent(&dock(), &enter);
        EXPECT_TRUE(enter.isAccepted());
        QDropEvent drop(QPointF(50.0, 50.0), Qt::CopyAction, &files, Qt::LeftButton,
                        Qt::NoModifier);
        QApplication::sendEvent(&dock(), &drop);
    }
    void set(const char* id, const Value& value) {
        document().setValue(document().selection().currentPath(kinds::models), id, value);
    }
};

double peakOf(const LobeSubject& subject) {
    double peak = 0.0;
    for (const glm::dvec3& v : subject.lines.lines.front().values) {
        peak = std::max(peak, v.x);
    }
    return peak;
}

TEST_F(LobePanel, Shown_PlotsTheMaterialOnScreen) {
    ASSERT_TRUE(wait());
    ASSERT_EQ(polar().subjects().size(), 1u);
    EXPECT_EQ(polar().subjects().front().name, "A");
    set("specular.color", glm::dvec3(0.1));
    ASSERT_TRUE(wait());
    const double before = peakOf(polar().subjects().front());
    set("specular.color", glm::dvec3(1.0));
    ASSERT_TRUE(wait());
    EXPECT_GT(peakOf(polar().subjects().front()), 2.0 * before);
}

TEST_F(LobePanel, Hidden_ComputesNothing) {
    set("specular.color", glm::dvec3(0.1));
    ASSERT_TRUE(wait());
    const double before = peakOf(polar().subjects().front());
    window().dock("lobe")->hide();
    set("specular.color", glm::dvec3(1.0));
    settle();
    EXPECT_EQ(peakOf(polar().subjects().front()), before);
    EXPECT_FALSE(dock().isComputing());
    window().dock("lobe")->show();
    window().dock("lobe")->raise();
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return peakOf(polar().subjects().front()) > 2.0 * before; }, waitMs));
}

TEST_F(LobePanel, HiddenWhileItComputes_GivesUp) {
    ASSERT_TRUE(wait());
    document().setModel(Side::A, "poulin-fournier");
    openTab(Albedo); // takes seconds
    EXPECT_TRUE(dock().isComputing());
    window().dock("lobe")->hide();
    EXPECT_FALSE(dock().isComputing());
}

TEST_F(LobePanel, Compared_OverlaysBAndSnapshots) {
    takeSnapshot(document(), {});
    setSecondMaterial(document(), defaultMaterial(*document().catalog().find("models", "lambert")));
    ASSERT_TRUE(wait());
    ASSERT_EQ(polar().subjects().size(), 2u);
    EXPECT_EQ(polar().subjects().back().name, "B");
    dock().findChild<QToolButton*>("snapshots overlaid")->click();
    ASSERT_TRUE(wait());
    ASSERT_EQ(polar().subjects().size(), 3u);
    EXPECT_EQ(polar().subjects().back().name, document().state().snapshots.front().name);
}

TEST_F(LobePanel, Tick_ComputesOnlyTheCurveThatItChanges) {
    for (int i = 0; i < 3; ++i) {
        takeSnapshot(document(), {});
    }
    dock().findChild<QToolButton*>("snapshots overlaid")->click();
    for (const Tab tab : {Polar, Solid, Albedo, Slice}) {
        openTab(tab);
        ASSERT_TRUE(wait());
        const int before = dock().computed();
        set("specular.color", glm::dvec3(0.1 + 0.01 * int(tab)));
        ASSERT_TRUE(wait());
        EXPECT_GT(dock().computed(), before) << tab;
        EXPECT_LE(dock().computed(), before + 2) << tab; // a sketch, and the whole
    }
    EXPECT_EQ(slice().slices().size(), 4u);
    const int before = dock().computed();
    openTab(Polar);
    QTest::keyClick(&polar(), Qt::Key_Left); // the light is another for all of them
    ASSERT_TRUE(wait());
    EXPECT_GE(dock().computed(), before + 4);
}

TEST_F(LobePanel, DroppedPreset_IsOverlaidUntilItIsTakenAway) {
    ASSERT_TRUE(wait());
    drop({"cook-torrance/gold"});
    ASSERT_TRUE(wait());
    ASSERT_EQ(polar().subjects().size(), 2u);
    EXPECT_EQ(document().undoStack().index(), 1); // the model; a drop on the plot is no edit
    dock().findChild<QToolButton*>("forget presets")->click();
    ASSERT_TRUE(wait());
    EXPECT_EQ(polar().subjects().size(), 1u);
}

TEST_F(LobePanel, SixthMaterial_HasNoRoomAndTheNoteSaysSo) {
    drop({"cook-torrance/gold", "strauss/brass", "strauss/gunmetal", "strauss/red-plastic",
          "strauss/frosted-steel"});
    ASSERT_TRUE(wait());
    EXPECT_EQ(polar().subjects().size(), 5u);
    EXPECT_TRUE(note().contains("No room for Frosted")) << note().toStdString();
    set("specular.color", glm::dvec3(0.5)); // what came next
    ASSERT_TRUE(wait());
    EXPECT_FALSE(note().contains("No room")) << note().toStdString();
}

TEST_F(LobePanel, MaterialWithoutAnAnswer_LeavesTheOthersTheirSketches) {
    drop({"toon/poster"});
    ASSERT_TRUE(wait());
    EXPECT_TRUE(note().contains("no share of the light")) << note().toStdString();
    const double before = peakOf(polar().subjects().front());
    double color = 0.1;
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { // values that never rest
            color += 0.001;
            set("specular.color", glm::dvec3(color));
            return peakOf(polar().subjects().front()) != before;
        },
        waitMs));
    EXPECT_FALSE(dock().isUpToDate());
}

TEST_F(LobePanel, MaterialWithoutAnAnswer_LeavesTheOthersTheirColoursAndTheBarItsOwn) {
    document().setModel(Side::A, "toon");
    drop({"cook-torrance/gold", "strauss/brass"});
    openTab(Albedo);
    ASSERT_TRUE(wait());
    ASSERT_EQ(albedo().subjects().size(), 3u);
    EXPECT_TRUE(albedo().subjects().front().lines.lines.empty());
    EXPECT_EQ(albedo().subjects()[1].name, "Gold, satin");
    const QString drawing = albedo().svg();
    const auto isDrawnIn = [&](std::size_t place) { // other than as a text
        return drawing.contains(QRegularExpression(
            "stroke=\"" + lobeColor(place, albedo().palette()).name() + "\"[^>]*>\\s*<(?!text)"));
    };
    EXPECT_FALSE(isDrawnIn(0));
    EXPECT_TRUE(isDrawnIn(1));
    EXPECT_TRUE(isDrawnIn(2));
    EXPECT_TRUE(energy().text().startsWith("A: ")) << energy().text().toStdString();
    EXPECT_TRUE(energy().text().contains("no share of the light")) << energy().text().toStdString();
}

TEST_F(LobePanel, Drag_TurnsTheLight) {
    ASSERT_TRUE(wait());
    QWidget* canvas = polar().childAt(polar().rect().center());
    const QPoint place = canvas->mapFrom(&polar(), polar().edgeAt(-60.0).toPoint());
    QTest::mousePress(canvas, Qt::LeftButton, {}, place);
    QTest::mouseRelease(canvas, Qt::LeftButton, {}, place);
    EXPECT_NEAR(polar().light(), 60.0, 1.0);
    ASSERT_TRUE(wait());
    const LobeLine& line = polar().subjects().front().lines.lines.front();
    const auto peak = std::ranges::max_element(line.values, {}, &glm::dvec3::x);
    const double at = line.at[std::size_t(peak - line.values.begin())];
    EXPECT_NEAR(at, polar().light(), 1.0);
    QTest::keyClick(&polar(), Qt::Key_Right);
    EXPECT_NEAR(polar().light(), 59.0, 1.0);
}

TEST_F(LobePanel, Pointer_ReadsValuesWithTheirUnit) {
    ASSERT_TRUE(wait());
    const QPointF middle = 0.5 * (polar().edgeAt(0.0) + polar().edgeAt(10.0));
    const QString reading = polar().readingAt(middle);
    EXPECT_TRUE(reading.contains("from the normal")) << reading.toStdString();
    EXPECT_TRUE(reading.contains("A, reflectance")) << reading.toStdString();
    EXPECT_TRUE(reading.endsWith("1/sr")) << reading.toStdString();
    EXPECT_EQ(polar().readingAt({-5.0, -5.0}), "");
}

TEST_F(LobePanel, Albedo_HasAnEnergyBarThatKnowsTooMuchLight) {
    set("diffuse.color", glm::dvec3(0.5));
    set("specular.color", glm::dvec3(0.0));
    openTab(Albedo);
    ASSERT_TRUE(wait());
    EXPECT_FALSE(energy().isAboveOne());
    EXPECT_TRUE(energy().text().contains("50 %")) << energy().text().toStdString();
    const QString red = QColor(220, 70, 60).name(); // of the line of 1
    EXPECT_FALSE(QString(albedo().svg()).contains(red));
    set("specular.color", glm::dvec3(1.0));
    set("diffuse.color", glm::dvec3(1.0));
    ASSERT_TRUE(wait());
    EXPECT_TRUE(energy().isAboveOne());
    EXPECT_TRUE(energy().text().contains("more than arrives"));
    EXPECT_TRUE(QString(albedo().svg()).contains(red));
}

TEST_F(LobePanel, NumbersBesideAPlot_AreThoseOfItsCurves) {
    document().setModel(Side::A, "lambert");
    set("diffuse.color", glm::dvec3(0.8, 0.4, 0.2));
    openTab(Albedo);
    ASSERT_TRUE(wait());
    EXPECT_TRUE(energy().text().contains("20 % (blue) at least")) << energy().text().toStdString();
    EXPECT_TRUE(energy().text().contains("80 % (red) at most")) << energy().text().toStdString();
    drop({"cook-torrance/gold"}); // now curves are luminances, of Rec. 709's weights
    ASSERT_TRUE(wait());
    const QString share = shareText(luminance(glm::dvec3(0.8, 0.4, 0.2)));
    EXPECT_TRUE(energy().text().contains(share + " at least")) << energy().text().toStdString();
    EXPECT_TRUE(energy().text().contains(share + " at most")) << energy().text().toStdString();
    EXPECT_TRUE(energy().text().endsWith("in luminance")) << energy().text().toStdString();
    EXPECT_TRUE(QString(albedo().svg()).contains("albedo, luminance"));
    const QString reading = albedo().readingAt(QRectF(albedo().rect()).center());
    EXPECT_TRUE(reading.contains("(0.8, 0.4, 0.2)")) << reading.toStdString();
    EXPECT_TRUE(reading.contains("luminance 0.4")) << reading.toStdString();
    EnergyBar bar;
    EnergyRange channels; // above all light in blue alone, below it in luminance
    channels.max = {0.1, 0.1, 1.2};
    EnergyRange grey;
    grey.max = glm::dvec3(luminance(channels.max));
    bar.setRange(channels, grey);
    EXPECT_TRUE(bar.isAboveOne());
    EXPECT_TRUE(bar.text().endsWith("120 % (blue): more than arrives")) << bar.text().toStdString();
}

TEST_F(LobePanel, Fresnel_OfAMetalIsPlotted) {
    document().setModel(Side::A, "cook-torrance");
    document().setBlock(document().selection().currentPath(kinds::fresnel), "dielectric");
    openTab(Fresnel);
    ASSERT_TRUE(wait());
    ASSERT_EQ(fresnel().subjects().size(), 1u);
    EXPECT_EQ(fresnel().subjects().front().lines.marks.size(), 3u);
}

TEST(FresnelPlot, NamesOfAngles_CoverEachOtherNowhere) {
    std::vector<LobeSubject> subjects(5);
    for (std::size_t i = 0; i < subjects.size(); ++i) {
        const double shift = 0.4 * static_cast<double>(i);
        subjects[i].lines.marks = {{"Brewster", 56.3 + shift},
                                   {"Brewster from inside", 33.7 - shift},
                                   {"critical from inside", 41.8 + shift}};
    }
    SharePlot plot(LobePlot::Fresnel);
    plot.resize(480, 200); // has no room for all 15
    plot.setSubjects(subjects);
    plot.grab(); // lays it out
    plot.svg();
    const auto* canvas = plot.findChild<QCustomPlot*>();
    std::vector<QRectF> areas;
    for (int i = 0; i < canvas->itemCount(); ++i) {
        const auto* name = qobject_cast<QCPItemText*>(canvas->item(i));
        if (name != nullptr && name->visible() && name->text().contains(QChar(0x00b0))) {
            areas.push_back(
                QRectF(name->topLeft->pixelPosition(), name->bottomRight->pixelPosition())
                    .adjusted(1.0, 1.0, -1.0, -1.0));
        }
    }
    EXPECT_GE(areas.size(), 5u);
    EXPECT_LT(areas.size(), 15u);
    for (std::size_t i = 0; i < areas.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            EXPECT_FALSE(areas[i].intersects(areas[k])) << i << " and " << k;
        }
    }
}

TEST_F(LobePanel, Spectrum_ReadsTheIndexByWavelength) {
    document().setModel(Side::A, "cook-torrance");
    document().setBlock(document().selection().currentPath(kinds::fresnel), "dispersive");
    openTab(Spectrum);
    ASSERT_TRUE(wait());
    ASSERT_EQ(spectrum().subjects().size(), 1u);
    EXPECT_EQ(spectrum().subjects().front().lines.marks.size(), 3u);
    const QString reading = spectrum().readingAt(QRectF(spectrum().rect()).center());
    EXPECT_TRUE(reading.contains(" nm\n")) << reading.toStdString();
    EXPECT_TRUE(reading.contains("index n: 1.5")) << reading.toStdString();
}

TEST_F(LobePanel, Float32_ComparesTheDeviceWithDouble) {
    openTab(Float32);
    ASSERT_TRUE(wait());
    auto& plot = *dock().findChild<SharePlot*>("float32Plot");
    ASSERT_EQ(plot.subjects().size(), 1u);
    EXPECT_TRUE(note().contains("units in the last place")) << note().toStdString();
}

TEST_F(LobePanel, Float16_ComparesSixteenBitsWithDouble) {
    openTab(Float16);
    ASSERT_TRUE(wait());
    ASSERT_EQ(dock().findChild<SharePlot*>("float16Plot")->subjects().size(), 1u);
    EXPECT_TRUE(note().contains("last place of 16 bits")) << note().toStdString();
}

TEST_F(LobePanel, PickedPlace_GivesItsLightAndItsViewer) {
    ASSERT_TRUE(wait());
    dock().findChild<QToolButton*>("pick incidence")->click();
    QTest::mouseClick(&view(), Qt::LeftButton, {}, view().rect().center());
    ASSERT_TRUE(wait());
    EXPECT_TRUE(note().contains("Picked: light")) << note().toStdString();
    QTest::keyClick(&polar(), Qt::Key_Left); // the light is turned by hand
    ASSERT_TRUE(wait());
    EXPECT_FALSE(note().contains("Picked")) << note().toStdString();
    EXPECT_EQ(document().undoStack().index(), 1); // the model alone
}

TEST_F(LobePanel, Incidence_IsInTheFrameOfTheSurface) {
    const Scene& scene = document().scene();
    const auto light = keyLight(scene, document().catalog());
    ASSERT_TRUE(light);
    const Block& block = *document().catalog().find(kinds::lights, scene.lights[*light].block.id);
    const auto pose = lightPose(scene.lights[*light].block.parameters, block, scene.camera);
    ASSERT_TRUE(pose);
    Hit hit;
    hit.point = scene.camera.pivot;
    const glm::dvec3 l =
        pose->hasPoint() ? glm::normalize(pose->point - hit.point) : -*pose->direction;
    const glm::dvec3 v = glm::normalize(eye(scene.camera) - hit.point);
    // The mirror of the light to the eye has both in one plane at the same angle.
    hit.normal = glm::normalize(l + v);
    const auto mirror = incidenceAt(hit, scene, document().catalog(), scene.camera, *light);
    ASSERT_TRUE(mirror);
    const double half = 0.5 * std::acos(glm::dot(l, v));
    EXPECT_NEAR(mirror->incoming().angle, half, 1e-9);
    EXPECT_NEAR(mirror->viewerDegrees(), half * 180.0 / std::numbers::pi, 1e-6);
    EXPECT_NEAR(mirror->outOfPlane(), 0.0, 1e-6);
    hit.normal = -l;
    EXPECT_FALSE(incidenceAt(hit, scene, document().catalog(), scene.camera, *light));
}

TEST_F(LobePanel, Time_SaysNanosecondsAndWhatIsNotInTheProgram) {
    ASSERT_TRUE(wait());
    set("emissive.color", glm::dvec3(0.0));
    drop({"toon/poster"}); // has a reason for no line, which stays
    ASSERT_TRUE(wait());
    auto* time = dock().findChild<QToolButton*>("time");
    time->click();
    EXPECT_FALSE(time->isEnabled());
    ASSERT_TRUE(QTest::qWaitFor([this] { return !dock().isTiming(); }, 6 * waitMs));
    EXPECT_TRUE(time->isEnabled());
    EXPECT_TRUE(note().contains("ns/pixel") || note().contains("too quick"))
        << note().toStdString();
    EXPECT_TRUE(note().contains("program")) << note().toStdString();
    EXPECT_TRUE(note().contains("no share of the light")) << note().toStdString();
    removeLight(document(), 0);
    EXPECT_FALSE(note().contains("program")) << "times are those of the lights that were there";
    time->click();
    window().dock("lobe")->hide();
    EXPECT_FALSE(dock().isTiming());
    EXPECT_TRUE(time->isEnabled());
}

TEST_F(LobePanel, Slice_ReadsTheReflectanceOverBothAngles) {
    document().setModel(Side::A, "lambert");
    set("diffuse.color", glm::dvec3(0.5));
    openTab(Slice);
    ASSERT_TRUE(wait());
    ASSERT_EQ(slice().slices().size(), 1u);
    const QRectF square = slice().squareOf(0);
    const QPointF near = square.bottomLeft() + QPointF(0.1, -0.1) * square.width();
    const QString reading = slice().readingAt(near);
    EXPECT_TRUE(reading.contains("half vector 9")) << reading.toStdString();
    EXPECT_TRUE(reading.contains("A: 0.159 1/sr")) << reading.toStdString(); // 0.5/pi
    EXPECT_EQ(slice().readingAt({-5.0, -5.0}), "");
    dock().exportTo(QString::fromStdString(home("slice.csv").string()));
    EXPECT_TRUE(readFile(home("slice.csv")).starts_with("material,half_degrees,"));
}

TEST_F(LobePanel, Solid_IsTurnedByADragAndReadsTheViewersDirection) {
    openTab(Solid);
    ASSERT_TRUE(wait());
    ASSERT_EQ(solid().solids().size(), 1u);
    // The peak of the lobe is as long as the room allows.
    const double light = polar().light() * std::numbers::pi / 180.0;
    const QPointF middle = solid().placeOf({-0.7 * std::sin(light), 0.0, 0.7 * std::cos(light)});
    const QString reading = solid().readingAt(middle);
    EXPECT_TRUE(reading.contains("from the tangent")) << reading.toStdString();
    EXPECT_TRUE(reading.endsWith("1/sr")) << reading.toStdString();
    EXPECT_EQ(solid().readingAt({1.0, 1.0}), "");
    const double turn = solid().turn();
    const double tilt = solid().tilt();
    const QPoint from = solid().rect().center();
    QTest::mousePress(&solid(), Qt::LeftButton, {}, from);
    QMouseEvent drag(QEvent::MouseMove, from + QPoint(20, 10),
                     solid().mapToGlobal(from + QPoint(20, 10)), Qt::NoButton, Qt::LeftButton,
                     Qt::NoModifier);
    QApplication::sendEvent(&solid(), &drag);
    EXPECT_NEAR(solid().turn(), turn - 10.0, 1e-9);
    EXPECT_NEAR(solid().tilt(), tilt + 5.0, 1e-9);
    QTest::keyClick(&solid(), Qt::Key_Down);
    EXPECT_NEAR(solid().tilt(), tilt, 1e-9);
    for (const char* name : {"solid.svg", "solid.png", "solid.csv"}) {
        dock().exportTo(QString::fromStdString(home(name).string()));
    }
    EXPECT_NE(readFile(home("solid.svg")).find("<svg"), std::string::npos);
    EXPECT_TRUE(readFile(home("solid.png")).starts_with("\x89PNG"));
    EXPECT_TRUE(readFile(home("solid.csv")).starts_with("material,viewer_degrees,"));
}

TEST_F(LobePanel, DrawingModel_HasNoPlotOverViewersOrHalfAngles) {
    document().setModel(Side::A, "toon");
    for (const Tab tab : {Solid, Slice}) {
        openTab(tab);
        ASSERT_TRUE(wait());
        EXPECT_TRUE(note().contains("no share of the light")) << note().toStdString();
    }
    EXPECT_TRUE(solid().solids().front().solid.f.empty());
    EXPECT_TRUE(slice().slices().front().slice.cells.empty());
    EXPECT_EQ(solid().readingAt(solid().placeOf({0.0, 0.0, 0.1})), "");
    EXPECT_EQ(slice().readingAt(slice().squareOf(0).center()), "");
}

TEST_F(LobePanel, DrawingModel_SaysThatThePlotMeansNothing) {
    document().setModel(Side::A, "toon");
    ASSERT_TRUE(wait());
    EXPECT_TRUE(polar().subjects().front().lines.lines.empty());
    EXPECT_TRUE(note().contains("no share of the light")) << note().toStdString();
    EXPECT_TRUE(note().contains("its albedo")) << note().toStdString();
    EXPECT_TRUE(dock().findChild<QLabel*>("note")->accessibleDescription() == note());
    openTab(Float16);
    ASSERT_TRUE(wait());
    EXPECT_TRUE(note().contains("of 16 bits mean nothing")) << note().toStdString();
}

/// Returns the width over the height of the widest line of a drawing that is not straight.
double widestForm(const std::string& svg) {
    double widest = 0.0;
    double form = 0.0;
    static const std::regex line("points=\"([^\"]*)\"");
    for (std::sregex_iterator each(svg.begin(), svg.end(), line), end; each != end; ++each) {
        std::string numbers = (*each)[1].str();
        std::ranges::replace(numbers, ',', ' ');
        std::istringstream in(numbers);
        QRectF box;
        double x = 0.0;
        double y = 0.0;
        while (in >> x >> y) {
            box = box.isNull() ? QRectF(x, y, 1e-6, 1e-6) : box.united({x, y, 1e-6, 1e-6});
        }
        if (box.height() > 1.0 && box.width() > widest) {
            widest = box.width();
            form = box.width() / box.height();
        }
    }
    return form;
}

TEST_F(LobePanel, ExportedDisc_IsRoundInADockOfAnyForm) {
    ASSERT_TRUE(wait());
    polar().resize(900, 200);
    dock().exportTo(QString::fromStdString(home("disc.svg").string()));
    EXPECT_NEAR(widestForm(readFile(home("disc.svg"))), 2.0, 0.02);
}

TEST_F(LobePanel, Export_WritesEachForm) {
    ASSERT_TRUE(wait());
    const auto file = [this](const char* name) { return home(name); };
    for (const char* name : {"lobe.svg", "lobe.png", "lobe.csv"}) {
        dock().exportTo(QString::fromStdString(file(name).string()));
    }
    EXPECT_NE(readFile(file("lobe.svg")).find("<svg"), std::string::npos);
    EXPECT_TRUE(readFile(file("lobe.png")).starts_with("\x89PNG"));
    EXPECT_TRUE(readFile(file("lobe.csv")).starts_with("material,line,degrees"));
}

/// What a view shows in place of the picture: one thing, or nothing again.
TEST_F(LobePanel, ThingsInPlaceOfThePicture_AreShownOneAtATime) {
    QAction* energy = window().findChild<QAction*>("show energy");
    QAction* normals = window().findChild<QAction*>("show normals");
    QAction* numbers = window().findChild<QAction*>("inspect");
    const auto title = [this] { return view().findChild<QLabel*>("inspected")->text(); };
    energy->trigger();
    EXPECT_TRUE(view().frames().isInspecting());
    EXPECT_TRUE(title().startsWith("Energy"));
    normals->trigger();
    EXPECT_FALSE(energy->isChecked());
    EXPECT_TRUE(title().startsWith("Normals"));
    numbers->trigger();
    EXPECT_FALSE(normals->isChecked());
    EXPECT_EQ(title(), "");
    numbers->trigger();
    EXPECT_FALSE(view().frames().isInspecting());
}

/// The lights are those of the scene now; without the light that is shown there is the picture.
TEST_F(LobePanel, EachLightAlone_IsShownByItsName) {
    auto* lights = window().findChild<QMenu*>("show light");
    ASSERT_NE(lights, nullptr);
    const auto open = [lights] { Q_EMIT lights->aboutToShow(); };
    open();
    const auto count = static_cast<qsizetype>(document().state().scene.lights.size());
    ASSERT_EQ(lights->actions().size(), count);
    lights->actions().last()->trigger();
    EXPECT_TRUE(view().frames().isInspecting());
    EXPECT_TRUE(
        view().findChild<QLabel*>("inspected")->text().contains(lights->actions().last()->text()));
    open();
    EXPECT_TRUE(lights->actions().last()->isChecked());
    removeLight(document(), static_cast<int>(count) - 1);
    EXPECT_FALSE(view().frames().isInspecting());
    open();
    EXPECT_EQ(lights->actions().size(), count - 1);
}

} // namespace
} // namespace patina::tests::lobe_test
