// SPDX-License-Identifier: GPL-3.0-or-later
// How a mesh file becomes an object, as it is asked and remembered.
#include <QDoubleSpinBox>
#include <QLocale>
#include <QTest>

#include "exchange/material_export.h"
#include "files/embedded_images.h"
#include "files/import_dialog.h"
#include "material/preset_file.h"
#include "scene/scene_file.h"
#include "ui/window_fixture.h"

namespace patina::tests::import_test {
namespace {

constexpr int readingMs = 20000;

TEST(ImportDialog, Accepted_GivesWhatItBeganWith) {
    const MeshImport import{false, 0.001, true, true, true};
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
    const MeshImport import{false, 0.01, true, true, true};
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

TEST(EmbeddedImages, OfAMaterial_AreFilesOfTheirContent) {
    const TemporaryFolder folder;
    MeshMaterial material;
    material.images = {{"diffuse", "data:image/png;base64,iVBORw0KGgo="},
                       {"emissive", "data:image/png;base64,iVBORw0KGgo="},
                       {"normal", "data:image/jpeg;base64,no base64 at all"},
                       {"height", "/elsewhere/bumps.png"}};
    const Errors errors = keepEmbeddedImages(material, folder / "images");
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(errors.front().problem, "an image inside the file is damaged");
    ASSERT_EQ(material.images.size(), 3u);
    EXPECT_EQ(readFile(material.images.at("diffuse")), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(material.images.at("emissive"), material.images.at("diffuse"));
    EXPECT_EQ(material.images.at("height"), "/elsewhere/bumps.png");
}

class ExportedGlb : public WindowFixture {};

/// The images are inside of the file, where a preset names them by their numbers.
TEST_F(ExportedGlb, PresetWithImages_ComesBackAsItWas) {
    const Catalog& catalog = document().catalog();
    const auto reading =
        readPreset(dataFolder() / "presets/oren-nayar/brick.patina.json", catalog, {});
    ASSERT_TRUE(reading);
    const Material& brick = reading->material;
    const Progress progress;
    ASSERT_TRUE(exportMaterials(home("brick.glb"), {brick}, catalog, progress));
    window().files().open({QString::fromStdString(home("brick.glb").string())}, Side::A);
    const auto material = [this]() -> const Material& {
        return document().scene().objects.front().material;
    };
    ASSERT_TRUE(QTest::qWaitFor([&] { return material().model.id == brick.model.id; }, readingMs));
    EXPECT_EQ(material().model, brick.model);
    ASSERT_EQ(material().textures.size(), brick.textures.size());
    for (const auto& [key, use] : brick.textures) {
        EXPECT_EQ(readFile(material().textures.at(key).file), readFile(use.file)) << key;
        EXPECT_EQ(material().textures.at(key).scale, use.scale) << key;
    }
}

/// Is a mesh of two materials, of which the file says how they look.
class MeshOfTwoMaterials : public WindowFixture {
  protected:
    void open(const MeshImport& import) {
        writeFile(home("two.mtl"), "newmtl paint\nKd 0.5 0.25 0\nKs 0.5 0.5 0.5\nNs 40\n"
                                   "newmtl cloth\nKd 1 0 0\n");
        writeFile(home("two.obj"), "mtllib two.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n"
                                   "usemtl paint\nf 1 2 3\nusemtl cloth\nf 2 4 3\n");
        Session().setMeshImport(import);
        before_ = document().scene().objects.front().material;
        window().files().open({QString::fromStdString(home("two.obj").string())}, Side::A);
        const auto isThere = [this] {
            return document().scene().objects.front().mesh.ends_with("two.obj");
        };
        ASSERT_TRUE(QTest::qWaitFor(isThere, readingMs));
    }

    const std::vector<Object>& objects() { return document().scene().objects; }

    Material before_;
};

TEST_F(MeshOfTwoMaterials, Opened_IsAnObjectForEachWithItsPreset) {
    open({});
    ASSERT_EQ(objects().size(), 2u);
    EXPECT_EQ(objects()[0].part, "paint");
    EXPECT_EQ(objects()[0].material.name, "paint");
    EXPECT_EQ(objects()[0].material.model.id, "blinn-phong");
    EXPECT_EQ(objects()[0].material.model.parameters.at("shininess"), Value(40.0));
    EXPECT_EQ(objects()[1].material.model.id, "lambert");
    EXPECT_EQ(objects()[0].group, objects()[1].group);
    EXPECT_FALSE(objects()[0].group.empty());
    EXPECT_EQ(window().meshes().view(objects()[1]).indices.size(), 3u);
    document().undoStack().undo();
    EXPECT_EQ(objects().size(), 1u);
    EXPECT_EQ(objects()[0].mesh.substr(0, 8), "builtin:");
}

TEST_F(MeshOfTwoMaterials, Joined_IsOneObjectWithTheCurrentMaterial) {
    MeshImport import;
    import.joins = true;
    open(import);
    ASSERT_EQ(objects().size(), 1u);
    EXPECT_EQ(objects()[0].material, before_);
    EXPECT_EQ(window().meshes().view(objects()[0]).indices.size(), 6u);
}

TEST_F(MeshOfTwoMaterials, SavedAndOpenedAgain_HasItsParts) {
    open({});
    ASSERT_TRUE(window().documentFiles().saveScene(home("two.patina-scene.json")));
    const auto scene = readScene(home("two.patina-scene.json"), document().catalog());
    ASSERT_TRUE(scene);
    ASSERT_EQ(scene->scene.objects.size(), 2u);
    EXPECT_EQ(scene->scene.objects[1].part, "cloth");
    EXPECT_EQ(scene->scene.objects[1].material, objects()[1].material);
}

TEST_F(MeshOfTwoMaterials, PartThatTheFileLacks_IsToldOnce) {
    open({});
    int told = 0;
    QObject::connect(&window().meshes(), &MeshLibrary::failed, &window(),
                     [&](const QString&, const Error& why) {
                         told += why.problem.ends_with("of a material \"gold\"") ? 1 : 0;
                     });
    Object other = objects()[0];
    other.part = "gold";
    EXPECT_TRUE(window().meshes().view(other).indices.empty());
    EXPECT_TRUE(window().meshes().view(other).indices.empty());
    QTest::qWait(1);
    EXPECT_EQ(told, 1);
}

} // namespace
} // namespace patina::tests::import_test
