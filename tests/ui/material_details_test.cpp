// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDialog>
#include <QFileDialog>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTest>
#include <QTimer>

#include "material/preset_file.h"
#include "ui/window_fixture.h"

namespace patina::tests::material_details_test {
namespace {

using Naming = WindowFixture;

/// Answers the next file dialog with a file.
class ChosenFile {
  public:
    explicit ChosenFile(const std::filesystem::path& file) {
        QObject::connect(&timer_, &QTimer::timeout, [file] {
            if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
                dialog->findChild<QLineEdit*>()->setText(QString::fromStdString(file.string()));
                QTest::keyClick(dialog->findChild<QLineEdit*>(), Qt::Key_Return);
            }
        });
        timer_.start(20);
    }

  private:
    QTimer timer_;
};

TEST_F(Naming, PresetExportedUnderAnotherName_IsCalledAsItsFile) {
    const std::filesystem::path file = home("my blue.patina.json");
    const ChosenFile chosen(file);
    window().files().saving().exportPreset();
    EXPECT_EQ(readPreset(file, document().catalog())->material.name, "my blue");
    EXPECT_EQ(document().material(Side::A)->name, "my blue");
}

TEST_F(Naming, PresetOfAMaterialWithoutAName_IsCalledAsItsFile) {
    Material nameless = *document().material(Side::A);
    nameless.name.clear();
    document().replaceMaterial(Side::A, nameless, "Name");
    const std::filesystem::path file = home("untitled.patina.json");
    const ChosenFile chosen(file);
    window().files().saving().exportPreset();
    EXPECT_EQ(readPreset(file, document().catalog())->material.name, "untitled");
}

TEST_F(Naming, MaterialDetails_AreOneStep) {
    const int steps = document().undoStack().count();
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [] {
        if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
            dialog->findChild<QLineEdit*>("name")->setText("Night sky");
            dialog->findChild<QLineEdit*>("author")->setText(" Ada ");
            dialog->findChild<QLineEdit*>("tags")->setText("dark, , deep blue");
            dialog->findChild<QPlainTextEdit*>("description")->setPlainText("Wet slate.");
            dialog->accept();
        }
    });
    timer.start(20);
    window().files().editDetails();
    const Material& material = *document().material(Side::A);
    EXPECT_EQ(material.name, "Night sky");
    EXPECT_EQ(material.author, "Ada");
    EXPECT_EQ(material.description, "Wet slate.");
    EXPECT_EQ(material.tags, (std::vector<std::string>{"dark", "deep blue"}));
    EXPECT_EQ(document().undoStack().count(), steps + 1);
}

} // namespace
} // namespace patina::tests::material_details_test
