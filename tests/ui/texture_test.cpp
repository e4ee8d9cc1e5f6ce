// SPDX-License-Identifier: GPL-3.0-or-later
// Images on values: laying one on, how it lies, taking it away, and files that are not there.
#include <algorithm>

#include <QCheckBox>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QSignalSpy>
#include <QToolButton>
#include <QUrl>

#include "parameters/form_textures.h"
#include "parameters/texture_line.h"
#include "parameters/texture_popup.h"
#include "ui/form_fixture.h"

namespace patina::tests::texture_test {
namespace {

constexpr int waitMs = 20000;
const char* const color = "diffuse.color";

struct TextureForm : Form {
    TemporaryFolder folder;

    QString image(const std::string& name = "wood.png") const {
        QImage picture(4, 4, QImage::Format_RGB32);
        picture.fill(Qt::red);
        const QString file = QString::fromStdString((folder / name).string());
        picture.save(file);
        return file;
    }

    TextureLine& line() const { return *row(color).textureLine(); }
    QLabel& name() const { return *line().findChild<QLabel*>("name"); }
    QToolButton& button(const char* name) const { return *line().findChild<QToolButton*>(name); }
    QCheckBox& enabled() const { return *line().findChild<QCheckBox*>("enabled"); }
    const TextureUse* use() const { return document.texture(fixture.model(), color); }
    void lay(const QString& file) { form->textures().lay(row(color).parameter(), file); }
};

TEST_F(TextureForm, ValueThatTakesNoImage_HasNoLine) {
    EXPECT_EQ(row("roughness").textureLine(), nullptr);
    EXPECT_NE(row(color).textureLine(), nullptr);
}

TEST_F(TextureForm, OtherLook_DrawsTheIconInItsColour) {
    const auto* choose = line().findChild<QToolButton*>();
    const auto lightness = [choose] {
        return choose->icon().pixmap(choose->iconSize()).toImage().pixelColor(1, 1).lightness();
    };
    QPalette look = line().palette();
    look.setColor(QPalette::WindowText, Qt::black);
    line().setPalette(look);
    EXPECT_LT(lightness(), 20);
    look.setColor(QPalette::WindowText, Qt::white);
    line().setPalette(look);
    EXPECT_GT(lightness(), 235);
}

TEST_F(TextureForm, ChosenFile_IsOneStepAndShowsItsName) {
    lay(image());
    ASSERT_NE(use(), nullptr);
    EXPECT_EQ(fixture.steps(), 1);
    EXPECT_EQ(name().text(), "wood.png");
    EXPECT_TRUE(button("remove").isVisible());
}

TEST_F(TextureForm, Undo_TakesTheImageAway) {
    lay(image());
    document.undoStack().undo();
    EXPECT_EQ(use(), nullptr);
    EXPECT_FALSE(line().isBound());
    document.undoStack().redo();
    EXPECT_NE(use(), nullptr);
}

TEST_F(TextureForm, RemoveButton_IsOneStep) {
    lay(image());
    button("remove").click();
    EXPECT_EQ(use(), nullptr);
    EXPECT_EQ(fixture.steps(), 2);
}

TEST_F(TextureForm, Switch_TurnsTheImageOffAndOnWithoutTakingItAway) {
    lay(image());
    EXPECT_TRUE(enabled().isChecked());
    enabled().click();
    ASSERT_NE(use(), nullptr);
    EXPECT_FALSE(use()->enabled);
    EXPECT_FALSE(name().isEnabled());
    EXPECT_EQ(fixture.steps(), 2);
    document.undoStack().undo();
    EXPECT_TRUE(use()->enabled);
    EXPECT_TRUE(enabled().isChecked());
}

TEST_F(TextureForm, FileDroppedOnTheRow_LiesOnItsValue) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(image())});
    QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&row(color), &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&row(color), &drop);
    ASSERT_NE(use(), nullptr);
    EXPECT_EQ(use()->file, image().toStdString());
}

TEST_F(TextureForm, AnotherFile_KeepsHowTheImageLies) {
    lay(image());
    TextureUse turned = *use();
    turned.rotation = 45.0;
    document.setTexture(fixture.model(), color, turned);
    lay(image("other.png"));
    EXPECT_EQ(use()->rotation, 45.0);
    EXPECT_TRUE(use()->file.ends_with("other.png"));
}

TEST_F(TextureForm, SettingsButton_ShowsTheSettingsAsAForm) {
    lay(image());
    line().settingsButton()->click();
    TexturePopup* popup = form->textures().popup();
    ASSERT_NE(popup, nullptr);
    EXPECT_NE(popup->form()->row("wrap"), nullptr);
    EXPECT_EQ(popup->form()->row("cutOut"), nullptr);
    popup->close();
}

TEST_F(TextureForm, DraggedSetting_IsOneStep) {
    lay(image());
    line().settingsButton()->click();
    drag(form->textures().popup()->form()->row("rotation")->findChild<ValueSlider*>(), 0.5, 0.75);
    EXPECT_GT(use()->rotation, 45.0);
    EXPECT_EQ(fixture.steps(), 2);
    form->textures().popup()->close();
}

TEST_F(TextureForm, FileThatIsThere_ShowsItsPicture) {
    lay(image());
    images.find(*use(), TextureDecoding::Color);
    QSignalSpy arrived(&images, &TextureLibrary::arrived);
    ASSERT_TRUE(arrived.wait(waitMs));
    EXPECT_EQ(images.preview(use()->file).pixelColor(0, 0), QColor(Qt::red));
    EXPECT_EQ(name().text(), "wood.png");
}

