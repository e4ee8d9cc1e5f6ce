// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/form_textures.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QToolButton>

#include "catalog/combing_role.h"
#include "parameters/parameter_row.h"
#include "parameters/texture_line.h"
#include "parameters/texture_popup.h"

namespace patina {
namespace {

bool takesImage(const Parameter& parameter) {
    return !parameter.textureChannels.empty();
}

/// Tells whether vertex colours may drive the value: they are neither a shape nor an opacity nor
/// directions.
bool takesVertexColors(const Parameter& parameter) {
    return textureRole(parameter.id) == TextureRole::Input && parameter.role != roles::combing;
}

/// Returns how an image lies at first. On a number whose range exceeds 1 it multiplies the number.
TextureUse firstUse(const Parameter& parameter, const std::string& file) {
    TextureUse use = textureUse(parameter.id, file);
    if (parameter.type == ParameterType::Float && parameter.max > 1.0) {
        use.mode = TextureMode::Multiply;
    }
    return use;
}

} // namespace

FormTextures::FormTextures(QWidget* form) : QObject(form), form_(form) {}

void FormTextures::setSource(ParameterSource* source) {
    source_ = source;
    if (popup_) {
        popup_->close();
    }
}

void FormTextures::attach(ParameterRow& row) {
    if (!takesImage(row.parameter())) {
        return;
    }
    TextureLine* line = row.makeTextureLine();
    if (takesVertexColors(row.parameter())) {
        line->offerVertexColors();
    }
    connect(line, &TextureLine::chooseWished, this, [this, &row] { ask(row); });
    connect(line, &TextureLine::vertexColorsWished, this,
            [this, &row] { drive(row.parameter(), std::string(vertexColorsName)); });
    connect(line, &TextureLine::settingsWished, this, [this, &row] { showSettings(row); });
    connect(line, &TextureLine::allowWished, this, [this, &row] { allow(row.parameter()); });
    connect(line, &TextureLine::removeWished, this,
            [this, &row] { source_->setTexture(row.parameter().id, std::nullopt); });
    connect(line, &TextureLine::enabledWished, this,
            [this, &row](bool enabled) { setEnabled(row.parameter(), enabled); });
    connect(&row, &ParameterRow::imageDropped, this,
            [this, &row](const QString& file) { lay(row.parameter(), file); });
}

void FormTextures::present(ParameterRow& row) {
    if (!row.textureLine()) {
        return;
    }
    const std::optional<TextureUse> use = source_->texture(row.parameter().id);
    row.presentTexture(source_->takesTextures(), use,
                       use ? source_->preview(*use) : TexturePreview());
    if (popup_ && popupId_ == row.parameter().id) {
        use ? popup_->refresh() : void(popup_->close());
    }
}

void FormTextures::lay(const Parameter& parameter, const QString& file) {
    const QString full = QFileInfo(file).absoluteFilePath();
    folder_ = QFileInfo(full).path();
    drive(parameter, full.toStdString());
}

void FormTextures::drive(const Parameter& parameter, const std::string& file) {
    std::optional<TextureUse> use = source_->texture(parameter.id);
    if (use) {
        use->file = file;
        use->outside = false;
    } else {
        use = firstUse(parameter, file);
    }
    source_->setTexture(parameter.id, use);
}

void FormTextures::allow(const Parameter& parameter) {
    if (std::optional<TextureUse> use = source_->texture(parameter.id)) {
        use->outside = false;
        source_->setTexture(parameter.id, use);
    }
}

void FormTextures::setEnabled(const Parameter& parameter, bool enabled) {
    if (std::optional<TextureUse> use = source_->texture(parameter.id)) {
        use->enabled = enabled;
        source_->setTexture(parameter.id, use);
    }
}

QString FormTextures::startFolder(const Parameter& parameter) const {
    const std::optional<TextureUse> use = source_->texture(parameter.id);
    return use && !isVertexColors(use->file) ? QString::fromStdString(use->file) : folder_;
}

void FormTextures::ask(const ParameterRow& row) {
    const auto parameter = Parameter(row.parameter()); // the row may go while the dialog is open
    const QString file = QFileDialog::getOpenFileName(
        form_, tr("Image on %1").arg(QString::fromStdString(parameter.label)),
        startFolder(parameter),
        tr("Images (*.png *.jpg *.jpeg *.exr *.hdr *.tif *.tiff *.dds *.ktx *.tga *.bmp);;"
           "All files (*)"));
    if (!file.isEmpty()) {
        lay(parameter, file);
    }
}

void FormTextures::showSettings(const ParameterRow& row) {
    popup_ = new TexturePopup(*source_, row.parameter(), form_);
    popupId_ = row.parameter().id;
    popup_->adjustSize();
    const QWidget* button = row.textureLine()->settingsButton();
    popup_->move(button->mapToGlobal(QPoint(button->width() - popup_->width(), button->height())));
    popup_->show();
}

TexturePopup* FormTextures::popup() const {
    return popup_;
}

} // namespace patina
