// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstddef>
#include <cstring>
#include <optional>
#include <string_view>
#include <type_traits>

namespace patina {

static_assert(std::endian::native == std::endian::little, "the files hold numbers in this order");

/// Reads little-endian numbers from bytes, one after the other. What is not there is nothing.
class ByteReader {
  public:
    explicit ByteReader(std::string_view bytes, std::size_t place = 0)
        : bytes_(bytes), place_(place) {}

    std::size_t place() const { return place_; } ///< bytes before the next number

    template <class Number>
    requires std::is_arithmetic_v<Number> std::optional<Number> next() {
        const std::optional<std::string_view> found = next(sizeof(Number));
        if (!found) {
            return std::nullopt;
        }
        Number number{};
        std::memcpy(&number, found->data(), sizeof(Number));
        return number;
    }

    std::optional<std::string_view> next(std::size_t count) {
        if (place_ > bytes_.size() || count > bytes_.size() - place_) {
            return std::nullopt;
        }
        place_ += count;
        return bytes_.substr(place_ - count, count);
    }

  private:
    std::string_view bytes_;
    std::size_t place_;
};

} // namespace patina
