// SPDX-License-Identifier: GPL-3.0-or-later
// What comes with Patina stays as it is.
#include <QApplication>
#include <QFileDialog>
#include <QTimer>

#include "ui/window_fixture.h"

namespace patina::tests::shipped_files_test {
namespace {

namespace fs = std::filesystem;

/// A copy of the folder that comes with Patina, with one of its presets open and changed.
class ShippedFiles : public WindowFixture {
  protected:
    void SetUp() override {
        fs::create_directories(home("data"));
        for (const char* part : {"shaders", "schemas", "presets"}) {
            fs::copy(fs::path(PATINA_SOURCE_DIR) / part, home("data") / part,
                     fs::copy_options::recursive);
        }
        qputenv("PATINA_DATA_DIR", QByteArray::fromStdString(home("data").string()));
        preset_ = otherPreset(document());
        before_ = readFile(preset_);
        window().files().open({QString::fromStdString(preset_.string())}, Side::A);
        Material changed = *document().material(Side::A);
        changed.description = "Mine.";
        document().replaceMaterial(Side::A, changed, "Change");
    }
    void TearDown() override { qunsetenv("PATINA_DATA_DIR"); }

    /// What the next file dialog offers, which is then accepted or rejected.
    QString offeredBySave(bool accept) {
        QString offered;
        QTimer timer;
        QObject::connect(&timer, &QTimer::timeout, [&] {
            if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
                offered = dialog->selectedFiles().value(0);
                accept ? QMetaObject::invokeMethod(dialog, "accept") : dialog->close();
            }
        });
        timer.start(20);
        window().files().saving().save();
        return offered;
    }

    fs::path preset_;
    std::string before_;
};

TEST_F(ShippedFiles, Save_OffersACopyAmongTheUsersPresets) {
    const QString name = QString::fromStdString(document().material(Side::A)->name);
    const QString offered = offeredBySave(false);
    EXPECT_TRUE(offered.startsWith(QString::fromStdString(PresetLibrary::userFolder().string())))
        << offered.toStdString();
    EXPECT_TRUE(offered.endsWith("/Copy of " + name + ".patina.json")) << offered.toStdString();
    EXPECT_EQ(readFile(preset_), before_);
    EXPECT_TRUE(document().isModified());
}

TEST_F(ShippedFiles, SavedCopy_IsTheDocumentsFileAndCalledACopy) {
    const fs::path copy = offeredBySave(true).toStdString();
    EXPECT_EQ(window().documentFiles().file().path, copy);
    EXPECT_EQ(document().material(Side::A)->name.rfind("Copy of ", 0), 0u);
    EXPECT_FALSE(document().isModified());
    EXPECT_EQ(readFile(preset_), before_);
}

TEST_F(ShippedFiles, NamedByTheUser_AreNotWrittenEither) {
    EXPECT_FALSE(window().documentFiles().savePreset(preset_, Side::A));
    EXPECT_EQ(readFile(preset_), before_);
    EXPECT_NE(text(window().messages().messages()).find("comes with Patina"), std::string::npos);
}

TEST_F(ShippedFiles, Title_SaysThatTheyAreReadOnly) {
    EXPECT_TRUE(window().windowTitle().contains("read-only"));
}

} // namespace
} // namespace patina::tests::shipped_files_test
