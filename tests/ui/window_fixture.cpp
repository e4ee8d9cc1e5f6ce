// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window_fixture.h"
#include "catalog/catalog.h"

#include <algorithm>
#include <utility>

#include <QApplication>
#include <QCursor>
#include <QEventLoop>
#include <QScreen>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>

#include "material/preset_file.h"
#include "session/session.h"

namespace patina::tests {
namespace {

constexpr QSize smallWindow{1000, 490};
constexpr int settleMs = 60;
constexpr int panelsMs = 200;
constexpr int frameLimitMs = 20000;

/// Reads the blocks; those of the sources only once, where the user has none of his own.
std::shared_ptr<const Catalog> readBlocks() {
    const std::vector<BlockRoot> roots = standardBlockRoots();
    const bool isOfSources = roots.front().folder == PATINA_SOURCE_DIR "/shaders";
    const auto isThere = [](const BlockRoot& root) { return std::filesystem::exists(root.folder); };
    if (!isOfSources || std::ranges::count_if(roots, isThere) != 1) {
        return std::make_shared<const Catalog>(loadCatalog(roots));
    }
    static const Catalog shipped = loadCatalog(roots);
    Catalog read = shipped;
    read.roots = roots;
    return std::make_shared<const Catalog>(std::move(read));
}

} // namespace

WindowFixture::WindowFixture(Size size) : size_(size) {
    for (const char* variable :
         {"XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_STATE_HOME", "XDG_DATA_HOME"}) {
        qputenv(variable, QByteArray::fromStdString((home_ / variable).string()));
    }
    makeCacheFolder(home_ / "XDG_CACHE_HOME");
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                       QString::fromStdString((home_ / "XDG_CONFIG_HOME").string()));
    open();
}

WindowFixture::~WindowFixture() {
    close();
}

void WindowFixture::open() {
    theme_ = std::make_unique<Theme>();
    window_ = std::make_unique<MainWindow>(readBlocks(), *theme_);
    ASSERT_TRUE(window().documentFiles().openTemplate(threeLightsFile()));
    if (size_ == Size::Small && Session().windowGeometry().isEmpty()) {
        window_->resize(smallWindow);
    }
    QSignalSpy frames(&view().frames(), &FrameLoop::frameDrawn);
    QCursor::setPos(window_->screen()->geometry().bottomRight()); // where it rests on nothing
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get(), frameLimitMs));
    ASSERT_TRUE(!frames.isEmpty() || frames.wait(frameLimitMs));
    ASSERT_TRUE(QTest::qWaitFor([this] { return !window().meshes().isLoading(); }, frameLimitMs));
    newFrames();
}

void WindowFixture::close() {
    window_.reset();
    theme_.reset();
}

int WindowFixture::newFrames() {
    QTest::qWait(settleMs);
    EXPECT_TRUE(QTest::qWaitFor(
        [this] { return view().frames().isUpToDate() && !view().prewarmer().isBusy(); },
        frameLimitMs));
    const int before = framesBefore_;
    framesBefore_ = view().frames().frameCount();
    return framesBefore_ - before;
}

void WindowFixture::settle() {
    QEventLoop panels;
    QTimer::singleShot(panelsMs, &panels, &QEventLoop::quit);
    panels.exec();
}

void WindowFixture::focusView() {
    QApplication::setActiveWindow(window_.get());
    view().setFocus();
    ASSERT_TRUE(view().hasFocus());
}

void WindowFixture::drag(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, QPoint by) {
    const QPoint middle = view().rect().center();
    QTest::mousePress(&view(), button, modifiers, middle);
    QMouseEvent move(QEvent::MouseMove, middle + by, view().mapToGlobal(middle + by), Qt::NoButton,
                     button, modifiers);
    QApplication::sendEvent(&view(), &move);
    QTest::mouseRelease(&view(), button, modifiers, middle + by);
}

PictureExport::Source pictureOf(Viewport& view) {
    return {[&view](bool display, PictureCapture::Taken taken) {
                view.capture().start(display, std::move(taken));
            },
            [&view] { view.capture().cancel(); }};
}

std::filesystem::path otherPreset(const Document& document) {
    const std::string model = document.material(Side::A)->model.id;
    for (const auto& file :
         std::filesystem::recursive_directory_iterator(PresetLibrary::shippedFolder())) {
        const auto reading = file.path().filename().string().ends_with(".patina.json")
                                 ? readPreset(file.path(), document.catalog())
                                 : tl::unexpected(Errors());
        if (reading && reading->material.model.id != model) {
            return file.path();
        }
    }
    return {};
}

} // namespace patina::tests
