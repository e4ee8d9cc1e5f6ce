// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <QImage>
#include <QString>

#include "catalog/parameter.h"
#include "material/texture_use.h"

namespace patina {

/// Holds what is known of an image that lies on a value.
struct TexturePreview {
    QImage image;          ///< is small; null while it is being read
    QString problem;       ///< says why it is missing; empty while it is not
    bool hasAlpha = false; ///< says that some of it is not opaque
};

/// Holds several values that are set at once, and images on them; one that is nothing is taken
/// away.
struct ValueEdits {
    Values values{};
    std::map<std::string, std::optional<TextureUse>, std::less<>> textures{};

    bool isEmpty() const { return values.empty() && textures.empty(); }
};

/// Reads the values that a form shows, and takes its edits.
class ParameterSource {
  public:
    virtual ~ParameterSource() = default;

    virtual Value value(const Parameter& parameter) const = 0;
    virtual void setValue(std::string_view parameterId, const Value& value) = 0;

    /// Is called when the value may be changed soon.
    virtual void prewarm(std::string_view /*parameterId*/) {}

    /// Edits between these two are one undo step, and drag this value; see Document.
    virtual int beginInteraction(std::string_view parameterId) = 0;
    virtual void endInteraction(int token) = 0;

    /// Tells whether values may have images.
    virtual bool takesTextures() const { return false; }
    virtual std::optional<TextureUse> texture(std::string_view) const { return std::nullopt; }
    virtual void setTexture(std::string_view, const std::optional<TextureUse>&) {}
    virtual TexturePreview preview(const TextureUse&) const { return {}; }
    /// Tells whether a window of Patina may read an image whose path is copied there.
    virtual bool mayRead(const TextureUse& use) const { return !use.outside; }

    /// Sets several values as one undo step with this label.
    virtual void edit(const ValueEdits& edits, const QString& label) = 0;

    /// Tells whether values may be locked: what sets a whole group leaves those alone.
    virtual bool takesLocks() const { return false; }
    virtual bool isLocked(std::string_view) const { return false; }
    virtual void setLocked(const std::vector<std::string>&, bool) {}

    /// Tells the user what was left out.
    virtual void report(const Error&) {}
};

} // namespace patina
