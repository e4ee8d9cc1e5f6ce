// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/obj_reader.h"

#include <algorithm>
#include <istream>
#include <streambuf>
#include <string>
#include <utility>

#include <tiny_obj_loader.h>

#include "io/obj_commas.h"
#include "io/obj_dialect.h"
#include "io/text_file.h"

namespace patina {
namespace {

/// Provides a text piece by piece and reports how much of it was taken.
class ReportedText final : public std::streambuf {
  public:
    ReportedText(std::string text, const ReportProgress& report)
        : text_(std::move(text)), report_(report) {}

  protected:
    int_type underflow() override {
        constexpr std::size_t piece = std::size_t(1) << 20;
        if (taken_ == text_.size()) {
            return traits_type::eof();
        }
        report_(double(taken_) / double(text_.size()));
        const std::size_t count = std::min(piece, text_.size() - taken_);
        char* const first = text_.data() + taken_;
        setg(first, first, first + count);
        taken_ += count;
        return traits_type::to_int_type(*first);
    }

  private:
    std::string text_;
    const ReportProgress& report_;
    std::size_t taken_ = 0;
};

struct Obj {
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
};

std::optional<Obj> parsed(std::string text, const ReportProgress& report) {
    ReportedText source(std::move(text), report);
    std::istream stream(&source);
    Obj obj;
    std::vector<tinyobj::material_t> materials;
    std::string warning;
    std::string error;
    constexpr bool triangulate = false; // there are only triangles
    constexpr bool whiteWhereNoColor = false;
    const bool read = tinyobj::LoadObj(&obj.attributes, &obj.shapes, &materials, &warning, &error,
                                       &stream, nullptr, triangulate, whiteWhereNoColor);
    return read && error.empty() ? std::optional(std::move(obj)) : std::nullopt;
}

/// Tells whether there is an item of this index among the values, `components` at a time.
bool hasItem(int index, const std::vector<tinyobj::real_t>& values, std::size_t components) {
    return index >= 0 && std::size_t(index) < values.size() / components;
}

template <class Vector>
Vector valueAt(const std::vector<tinyobj::real_t>& values, std::size_t index) {
    Vector value;
    for (int k = 0; k < Vector::length(); ++k) {
        value[k] = values[index * Vector::length() + std::size_t(k)];
    }
    return value;
}

/// Adds the colour behind a position, if the file has colours there.
void addColor(RawMesh& mesh, const tinyobj::attrib_t& from, std::size_t vertex) {
    if (!from.colors.empty()) {
        const bool isThere = hasItem(static_cast<int>(vertex), from.colors, 3);
        mesh.colors.emplace_back(
            isThere ? valueAt<glm::vec3>(from.colors, vertex) : glm::vec3(1.0f), 1.0f);
    }
}

/// Takes the positions as vertices, for a file without normals and texture coordinates.
void takePositions(RawMesh& mesh, const tinyobj::attrib_t& attributes) {
    const std::size_t count = attributes.vertices.size() / 3;
    mesh.positions.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        mesh.positions.push_back(valueAt<glm::vec3>(attributes.vertices, i));
        addColor(mesh, attributes, i);
    }
}

/// Adds a corner as a vertex of its own; equal vertices are joined later.
void addCorner(RawMesh& mesh, const tinyobj::attrib_t& from, const tinyobj::index_t& corner) {
    mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
    mesh.positions.push_back(valueAt<glm::vec3>(from.vertices, std::size_t(corner.vertex_index)));
    addColor(mesh, from, std::size_t(corner.vertex_index));
    if (!from.normals.empty()) {
        mesh.normals.push_back(
            hasItem(corner.normal_index, from.normals, 3)
                ? valueAt<glm::vec3>(from.normals, std::size_t(corner.normal_index))
                : glm::vec3(0.0f));
    }
    if (!from.texcoords.empty()) {
        mesh.uvs.push_back(
            hasItem(corner.texcoord_index, from.texcoords, 2)
                ? valueAt<glm::vec2>(from.texcoords, std::size_t(corner.texcoord_index))
                : glm::vec2(0.0f));
    }
}

/// Adds the triangles of a shape. Returns false for an index beyond the vertices, and for a number
/// of corners that is no multiple of three.
bool addShape(RawMesh& mesh, const tinyobj::attrib_t& from, const tinyobj::shape_t& shape) {
    const bool alone = from.normals.empty() && from.texcoords.empty();
    mesh.pointsAndLines += shape.lines.num_line_vertices.size() + shape.points.indices.size();
    mesh.indices.reserve(mesh.indices.size() + shape.mesh.indices.size());
    for (const tinyobj::index_t& corner : shape.mesh.indices) {
        if (!hasItem(corner.vertex_index, from.vertices, 3)) {
            return false;
        }
        if (alone) {
            mesh.indices.push_back(static_cast<std::uint32_t>(corner.vertex_index));
        } else {
            addCorner(mesh, from, corner);
        }
    }
    return shape.mesh.indices.size() % 3 == 0;
}

} // namespace

std::optional<RawMesh> readPlainObj(const std::filesystem::path& file, bool byMaterial,
                                    const ReportProgress& report) {
    std::optional<std::string> text = textOf(file);
    if (!text || !isPlainObj(*text) || (byMaterial && choosesMaterials(*text))) {
        return std::nullopt;
    }
    const auto obj = parsed(std::move(*text), report);
    if (!obj || obj->shapes.empty()) {
        return std::nullopt;
    }
    RawMesh mesh;
    if (obj->attributes.normals.empty() && obj->attributes.texcoords.empty()) {
        takePositions(mesh, obj->attributes);
    }
    const bool whole = std::ranges::all_of(obj->shapes, [&](const tinyobj::shape_t& shape) {
        return addShape(mesh, obj->attributes, shape);
    });
    mesh.decodeColors();
    return whole ? std::optional(std::move(mesh)) : std::nullopt;
}

Result<std::optional<std::string>> objForAssimp(const std::filesystem::path& file) {
    std::optional<std::string> text = textOf(file);
    if (!text) {
        return text;
    }
    if (const auto comma = unclearComma(*text)) {
        return tl::unexpected(*comma);
    }
    if (auto whole = withLeadingZeros(*text)) {
        return whole;
    }
    return startsWithMark(file) ? std::move(text) : std::nullopt;
}

} // namespace patina
