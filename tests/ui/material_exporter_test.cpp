// SPDX-License-Identifier: GPL-3.0-or-later
// A material leaves for other programs, and the messages say what is not the same there.
#include <algorithm>

#include <QFile>
#include <QSignalSpy>
#include <QTest>

#include "ui/window_fixture.h"

namespace patina::tests::material_exporter_test {
namespace {

using MaterialForOthers = WindowFixture;

TEST_F(MaterialForOthers, Written_SaysWhatIsNotExactInTheMessages) {
    Material material = *document().material(Side::A);
    material.textures["height"] = textureUse("height", home("no-such.png"));
    QSignalSpy written(&window().exporter(), &MaterialExporter::written);
    const QString file = QString::fromStdString(home("paint.gltf").string());
    window().exporter().write(file, material, document().sharedCatalog());
    ASSERT_TRUE(written.wait(60000));
    EXPECT_TRUE(QFile::exists(file));
    const Errors messages = window().messages().messages();
    EXPECT_TRUE(std::ranges::any_of(messages, [](const Error& message) {
        return message.problem.starts_with("dropped: Image no-such.png");
    }));
}

TEST_F(MaterialForOthers, FileThatCannotBeWritten_IsAMessage) {
    QSignalSpy failed(&window().exporter(), &MaterialExporter::failed);
    const Block* model = document().catalog().find("models", "lambert");
    window().exporter().write("/proc/no/such/paint.mtl", defaultMaterial(*model),
                              document().sharedCatalog());
    ASSERT_TRUE(failed.wait(20000));
    EXPECT_GT(window().messages().count(), 0);
}

} // namespace
} // namespace patina::tests::material_exporter_test
