// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/material_hash.h"

#include <bit>
#include <cstring>
#include <string_view>
#include <variant>

namespace patina {
namespace {

/// Is MurmurHash3's x64 mixing (Austin Appleby, public domain) of one 64-bit lane, eight
/// bytes at a time.
class ValueHash {
  public:
    void add(std::uint64_t word) {
        word *= 0x87c37b91114253d5u;
        word = std::rotl(word, 31) * 0x4cf5ad432745937fu;
        value_ = std::rotl(value_ ^ word, 27) * 5 + 0x52dce729u;
    }
    void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
    void add(std::string_view text) {
        add(std::uint64_t(text.size()));
        for (; text.size() >= sizeof(std::uint64_t); text.remove_prefix(sizeof(std::uint64_t))) {
            addBytes(text.substr(0, sizeof(std::uint64_t)));
        }
        addBytes(text);
    }
    template <class... More>
    void add(double first, double second, More... more) {
        add(first);
        add(second, more...);
    }

    std::uint64_t value() const {
        std::uint64_t mixed = (value_ ^ (value_ >> 33)) * 0xff51afd7ed558ccdu;
        mixed = (mixed ^ (mixed >> 33)) * 0xc4ceb9fe1a85ec53u;
        return mixed ^ (mixed >> 33);
    }

  private:
    void addBytes(std::string_view bytes) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data(), bytes.size());
        add(word);
    }

    std::uint64_t value_ = 0;
};

void add(ValueHash& hash, const Value& value) {
    hash.add(std::uint64_t(value.index()));
    if (const auto* number = std::get_if<double>(&value)) {
        hash.add(*number);
    } else if (const auto* triple = std::get_if<glm::dvec3>(&value)) {
        hash.add(triple->x, triple->y, triple->z);
    } else if (const auto* pair = std::get_if<glm::dvec2>(&value)) {
        hash.add(pair->x, pair->y);
    } else if (const auto* text = std::get_if<std::string>(&value)) {
        hash.add(std::string_view(*text));
    } else if (const auto* list = std::get_if<NumberList>(&value)) {
        hash.add(std::uint64_t(list->numbers.size()));
        for (const double element : list->numbers) {
            hash.add(element);
        }
    } else if (const auto* whole = std::get_if<int>(&value)) {
        hash.add(static_cast<std::uint64_t>(*whole));
    } else {
        hash.add(std::uint64_t(std::get<bool>(value) ? 1 : 0));
    }
}

void add(ValueHash& hash, const BlockValues& block) {
    hash.add(std::string_view(block.id));
    hash.add(std::uint64_t(block.parameters.size()));
    for (const auto& [id, value] : block.parameters) {
        hash.add(std::string_view(id));
        add(hash, value);
    }
}

void add(ValueHash& hash, const TextureUse& use) {
    hash.add(std::string_view(use.file));
    for (const int choice :
         {int(use.outside), int(use.enabled), int(use.colorSpace), int(use.channel), int(use.mode),
          int(use.wrap), int(use.filter), int(use.cutOut)}) {
        hash.add(static_cast<std::uint64_t>(choice));
    }
    hash.add(use.scale.x, use.scale.y, use.offset.x, use.offset.y, use.rotation, use.strength,
             use.threshold);
}

} // namespace

std::uint64_t materialHash(const Material& material) {
    ValueHash hash;
    add(hash, material.model);
    hash.add(std::uint64_t(material.parts.size()));
    for (const auto& [kind, part] : material.parts) {
        hash.add(std::string_view(kind));
        add(hash, part);
    }
    hash.add(material.opacity);
    hash.add(std::uint64_t(material.accuracy.size()));
    for (const auto& [id, level] : material.accuracy) {
        hash.add(std::string_view(id));
        hash.add(std::string_view(level));
    }
    for (const auto& [id, use] : material.textures) {
        hash.add(std::string_view(id));
        add(hash, use);
    }
    return hash.value();
}

} // namespace patina
