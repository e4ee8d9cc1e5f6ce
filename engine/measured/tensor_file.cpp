// SPDX-License-Identifier: GPL-3.0-or-later
#include "measured/tensor_file.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include <fmt/format.h>

#include "measured/byte_reader.h"

namespace patina {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view magic = "tensor_file\0"sv;
constexpr std::uint8_t byteType = 1;
constexpr std::uint8_t floatType = 10;
constexpr std::size_t maxFields = 64;
constexpr std::size_t maxDimensions = 8;

tl::unexpected<Error> wrongAt(std::size_t byte, const std::string& what) {
    return failure(fmt::format("byte {}: {}", byte, what), "an RGL file");
}

/// Holds what a file says of an array before its numbers.
struct Header {
    std::string name;
    std::uint8_t type = 0;
    std::size_t offset = 0;
    std::size_t typePlace = 0; ///< is the byte of the type
    std::size_t count = 1;
    std::vector<std::size_t> shape{};
};

Result<Header> nextHeader(ByteReader& reader, std::size_t fileBytes) {
    const std::size_t start = reader.place();
    const auto length = reader.next<std::uint16_t>();
    const auto name = length ? reader.next(*length) : std::nullopt;
    const auto dimensions = name ? reader.next<std::uint16_t>() : std::nullopt;
    const std::size_t typePlace = reader.place();
    const auto type = dimensions ? reader.next<std::uint8_t>() : std::nullopt;
    const auto offset = type ? reader.next<std::uint64_t>() : std::nullopt;
    if (!offset || *dimensions > maxDimensions) {
        return wrongAt(start, "the description of an array is damaged");
    }
    if (*offset > fileBytes) {
        return wrongAt(typePlace + sizeof(*type),
                       fmt::format("\"{}\" begins behind the end of the file", *name));
    }
    Header header{std::string(*name), *type, std::size_t(*offset), typePlace};
    for (std::uint16_t i = 0; i < *dimensions; ++i) {
        const auto size = reader.next<std::uint64_t>();
        if (!size || *size == 0 || *size > fileBytes / header.count) {
            return wrongAt(start, fmt::format("the size of \"{}\" is damaged", header.name));
        }
        header.shape.push_back(std::size_t(*size));
        header.count *= header.shape.back();
    }
    return header;
}

Result<TensorField> numbersOf(const Header& header, std::string_view bytes) {
    TensorField field{TensorField::Type::Floats, header.shape};
    field.offset = header.offset;
    field.typePlace = header.typePlace;
    field.typeNumber = header.type;
    ByteReader reader(bytes, header.offset);
    if (header.type != byteType && header.type != floatType) {
        field.type = TensorField::Type::Other;
        return field;
    }
    if (header.type == byteType) {
        const auto found = reader.next(header.count);
        if (!found) {
            return wrongAt(header.offset, fmt::format("\"{}\" ends too early", header.name));
        }
        field.type = TensorField::Type::Bytes;
        field.bytes = *found;
        return field;
    }
    const std::size_t rest = bytes.size() - std::min(header.offset, bytes.size());
    field.floats.reserve(std::min(header.count, rest / sizeof(float)));
    for (std::size_t i = 0; i < header.count; ++i) {
        const std::size_t place = reader.place();
        const auto number = reader.next<float>();
        if (!number) {
            return wrongAt(place, fmt::format("\"{}\" ends too early", header.name));
        }
        if (!std::isfinite(*number)) {
            return wrongAt(place, fmt::format("\"{}\" is {} there", header.name, *number));
        }
        field.floats.push_back(*number);
    }
    return field;
}

} // namespace

bool isTensorFile(std::string_view bytes) {
    return bytes.starts_with(magic);
}

std::string typeText(const TensorField& field) {
    constexpr std::string_view names[] = {"uint8",   "int8",    "uint16", "int16",
                                          "uint32",  "int32",   "uint64", "int64",
                                          "float16", "float32", "float64"};
    const int count = static_cast<int>(std::size(names));
    return field.typeNumber >= 1 && field.typeNumber <= count
               ? std::string(names[field.typeNumber - 1])
               : fmt::format("the unknown type {}", field.typeNumber);
}

Result<TensorFields> tensorFields(std::string_view bytes) {
    ByteReader reader(bytes, magic.size());
    const auto major = reader.next<std::uint8_t>();
    const auto minor = reader.next<std::uint8_t>();
    const auto count = reader.next<std::uint32_t>();
    if (!count || *major != 1 || *minor != 0) {
        return wrongAt(magic.size(), "the version is not 1.0");
    }
    if (*count > maxFields) {
        return wrongAt(magic.size() + 2, fmt::format("{} arrays are too many", *count));
    }
    TensorFields fields;
    std::size_t all = 0;
    for (std::uint32_t i = 0; i < *count; ++i) {
        const auto header = nextHeader(reader, bytes.size());
        if (!header) {
            return tl::unexpected(header.error());
        }
        all += header->type == floatType  ? header->count * sizeof(float)
               : header->type == byteType ? header->count
                                          : 0;
        if (all > bytes.size()) {
            return wrongAt(header->offset, fmt::format("\"{}\" ends too early", header->name));
        }
        auto field = numbersOf(*header, bytes);
        if (!field) {
            return tl::unexpected(field.error());
        }
        fields[header->name] = std::move(*field);
    }
    return fields;
}

} // namespace patina
