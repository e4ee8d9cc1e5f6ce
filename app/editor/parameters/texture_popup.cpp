// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/texture_popup.h"

#include <QVBoxLayout>

#include "parameters/parameter_form.h"
#include "parameters/texture_settings_source.h"

namespace patina {
namespace {

constexpr int formWidth = 340;

Block settingsOf(const ParameterSource& owner, const Parameter& parameter) {
    const std::optional<TextureUse> use = owner.texture(parameter.id);
    return use && isVertexColors(use->file)
               ? vertexColorSettings(parameter.textureChannels)
               : textureSettings(textureRole(parameter.id), parameter.textureChannels);
}

} // namespace

TexturePopup::TexturePopup(ParameterSource& owner, const Parameter& parameter, QWidget* parent)
    : QFrame(parent, Qt::Popup), settings_(settingsOf(owner, parameter)),
      form_(new ParameterForm(this)) {
    setAttribute(Qt::WA_DeleteOnClose);
    setFrameShape(QFrame::StyledPanel);
    setObjectName("texturePopup");
    setAccessibleName(tr("Image of %1").arg(QString::fromStdString(parameter.label)));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(form_);
    form_->setMinimumWidth(formWidth);
    form_->setBlock(&settings_, std::make_unique<TextureSettingsSource>(owner, parameter.id));
}

void TexturePopup::refresh() {
    form_->refresh();
}

} // namespace patina
