// SPDX-License-Identifier: GPL-3.0-or-later
// How a mesh file becomes an object, as it is asked and remembered.
#include <QDoubleSpinBox>
#include <QLocale>
#include <QTest>

#include "files/import_dialog.h"
#include "ui/window_fixture.h"

namespace patina::tests::import_test {
namespace {

constexpr int readingMs = 20000;

TEST(ImportDialog, Accepted_GivesWhatItBeganWith) {
    const MeshImport import{false, 0.001, true, true};
    EXPECT_EQ(ImportDialog("/somewhere/bust.obj", import).chosen(), import);
}

TEST(ImportDialog, ScaleInAGermanLocale_IsReadAsItIsWritten) {
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German));
    ImportDialog dialog("/somewhere/bust.obj", {});
    auto* scale = dialog.findChild<QDoubleSpinBox*>();
    scale->selectAll();
    QTest::keyClicks(scale, "0.01");
    EXPECT_EQ(dialog.chosen().scale, 0.01);
    QLocale::setDefault(before);
}

TEST(MeshImport, Remembered_IsThereAtTheNextStart) {
    const TemporaryFolder folder;
    const QByteArray before = qgetenv("XDG_CONFIG_HOME");
    qputenv("XDG_CONFIG_HOME", QByteArray::fromStdString(folder.path().string()));
    const MeshImport import{false, 0.01, true, true};
    {
        Session session;
        EXPECT_EQ(session.meshImport(), MeshImport());
        session.setMeshImport(import);
        session.sync();
    }
    EXPECT_EQ(Session().meshImport(), import);
    qputenv("XDG_CONFIG_HOME", before);
}

using ImportedMesh = WindowFixture;

TEST_F(ImportedMesh, Opened_BecomesAnObjectAsTheLastOneDid) {
    writeFile(home("flat.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    Session().setMeshImport({false, 0.5, true, true});
    window().files().open({QString::fromStdString(home("flat.obj").string())}, Side::A);
    const auto isThere = [this] {
        return document().scene().objects.front().mesh.ends_with("flat.obj");
    };
    ASSERT_TRUE(QTest::qWaitFor(isThere, readingMs));
    const Object& object = document().scene().objects.front();
    EXPECT_FALSE(object.fitUnitBox);
    EXPECT_TRUE(object.flipNormals);
    EXPECT_EQ(object.scale, glm::dvec3(0.5));
    EXPECT_EQ(object.rotation, glm::dvec3(-90.0, 0.0, 0.0));
}

} // namespace
} // namespace patina::tests::import_test
