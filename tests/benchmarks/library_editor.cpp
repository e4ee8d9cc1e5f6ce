// SPDX-License-Identifier: GPL-3.0-or-later
// The editor's preset library with thousands of presets.
// patina-library-editor COUNT: prints a line "milliseconds limit what" per figure.
#include <cstdio>
#include <filesystem>
#include <thread>

#include <QApplication>
#include <QDockWidget>
#include <QLineEdit>
#include <QScrollBar>

#include "catalog/catalog.h"
#include "docks/preset_view.h"
#include "heartbeat.h"
#include "material/preset_file.h"
#include "window/main_window.h"

namespace {

using namespace patina;
namespace fs = std::filesystem;

constexpr int limitMs = 60000;
constexpr int restMs = 3000;
constexpr double maxOpening = 1000.0;
constexpr double maxSearch = 50.0;
constexpr double maxStall = 100.0;
constexpr int scrolls = 120;
constexpr int perFolder = 250;

void print(double milliseconds, double limit, const char* what) {
    std::printf("%.1f %.0f %s\n", milliseconds, limit, what);
}

bool waitFor(const std::function<bool()>& done, int limit = limitMs) {
    QElapsedTimer time;
    time.start();
    while (!done() && time.elapsed() < limit) {
        QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
    }
    return done();
}

/// Presets like those that ship, each with a name and a look of its own.
void makePresets(int count, const Catalog& catalog) {
    std::vector<Material> shipped;
    for (const auto& file : fs::recursive_directory_iterator(PresetLibrary::shippedFolder())) {
        if (file.path().string().ends_with(".patina.json")) {
            if (auto preset = readPreset(file.path(), catalog)) {
                shipped.push_back(std::move(preset->material));
            }
        }
    }
    for (int i = 0; i < count; ++i) {
        Material material = shipped[std::size_t(i) % shipped.size()];
        material.name += " " + std::to_string(i);
        material.tags.push_back("set" + std::to_string(i % 40));
        const fs::path folder =
            PresetLibrary::userFolder() / ("set" + std::to_string(i / perFolder));
        fs::create_directories(folder);
        (void)writePreset(folder / ("p" + std::to_string(i) + ".patina.json"), material, catalog);
    }
}

bool measure(MainWindow& window, int count) {
    auto& dock = *window.dock("presets");
    auto& view = *dock.findChild<PresetView*>();
    auto& search = *dock.findChild<QLineEdit*>();
    const auto shown = [&view] { return view.model()->rowCount(); };
    benchmarks::Heartbeat heart;
    heart.start();
    QElapsedTimer time;
    time.start();
    window.startRest();
    if (!waitFor([&] { return shown() > 0; })) {
        return false;
    }
    print(double(time.elapsed()), maxOpening, "until the first presets are there");
    if (!waitFor([&] { return shown() > count; })) {
        return false;
    }
    print(double(time.elapsed()), maxOpening, "until all presets are there");
    print(heart.longestGap(), maxStall, "longest stall meanwhile");
    waitFor([] { return false; }, restMs);
    double slowest = 0.0;
    for (const char* text : {"g", "go", "gold", "set7", "brushed steel", "patina", "xyz", ""}) {
        time.start();
        search.setText(text);
        view.viewport()->repaint();
        slowest = std::max(slowest, 1e-6 * double(time.nsecsElapsed()));
        waitFor([] { return false; }, 200);
    }
    print(slowest, maxSearch, "slowest search");
    heart.start();
    QScrollBar& bar = *view.verticalScrollBar();
    for (int i = 0; i <= scrolls; ++i) {
        bar.setValue(bar.maximum() * i / scrolls);
        waitFor([] { return false; }, 30);
    }
    print(heart.longestGap(), maxStall, "longest stall while scrolling");
    return true;
}

} // namespace

int main(int argc, char** argv) {
    QCoreApplication::setApplicationName("patina-library-editor");
    QApplication application(argc, argv);
    const int count = QApplication::arguments().value(1, "5000").toInt();
    const auto catalog = std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()));
    makePresets(count, *catalog);
    std::this_thread::sleep_for(std::chrono::seconds(3)); // files that are new are read twice
    Theme theme;
    MainWindow window(catalog, theme);
    window.documentFiles().openTemplate(defaultSceneFile());
    window.show();
    auto& frames = window.views().first().viewport().frames();
    waitFor([&] { return frames.frameCount() > 0 && frames.isUpToDate(); });
    return measure(window, count) ? 0 : 1;
}
