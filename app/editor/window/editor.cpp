// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/editor.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <optional>
#include <system_error>
#include <vector>

#include <QApplication>
#include <QFileInfo>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QTimer>

#include "background/free_memory.h"
#include "gl/driver.h"
#include "gl/driver_cache.h"
#include "shading/program/block_gate.h"
#include "window/main_window.h"
#include "window/safe_start.h"

namespace patina {
namespace {

/// Is how long the library and the rest wait for the first frame, which they would slow down.
constexpr std::chrono::milliseconds restPatience{700};

void say(const QString& text) {
    std::fprintf(stderr, "patina: %s\n", qUtf8Printable(text));
}

/// Exits with messages of its own when no display can be opened, as Qt would end the program
/// itself.
void explainNoDisplay(QtMsgType type, const QMessageLogContext&, const QString&) {
    if (type == QtFatalMsg) {
        const QString display = qEnvironmentVariable("DISPLAY");
        say(display.isEmpty() ? QStringLiteral("there is no display to open a window on")
                              : QStringLiteral("the display %1 cannot be opened").arg(display));
        say(QStringLiteral("`patina render` draws without one"));
        std::_Exit(1);
    }
}

/// Returns the first word that looks like an option and is not a file, among those that Qt left of
/// the command line.
std::optional<QString> unknownOption(const QStringList& arguments) {
    for (const QString& argument : arguments) {
        if (argument.startsWith('-') && !QFileInfo::exists(argument)) {
            return argument;
        }
    }
    return std::nullopt;
}

void tellTime(const char* what) {
    if (qEnvironmentVariableIsSet("PATINA_TIME_STARTUP")) {
        const std::chrono::duration<double> now =
            std::chrono::steady_clock::now().time_since_epoch();
        say(QStringLiteral("%1 at %2 s").arg(QLatin1String(what)).arg(now.count(), 0, 'f', 6));
    }
}

/// Calls `then` once, when the next picture that `drawn` reports is on the screen.
void whenShown(Viewport& viewport, void (FrameLoop::*drawn)(), const std::function<void()>& then) {
    QObject::connect(
        &viewport.frames(), drawn, &viewport,
        [&viewport, then] {
            QObject::connect(&viewport, &Viewport::shown, &viewport, then,
                             Qt::SingleShotConnection);
        },
        Qt::SingleShotConnection);
}

/// Starts the rest of the program in the turn after the first frame is on the screen, or while a
/// slow one is drawn.
void afterFirstFrame(MainWindow& window, Viewport& viewport) {
    auto* rest = new QTimer(&window);
    rest->setSingleShot(true);
    QObject::connect(rest, &QTimer::timeout, &window, &MainWindow::startRest);
    rest->start(restPatience);
    QObject::connect(
        &window.dockContext().presets, &PresetLibrary::checked, &window,
        [] { tellTime("presets"); }, Qt::SingleShotConnection);
    whenShown(viewport, &FrameLoop::sketchDrawn, [] { tellTime("sketch"); });
    whenShown(viewport, &FrameLoop::frameDrawn, [rest] {
        tellTime("first frame");
        if (rest->isActive()) {
            rest->start(0);
        }
    });
}

/// Returns why to offer a safe start; a crash counts only where something that may be at fault
/// could be left out.
SafeStartReason safeStartReason(const StartMark& mark, const std::vector<BlockRoot>& roots,
                                const QStringList& files) {
    if (QGuiApplication::queryKeyboardModifiers().testFlag(Qt::ShiftModifier)) {
        return SafeStartReason::ShiftHeld;
    }
    const bool hasOwnBlocks = std::ranges::any_of(roots, [](const BlockRoot& root) {
        std::error_code ignored;
        return !root.shipped && std::filesystem::exists(root.folder, ignored) &&
               !std::filesystem::is_empty(root.folder, ignored);
    });
    return mark.foundCrash() && (hasOwnBlocks || !files.isEmpty()) ? SafeStartReason::Crash
                                                                   : SafeStartReason::None;
}

} // namespace

int runEditor(int argc, char** argv) {
    gl::prepareDriverCache();
    keepBuffersApart();
    neverWaitForTrialsHere();
    QCoreApplication::setApplicationName("patina");
    QCoreApplication::setOrganizationName("patina");
    QCoreApplication::setApplicationVersion(PATINA_VERSION);
    const QtMessageHandler ordinary = qInstallMessageHandler(explainNoDisplay);
    QApplication application(argc, argv);
    qInstallMessageHandler(ordinary);
    QGuiApplication::setDesktopFileName("patina");
    const QStringList files = QApplication::arguments().mid(1);
    if (const auto option = unknownOption(files)) {
        say(QStringLiteral("there is no option %1; `patina --help` names those there are")
                .arg(*option));
        return 1;
    }

    Theme theme;
    const StartMark mark(stateFolder());
    std::vector<BlockRoot> roots = standardBlockRoots();
    const bool isSafe = offerSafeStart(safeStartReason(mark, roots, files));
    if (isSafe) {
        std::erase_if(roots, [](const BlockRoot& root) { return !root.shipped; });
    }
    MainWindow window(std::make_shared<const Catalog>(loadCatalog(roots)), theme);
    window.documentFiles().openTemplate(defaultSceneFile());
    if (!isSafe) {
        window.files().open(files, Side::A);
    }
    Viewport& viewport = window.views().first().viewport();
    afterFirstFrame(window, viewport);
    window.show();
    if (isSafe) {
        window.tellSafeStart();
    } else {
        window.offerRecovery(); // comes before the first frame, for which a slow model may take
                                // seconds
    }
    viewport.frames().paint(); // opens the view, so that a failure is known before the window waits
    if (const QString why = viewport.frames().failure(); !why.isEmpty()) {
        say(why);
        return 1;
    }
    return QApplication::exec();
}

} // namespace patina
