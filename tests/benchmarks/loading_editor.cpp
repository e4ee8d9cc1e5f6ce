// SPDX-License-Identifier: GPL-3.0-or-later
// The editor's window at work on large meshes, with a heartbeat on its event loop.
// patina-loading-editor MESH...: prints a line per step: the longest gap between two beats and how
// long the step took, in milliseconds, and the step's name.
#include <algorithm>
#include <cstdio>
#include <functional>

#include <QApplication>
#include <QMouseEvent>
#include <QTemporaryDir>

#include "heartbeat.h"
#include "main_window.h"

namespace {

using namespace patina;

constexpr int limitMs = 60000;
constexpr int restMs = 600;
constexpr int settleMs = 4000;
constexpr int orbitMoves = 20;
constexpr int orbitIntervalMs = 50;

/// Does the steps one after the other and prints what each took.
class Course {
  public:
    explicit Course(MainWindow& window) : view_(window.views().first().viewport()) {
        QObject::connect(&view_, &QOpenGLWidget::frameSwapped, &window, [this] { ++swaps_; });
    }

    /// From `begin` until `done` and a picture drawn after that is on the screen.
    bool step(const char* name, const std::function<void()>& begin,
              const std::function<bool()>& done) {
        rest(restMs);
        heart_.start();
        QElapsedTimer time;
        time.start();
        begin();
        if (!waitUntil(done) || !waitForPicture()) {
            std::fprintf(stderr, "%s: not done in time\n", name);
            return false;
        }
        const double milliseconds = 1e-6 * double(time.nsecsElapsed());
        std::printf("%.1f %.1f %s\n", heart_.longestGap(), milliseconds, name);
        return true;
    }

    void rest(int milliseconds) {
        QElapsedTimer time;
        time.start();
        waitUntil([&] { return time.elapsed() >= milliseconds; });
    }

    Viewport& view() { return view_; }

  private:
    bool waitUntil(const std::function<bool()>& done) {
        QElapsedTimer time;
        time.start();
        while (!done() && time.elapsed() < limitMs) {
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        }
        return done();
    }

    /// One more frame than was asked for until now, so that it shows all of it.
    bool waitForPicture() {
        const int drawn = view_.frameCount();
        view_.refresh();
        if (!waitUntil([&] { return view_.frameCount() > drawn; })) {
            return false;
        }
        const int swapped = swaps_;
        return waitUntil([&] { return swaps_ > swapped; });
    }

    Viewport& view_;
    benchmarks::Heartbeat heart_;
    int swaps_ = 0;
};

void doubleClickMiddle(Viewport& view) {
    const QPointF middle = view.rect().center();
    QMouseEvent click(QEvent::MouseButtonDblClick, middle, view.mapToGlobal(middle), Qt::LeftButton,
                      Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&view, &click);
}

/// Turns the camera as a drag does, at the pace of a slow mouse.
bool orbit(Course& course) {
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

bool runAll(MainWindow& window, const QStringList& meshes) {
    const auto always = [] { return true; };
    Course course(window);
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
           orbit(course) &&
           course.step(
               "picking a pivot", [&] { doubleClickMiddle(course.view()); }, always) &&
           course.step(
               "saving", [&] { document.saveScene(scene); }, always) &&
           course.step("undoing the import", undo, always) &&
           course.step(
               "redoing it", [&] { document.undoStack().redo(); }, always) &&
           course.step(
               "removing it", [&] { document.removeObject(indexOfLarge(document)); }, always) &&
           course.step("undoing the removal", undo, always) &&
           course.step(
               "a new document", [&] { document.openTemplate(FileActions::defaultScene()); },
               always) &&
           course.step(
               "opening the saved scene", [&] { document.openScene(scene); }, always) &&
           course.step(
               "dropping the other meshes", [&] { window.files().drop(meshes.mid(1), Side::A); },
               [&] { return large() == meshes.size(); });
}

} // namespace

int main(int argc, char** argv) {
    QCoreApplication::setApplicationName("patina-loading-editor");
    QSurfaceFormat::setDefaultFormat(Viewport::surfaceFormat());
    QApplication application(argc, argv);
    Theme theme;
    MainWindow window(std::make_shared<const Catalog>(loadCatalog(standardBlockRoots())), theme);
    window.document().openTemplate(FileActions::defaultScene());
    window.show();
    window.startRest();
    return runAll(window, QApplication::arguments().mid(1)) ? 0 : 1;
}
