// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "parameters/parameter_source.h"

namespace patina {

/// Reads and edits how the image of one value lies, as the values of a form: see textureSettings().
class TextureSettingsSource : public ParameterSource {
  public:
    /// `owner` has the value and outlives this.
    TextureSettingsSource(ParameterSource& owner, std::string parameterId)
        : owner_(owner), parameterId_(std::move(parameterId)) {}

    Value value(const Parameter& setting) const override {
        const std::optional<TextureUse> use = owner_.texture(parameterId_);
        return use ? textureSetting(*use, setting.id) : setting.defaultValue;
    }
    void setValue(std::string_view settingId, const Value& value) override {
        if (std::optional<TextureUse> use = owner_.texture(parameterId_)) {
            storeTextureSetting(*use, settingId, value);
            owner_.setTexture(parameterId_, use);
        }
    }
    void edit(const ValueEdits& edits, const QString&) override {
        if (std::optional<TextureUse> use = owner_.texture(parameterId_)) {
            for (const auto& [id, value] : edits.values) {
                storeTextureSetting(*use, id, value);
            }
            owner_.setTexture(parameterId_, use);
        }
    }
    int beginInteraction(std::string_view) override {
        return owner_.beginInteraction(parameterId_);
    }
    void endInteraction(int token) override { owner_.endInteraction(token); }

  private:
    ParameterSource& owner_;
    std::string parameterId_;
};

} // namespace patina
