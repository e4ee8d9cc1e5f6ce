// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/material_text.h"

#include "assets/message.h"
#include "core/number_text.h"

namespace patina {
namespace {

/// Takes texts from the front of a list. Once one was missing or wrong it stays failed, and gives
/// empty texts and zeros.
class TextReader {
  public:
    explicit TextReader(std::vector<std::string> texts) : texts_(std::move(texts)) {}

    std::string text() {
        if (next_ >= texts_.size()) {
            isGood_ = false;
            return {};
        }
        return texts_[next_++];
    }

    double number() {
        const auto value = parseNumber(text());
        isGood_ = isGood_ && value.has_value();
        return value.value_or(0.0);
    }

    /// Returns a count, of which each one is followed by a text at least.
    std::size_t count() {
        const double value = number();
        if (!(value >= 0.0 && value <= double(texts_.size() - next_))) {
            isGood_ = false;
            return 0;
        }
        return static_cast<std::size_t>(value);
    }

    bool isGood() const { return isGood_; }
    bool isWhole() const { return isGood_ && next_ == texts_.size(); }

  private:
    std::vector<std::string> texts_;
    std::size_t next_ = 0;
    bool isGood_ = true;
};

void append(std::vector<std::string>& texts, const MeshMaterial& material) {
    texts.push_back(material.name);
    texts.push_back(material.look);
    texts.push_back(std::to_string(material.values.size()));
    for (const auto& [word, value] : material.values) {
        texts.insert(texts.end(), {word, fullText(value.x), fullText(value.y), fullText(value.z)});
    }
    for (const auto* images : {&material.images, &material.presetImages}) {
        texts.push_back(std::to_string(images->size()));
        for (const auto& [word, file] : *images) {
            texts.insert(texts.end(), {word, file});
        }
    }
    texts.insert(texts.end(), {material.preset, material.foreign});
}

MeshMaterial takeMaterial(TextReader& reader) {
    MeshMaterial material;
    material.name = reader.text();
    material.look = reader.text();
    for (std::size_t i = reader.count(); i > 0 && reader.isGood(); --i) {
        glm::dvec3& value = material.values[reader.text()];
        value.x = reader.number();
        value.y = reader.number();
        value.z = reader.number();
    }
    for (auto* images : {&material.images, &material.presetImages}) {
        for (std::size_t i = reader.count(); i > 0 && reader.isGood(); --i) {
            std::string& file = (*images)[reader.text()];
            file = reader.text();
        }
    }
    material.preset = reader.text();
    material.foreign = reader.text();
    return material;
}

} // namespace

std::string materialText(std::span<const MeshPart> parts) {
    std::vector<std::string> texts;
    for (const MeshPart& part : parts) {
        append(texts, part.material);
    }
    return joinedPaths(texts);
}

std::optional<std::vector<MeshMaterial>> materialsIn(std::string_view text, std::size_t count) {
    TextReader reader(splitPaths(text));
    std::vector<MeshMaterial> materials;
    for (std::size_t i = 0; i < count && reader.isGood(); ++i) {
        materials.push_back(takeMaterial(reader));
    }
    return reader.isWhole() ? std::optional(std::move(materials)) : std::nullopt;
}

} // namespace patina
