// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of materials: made once, and anew when anything they depend on is another.
#include <algorithm>

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "library/thumbnail_maker.h"
#include "support/program.h"

namespace patina::tests::thumbnail_test {
namespace {

namespace fs = std::filesystem;

/// Shipped blocks as a copy, a scene and a material.
class Thumbnails : public testing::Test {
  protected:
    Thumbnails() {
        fs::copy(fs::path(PATINA_SOURCE_DIR) / "shaders", folder_ / "shaders",
                 fs::copy_options::recursive);
        fs::copy(fs::path(PATINA_SOURCE_DIR) / "presets/three-lights.patina-scene.json", scene());
        catalog_ = std::make_shared<const Catalog>(
            loadCatalog(std::vector<BlockRoot>{{folder_ / "shaders"}}));
        material_ = defaultMaterial(*catalog_->ofKind(kinds::models).front());
        material_.textures["normal"].file = image().string();
        writeFile(image(), "an image");
    }

    fs::path scene() const { return folder_ / "scene.patina-scene.json"; }
    fs::path image() const { return folder_ / "bark.png"; }
    QByteArray key() { return keys_.of(material_, *catalog_); }

    /// Writes another text of the same length: its time alone tells.
    static void change(const fs::path& file) {
        std::string text = readFile(file);
        text.back() = text.back() == ' ' ? '\n' : ' ';
        QTest::qWait(10);
        writeFile(file, text);
    }

    TemporaryFolder folder_;
    std::shared_ptr<const Catalog> catalog_;
    Material material_;
    ThumbnailKeys keys_{scene()};
};

TEST_F(Thumbnails, TextsOfTheMaterial_KeepTheKey) {
    const QByteArray before = key();
    material_.name = "Another name";
    material_.tags = {"tag"};
    EXPECT_EQ(key(), before);
}

TEST_F(Thumbnails, Cancelled_ComeAgainWhenTheyAreAskedToGoOn) {
    constexpr int drawingMs = 20000;
    material_.textures.clear();
    ThumbnailMaker maker(catalog_, {folder_ / "cache", folder_ / "programs", scene()});
    QSignalSpy ready(&maker, &ThumbnailMaker::ready);
    const auto isEmpty = [&](int count) {
        return QTest::qWaitFor([&] { return ready.count() == count; }, drawingMs) &&
               ready.last().at(1).value<QImage>().isNull();
    };
    maker.ask("first", material_);
    const auto rows = LongTasks::all().running();
    const auto row = std::ranges::find(rows, "Drawing small pictures", &LongTasks::Row::name);
    ASSERT_NE(row, rows.end());
    ASSERT_TRUE(row->canCancel);
    LongTasks::all().cancel(row->number);
    maker.start();
    EXPECT_TRUE(isEmpty(1));
    EXPECT_TRUE(maker.isStopped());
    maker.ask("second", material_);
    EXPECT_TRUE(isEmpty(2));
    maker.goOn();
    maker.ask("third", material_);
    EXPECT_FALSE(isEmpty(3));
    EXPECT_EQ(ready.count(), 3);
}

TEST_F(Thumbnails, WhateverIsSeen_IsInTheKey) {
    std::vector<QByteArray> keys{key()};
    const auto expectAnother = [&](const fs::path& what) {
        const QByteArray now = key();
        EXPECT_EQ(std::ranges::count(keys, now), 0) << what;
        keys.push_back(now);
    };
    material_.opacity = 0.5;
    expectAnother("a value");
    const Block& model = *catalog_->ofKind(kinds::models).front();
    for (const fs::path& file :
         {image(), scene(), model.shaderFile, model.descriptorFile,
          folder_ / "shaders/lib/directions.glsl", folder_ / "shaders/passes/surface.glsl",
          catalog_->ofKind(kinds::lights).front()->shaderFile}) {
        change(file);
        expectAnother(file);
    }
}

TEST_F(Thumbnails, SecondStart_MakesNone) {
    material_.textures.clear();
    const ThumbnailMaker::Folders folders{folder_ / "pictures", folder_ / "programs", scene()};
    const auto make = [&] {
        ThumbnailMaker maker(catalog_, folders);
        QImage made;
        QObject::connect(&maker, &ThumbnailMaker::ready, &maker,
                         [&made](const QString&, const QImage& picture) {
                             made = picture.convertToFormat(QImage::Format_RGB32);
                         });
        maker.start();
        maker.ask("one", material_);
        EXPECT_TRUE(QTest::qWaitFor([&made] { return !made.isNull(); }, 60000));
        return made;
    };
    const QImage first = make();
    const auto kept = fs::directory_iterator(folders.cache)->path();
    const auto written = fs::last_write_time(kept);
    EXPECT_EQ(make(), first);
    EXPECT_EQ(fs::last_write_time(kept), written);
    EXPECT_EQ(std::distance(fs::directory_iterator(folders.cache), {}), 1);
}

} // namespace
} // namespace patina::tests::thumbnail_test
