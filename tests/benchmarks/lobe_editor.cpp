// SPDX-License-Identifier: GPL-3.0-or-later
// The editor's dock Lobe with four materials, one of which changes: the time from a slider's tick
// to the plot that is painted. The views draw nothing with GALLIUM_NOOP=1, so that what is left is
// the plot's; nor are small pictures of presets, in whose threads that driver dies.
// patina-lobe-editor: prints a line "number limit unit what" per figure.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include <QApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QKeyEvent>
#include <QTabWidget>
#include <QToolButton>

#include "catalog/catalog.h"
#include "document/compare_edits.h"
#include "document/snapshot_edits.h"
#include "lobe/lobe_dock.h"
#include "lobe/polar_plot.h"
#include "measure/match/model_matches.h"
#include "window/main_window.h"

namespace {

using namespace patina;

constexpr int limitMs = 240000; // whole albedo curves of slow models take long
constexpr int warming = 5;
constexpr int ticks = 41;
constexpr double maxTick = 16.0; ///< ms
constexpr std::size_t overlaid = 4;

bool waitFor(const std::function<bool()>& done) {
    QElapsedTimer time;
    time.start();
    while (!done() && time.elapsed() < limitMs) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
    return done();
}

/// Sees when a widget is painted.
class PaintCount : public QObject {
  public:
    int count() const { return count_; }

  protected:
    bool eventFilter(QObject* /*watched*/, QEvent* event) override {
        count_ += event->type() == QEvent::Paint ? 1 : 0;
        return false;
    }

  private:
    int count_ = 0;
};

/// Overlays the model with three snapshots of it.
void overlay(Document& document, const Block& model) {
    document.setModel(Side::A, model.id);
    while (!document.state().snapshots.empty()) {
        removeSnapshot(document, 0);
    }
    while (document.state().snapshots.size() + 1 < overlaid) {
        takeSnapshot(document, {});
    }
}

/// Returns the median time in milliseconds from a tick to the painted plot; negative where none
/// came.
double tickTime(const std::function<void(int)>& tick, const PaintCount& paints) {
    std::vector<double> times;
    for (int i = 0; i < warming + ticks; ++i) {
        const int painted = paints.count();
        QElapsedTimer time;
        time.start();
        tick(i);
        if (!waitFor([&] { return paints.count() > painted; })) {
            return -1.0;
        }
        if (i >= warming) {
            times.push_back(1e-6 * double(time.nsecsElapsed()));
        }
    }
    std::ranges::sort(times);
    return times[times.size() / 2];
}

/// Says how long ticks of a tab take, over all models.
struct TabTimes {
    std::vector<double> all;
    double slowest = 0.0;
    std::string slowestModel;

    void add(double time, const std::string& model) {
        all.push_back(time);
        if (time > slowest) {
            slowest = time;
            slowestModel = model;
        }
    }

    void print(const std::string& what) {
        std::ranges::sort(all);
        std::printf("%.2f %g ms %s, median of the models\n", all[all.size() / 2], maxTick,
                    what.c_str());
        std::printf("%.2f %g ms %s, slowest: %s\n", slowest, maxTick, what.c_str(),
                    slowestModel.c_str());
    }
};

bool measure(MainWindow& window, const Catalog& catalog) {
    QDockWidget& dock = *window.dock("lobe");
    dock.show();
    dock.raise();
    auto& lobe = *dock.findChild<LobeDock*>();
    auto& pages = *lobe.findChild<QTabWidget*>();
    lobe.findChild<QToolButton*>("snapshots overlaid")->click();
    Document& document = window.document();
    std::string color;
    const auto setColor = [&document, &color](int step) {
        document.setValue(document.selection().currentPath(kinds::models), color,
                          glm::dvec3(0.2 + 0.01 * step));
    };
    auto& polar = *lobe.findChild<PolarPlot*>();
    const auto turnLight = [&polar](int step) {
        QKeyEvent key(QEvent::KeyPress, step % 2 == 0 ? Qt::Key_Left : Qt::Key_Right, {});
        QApplication::sendEvent(&polar, &key);
    };
    struct Case {
        const char* what;
        const char* widget;
        std::function<void(int)> tick;
    };
    const Case cases[] = {{"lobe, a colour", "polarPlot", setColor},
                          {"lobe, the light", "polarPlot", turnLight},
                          {"3D, a colour", "solidPlot", setColor},
                          {"albedo, a colour", "albedoPlot", setColor},
                          {"half angle, a colour", "slicePlot", setColor}};
    for (const Case& each : cases) {
        auto* plot = lobe.findChild<QWidget*>(each.widget);
        for (int tab = 0; tab < pages.count(); ++tab) {
            if (pages.widget(tab) == plot || pages.widget(tab)->isAncestorOf(plot)) {
                pages.setCurrentIndex(tab);
            }
        }
        PaintCount paints;
        auto* canvas = plot->findChild<QWidget*>({}, Qt::FindDirectChildrenOnly);
        (canvas != nullptr ? canvas : plot)->installEventFilter(&paints);
        TabTimes times;
        for (const Block* model : matchedModels(catalog)) {
            overlay(document, *model);
            color = std::ranges::find_if(model->parameters, [](const Parameter& parameter) {
                        return infoOf(parameter.type).isColor;
                    })->id;
            if (!waitFor([&lobe] { return lobe.isUpToDate(); })) {
                return false;
            }
            const double time = tickTime(each.tick, paints);
            if (time < 0.0) {
                return false;
            }
            times.add(time, model->id);
        }
        times.print(each.what);
        std::fflush(stdout);
    }
    return true;
}

} // namespace

int main(int argc, char** argv) {
    QCoreApplication::setApplicationName("patina-lobe-editor");
    QApplication application(argc, argv);
    const auto catalog = std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()));
    Theme theme;
    MainWindow window(catalog, theme);
    window.documentFiles().openTemplate(defaultSceneFile());
    window.show();
    FrameLoop& frames = window.views().first().viewport().frames();
    if (!waitFor([&] { return frames.frameCount() > 0 && frames.isUpToDate(); })) {
        std::fprintf(stderr, "no first frame seen (is there a display?)\n");
        return 1;
    }
    if (!measure(window, *catalog)) {
        std::fprintf(stderr, "a plot did not come\n");
        return 1;
    }
    return 0;
}