TEST_F(TextureForm, MissingFile_IsMarkedAndKept) {
    lay("/nowhere/gone.png");
    images.find(*use(), TextureDecoding::Color);
    QSignalSpy arrived(&images, &TextureLibrary::arrived);
    ASSERT_TRUE(arrived.wait(waitMs));
    EXPECT_EQ(use()->file, "/nowhere/gone.png");
    EXPECT_EQ(name().text(), "⚠ gone.png");
    EXPECT_TRUE(name().toolTip().contains("no such file"));
}

TEST_F(TextureForm, MissingFile_IsToldOnce) {
    QSignalSpy told(&images, &TextureLibrary::failed);
    TextureUse gone = textureUse(color, "/nowhere/gone.png");
    images.find(gone, TextureDecoding::Color);
    images.find(gone, TextureDecoding::Linear);
    ASSERT_TRUE(QTest::qWaitFor([this] { return !images.isLoading(); }, waitMs));
    EXPECT_EQ(told.count(), 1);
}

/// Who hears of it may paint, which takes the context away from the view that asks.
TEST_F(TextureForm, FileThatAViewAsksForWhileItDraws_IsToldOfAfterwards) {
    QSignalSpy started(&images, &TextureLibrary::loadingStarted);
    images.find(textureUse(color, image().toStdString()), TextureDecoding::Color);
    EXPECT_EQ(started.count(), 0);
    ASSERT_TRUE(QTest::qWaitFor([this] { return !images.isLoading(); }, waitMs));
    EXPECT_EQ(started.count(), 1);
}

TEST_F(TextureForm, FileOutsideTheFolder_IsReadWhenItIsAllowed) {
    TextureUse outside = textureUse(color, image().toStdString());
    outside.outside = true;
    document.setTexture(fixture.model(), color, outside);
    EXPECT_TRUE(images.find(*use(), TextureDecoding::Color).isMissing);
    ASSERT_TRUE(button("allow").isVisible());
    button("allow").click();
    EXPECT_FALSE(use()->outside);
    EXPECT_FALSE(button("allow").isVisible());
}

TEST_F(TextureForm, CopiesOfAMaterial_ReadAFileOnce) {
    lay(image());
    QSignalSpy started(&images, &TextureLibrary::loadingStarted);
    TextureUse other = *use();
    other.rotation = 10.0;
    images.find(*use(), TextureDecoding::Color);
    images.find(other, TextureDecoding::Color);
    ASSERT_TRUE(QTest::qWaitFor([this] { return !images.isLoading(); }, waitMs));
    EXPECT_EQ(started.count(), 1);
}

/// The arrow beside the image's button has them.
TEST_F(TextureForm, VertexColours_AreChosenLikeAnImageInOneStep) {
    QMenu* choices = line().findChild<QToolButton*>()->menu();
    ASSERT_NE(choices, nullptr);
    const auto actions = choices->actions();
    const auto action = std::ranges::find(actions, QString("Vertex Colours"), &QAction::text);
    ASSERT_NE(action, actions.end());
    (*action)->trigger();
    ASSERT_NE(use(), nullptr);
    EXPECT_EQ(use()->file, vertexColorsName);
    EXPECT_EQ(fixture.steps(), 1);
    EXPECT_EQ(name().text(), "Vertex colours");
    EXPECT_FALSE(images.isLoading()) << "nothing is read";
    line().settingsButton()->click();
    ParameterForm* settings = form->textures().popup()->form();
    EXPECT_NE(settings->row("channel"), nullptr);
    EXPECT_NE(settings->row("strength"), nullptr);
    EXPECT_EQ(settings->row("wrap"), nullptr) << "nothing places them";
    form->textures().popup()->close();
    document.undoStack().undo();
    EXPECT_EQ(use(), nullptr);
    EXPECT_FALSE(line().isBound());
}

/// A tick of any slider of the form presents every line again.
TEST_F(TextureForm, VertexColoursPresentedAgain_KeepTheirIcon) {
    const TextureUse colors = textureUse(color, std::string(vertexColorsName));
    line().present(colors, {});
    const qint64 icon = line().findChild<QToolButton*>()->icon().cacheKey();
    line().present(colors, {});
    EXPECT_EQ(line().findChild<QToolButton*>()->icon().cacheKey(), icon);
}

/// They are colours: no shape of the surface, and no opacity.
TEST_F(TextureForm, VertexColours_AreNotOfferedOnTheSurface) {
    DocumentForm surface(document, images, settings::material);
    for (const char* id : {"normal", "height", "opacity"}) {
        ASSERT_NE(surface.row(id)->textureLine(), nullptr) << id;
        EXPECT_EQ(surface.row(id)->textureLine()->findChild<QToolButton*>()->menu(), nullptr) << id;
    }
}

TEST_F(TextureForm, SurfaceForm_TakesNormalAndHeightMaps) {
    DocumentForm surface(document, images, settings::material);
    surface.textures().lay(surface.row("normal")->parameter(), image());
    const Material* material = document.material(Side::A);
    ASSERT_TRUE(material->textures.contains("normal"));
    surface.textures().lay(surface.row("opacity")->parameter(), image());
    // Whether the picture has an alpha channel the renderer sees.
    EXPECT_EQ(material->textures.at("opacity").channel, TextureChannel::Auto);
}

} // namespace
} // namespace patina::tests::texture_test
