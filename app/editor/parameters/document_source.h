// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "parameters/parameter_source.h"

namespace patina {

class TextureLibrary;

/// Reads and edits the values at a path of a document.
class DocumentSource : public ParameterSource {
  public:
    DocumentSource(Document& document, TextureLibrary& textures, const BlockPath& path)
        : document_(document), textures_(textures), path_(path) {}

    Value value(const Parameter& parameter) const override {
        return document_.value(path_, parameter);
    }
    void setValue(std::string_view parameterId, const Value& value) override {
        document_.setValue(path_, parameterId, value);
    }
    void prewarm(std::string_view parameterId) override {
        Q_EMIT document_.valueApproached({path_, std::string(parameterId)});
    }
    int beginInteraction(std::string_view parameterId) override {
        return document_.interaction().begin(ParameterTarget{path_, std::string(parameterId)});
    }
    void endInteraction(int token) override { document_.interaction().end(token); }

    bool takesTextures() const override { return patina::takesTextures(path_); }
    std::optional<TextureUse> texture(std::string_view parameterId) const override;
    void setTexture(std::string_view parameterId, const std::optional<TextureUse>& use) override;
    TexturePreview preview(const TextureUse& use) const override;

    void edit(const ValueEdits& edits, const QString& label) override {
        document_.setValues(path_, edits.values, label, edits.textures);
    }

    bool takesLocks() const override { return true; }
    bool isLocked(std::string_view parameterId) const override;
    void setLocked(const std::vector<std::string>& parameterIds, bool locked) override;

    void report(const Error& message) override { Q_EMIT document_.reported(message); }

  private:
    Document& document_;
    TextureLibrary& textures_;
    BlockPath path_;
};

} // namespace patina
