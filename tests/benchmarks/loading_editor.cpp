// SPDX-License-Identifier: GPL-3.0-or-later
// The editor's window at work on large meshes, with a heartbeat on its event loop.
// patina-loading-editor MESH...: prints a line per step.
#include <algorithm>
#include <array>

#include <QApplication>
#include <QMouseEvent>
#include <QTemporaryDir>

#include <fmt/format.h>

#include "catalog/catalog.h"
#include "document/scene_edits.h"
#include "editor_course.h"
#include "window/main_window.h"

namespace {

using namespace patina;
using benchmarks::EditorCourse;

constexpr int settleMs = 4000;
constexpr int orbitMoves = 20;
constexpr int orbitIntervalMs = 50;

void doubleClickMiddle(Viewport& view) {
    const QPointF middle = view.rect().center();
    QMouseEvent click(QEvent::MouseButtonDblClick, middle, view.mapToGlobal(middle), Qt::LeftButton,
                      Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&view, &click);
}

/// Turns the camera as a drag does, at the pace of a slow mouse.
bool orbit(EditorCourse& course) {
    int moves = 0;
    QTimer mouse;
    QObject::connect(&mouse, &QTimer::timeout, &mouse, [&] {
        ++moves;
        Q_EMIT course.view().navigation().orbitWished(3.0, 0.0);
    });
    return course.step(
        "orbiting", [&] { mouse.start(orbitIntervalMs); },
        [&] {
            if (moves >= orbitMoves) {
                mouse.stop();
            }
            return moves >= orbitMoves;
        });
}

/// A new document's own object gives way to the first mesh that is dropped.
bool isLarge(const Object& object) {
    return object.mesh.ends_with(".obj");
}

int indexOfLarge(Document& document) {
    const std::vector<Object>& objects = document.scene().objects;
    return int(std::ranges::find_if(objects, isLarge) - objects.begin());
}

/// Marks and strands grow on the large mesh, and go again.
bool growStyles(EditorCourse& course, Document& document) {
    const auto drawn = [&] { return course.view().frames().isUpToDate(); };
    const auto styled = [&](std::string_view kind, const std::string& id) {
        return course.step(
            id.empty() ? fmt::format("taking the {} away", kind) : fmt::format("{} on it", id),
            [&document, kind, id] { document.setBlock(pathOf(kind), id); }, drawn);
    };
    return std::ranges::all_of(
        std::array{kinds::strokes, kinds::shells}, [&](std::string_view kind) {
            const std::vector<const Block*> blocks = document.catalog().ofKind(kind);
            return std::ranges::all_of(
                       blocks, [&](const Block* block) { return styled(kind, block->id); }) &&
                   styled(kind, "");
        });
}

bool runAll(MainWindow& window, const QStringList& meshes) {
    const auto always = [] { return true; };
    EditorCourse course(window);
    Document& document = window.document();
    QTemporaryDir folder;
    const std::string scene = folder.filePath("large.patina-scene.json").toStdString();
    const auto large = [&] { return std::ranges::count_if(document.scene().objects, isLarge); };
    const auto undo = [&] { document.undoStack().undo(); };
    course.rest(settleMs);
    return course.step(
               "one more frame of the default scene", [] {}, always) &&
           course.step(
               "reading the mesh", [&] { window.files().drop(meshes.first(1), Side::A); },
               [&] { return large() == 1; }) &&
           course.step(
               "one more frame", [] {}, always) &&
           orbit(course) && growStyles(course, document) &&
           course.step(
               "picking a pivot", [&] { doubleClickMiddle(course.view()); }, always) &&
           course.step(
               "saving", [&] { window.documentFiles().saveScene(scene); }, always) &&
           course.step("undoing the import", undo, always) &&
           course.step(
               "redoing it", [&] { document.undoStack().redo(); }, always) &&
           course.step(
               "removing it", [&] { removeObjects(document, {indexOfLarge(document)}); }, always) &&
           course.step("undoing the removal", undo, always) &&
           course.step(
               "a new document", [&] { window.documentFiles().openTemplate(defaultSceneFile()); },
               always) &&
           course.step(
               "opening the saved scene", [&] { window.documentFiles().openScene(scene); },
               always) &&
           course.step(
               "dropping the other meshes", [&] { window.files().drop(meshes.mid(1), Side::A); },
               [&] { return large() == meshes.size(); });
}

} // namespace

int main(int argc, char** argv) {
    QCoreApplication::setApplicationName("patina-loading-editor");
    QApplication application(argc, argv);
    Theme theme;
    MainWindow window(std::make_shared<const Catalog>(loadCatalog(standardBlockRoots())), theme);
    window.documentFiles().openTemplate(defaultSceneFile());
    window.show();
    window.startRest();
    return runAll(window, QApplication::arguments().mid(1)) ? 0 : 1;
}
