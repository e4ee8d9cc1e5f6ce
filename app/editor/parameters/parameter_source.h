// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include <QImage>
#include <QString>

#include "catalog/parameter.h"
#include "material/texture_use.h"

namespace patina {

/// Holds what is known of an image that lies on a value.
struct TexturePreview {
    QImage image;          ///< small; null while it is on its way
    QString problem;       ///< why it is missing; empty while it is not
    bool hasAlpha = false; ///< and not only 1
};

/// Tells where a form's values come from and where its edits go.
class ParameterSource {
  public:
    virtual ~ParameterSource() = default;

    virtual Value value(const Parameter& parameter) const = 0;
    virtual void setValue(std::string_view parameterId, const Value& value) = 0;

    /// The value may be changed soon.
    virtual void prewarm(std::string_view /*parameterId*/) {}

    /// Edits between these are one undo step, and drag this value; see Document.
    virtual int beginInteraction(std::string_view parameterId) = 0;
    virtual void endInteraction(int token) = 0;

    /// Tells whether values may have images.
    virtual bool takesTextures() const { return false; }
    virtual std::optional<TextureUse> texture(std::string_view) const { return std::nullopt; }
    virtual void setTexture(std::string_view, const std::optional<TextureUse>&) {}
    virtual TexturePreview preview(const TextureUse&) const { return {}; }
};

} // namespace patina
