// SPDX-License-Identifier: GPL-3.0-or-later
// The editor's window while programs are made that are in no cache: every block of the catalogue
// comes into the scene in turn. patina-compiling-editor prints a line per kind of block: its
// longest stall, and the longest time until a block of it was on the screen.
#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include <QApplication>
#include <QTemporaryDir>

#include "catalog/catalog.h"
#include "document/scene_edits.h"
#include "editor_course.h"
#include "window/main_window.h"

namespace {

using namespace patina;
using benchmarks::EditorCourse;

constexpr int settleMs = 2000;

/// A kind of block and how one of it comes into the scene.
struct Kind {
    const char* name;
    std::function<void(Document&, const std::string& id)> use;
};

std::function<void(Document&, const std::string&)> part(std::string_view kind) {
    return
        [kind](Document& document, const std::string& id) { document.setBlock(pathOf(kind), id); };
}

std::vector<Kind> allKinds() {
    return {{"models",
             [](Document& document, const std::string& id) { document.setModel(Side::A, id); }},
            {"fresnel", part(kinds::fresnel)},
            {"lights", [](Document& document, const std::string& id) { addLight(document, id); }},
            {"shadows", part(kinds::shadows)},
            {"fog", part(kinds::fog)},
            {"environment", part(kinds::environment)},
            {"outline", part(kinds::outline)},
            {"refraction", part(kinds::refraction)},
            {"transparency", [](Document& document, const std::string& id) {
                 document.setBlock(pathOf(kinds::refraction), "");
                 document.setValue(document.selection().currentPath(settings::material), "opacity",
                                   0.5);
                 document.setBlock(pathOf(kinds::transparency), id);
             }}};
}

/// false: a block was not on the screen in time.
bool useAll(EditorCourse& course, Document& document, const Kind& kind) {
    EditorCourse::Cost worst{0.0, 0.0};
    const auto drawn = [&] { return course.view().frames().isUpToDate(); };
    const std::vector<const Block*> blocks = document.catalog().ofKind(kind.name);
    for (const Block* block : blocks) {
        const EditorCourse::Cost cost = course.take(
            block->id, [&] { kind.use(document, block->id); }, drawn);
        if (cost.gap < 0.0) {
            return false;
        }
        worst = {std::max(worst.gap, cost.gap), std::max(worst.time, cost.time)};
    }
    benchmarks::printStep(worst, std::string(kind.name) + ", the worst of " +
                                     std::to_string(blocks.size()));
    return true;
}

} // namespace

int main(int argc, char** argv) {
    const QTemporaryDir caches; // the driver's are in there too
    qputenv("XDG_CACHE_HOME", caches.path().toUtf8());
    QCoreApplication::setApplicationName("patina-compiling-editor");
    QApplication application(argc, argv);
    Theme theme;
    MainWindow window(std::make_shared<const Catalog>(loadCatalog(standardBlockRoots())), theme);
    Document& document = window.document();
    window.documentFiles().openTemplate(defaultSceneFile());
    window.show();
    EditorCourse course(window);
    course.rest(settleMs);
    const bool done = std::ranges::all_of(
        allKinds(), [&](const Kind& kind) { return useAll(course, document, kind); });
    return done ? 0 : 1;
}
