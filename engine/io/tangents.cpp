// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/tangents.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace patina {
namespace {

/// Is the length below which what is left of a tangent after projection is rounding noise.
constexpr float shortest = 1e-4f;

/// Returns the part of `t` in the plane of the normal, unit; zero when nothing is left.
glm::vec3 orthogonal(const glm::vec3& t, const glm::vec3& n) {
    const glm::vec3 rest = t - glm::dot(t, n) * n;
    const float length = glm::length(rest);
    return length > shortest ? rest / length : glm::vec3(0.0f);
}

glm::vec3 aroundAxis(const glm::vec3& n) {
    const glm::vec3 aroundY(n.z, 0.0f, -n.x);
    const float length = glm::length(aroundY);
    return length > shortest ? aroundY / length : orthogonal(glm::vec3(1.0f, 0.0f, 0.0f), n);
}

struct FaceTangent {
    glm::vec3 direction{0.0f}; ///< unit; zero when the texture coordinates have no area
    /// Is +1, or -1 where the texture is mirrored; 0 when the texture coordinates have no area.
    float side = 0.0f;
};

/// Returns the gradient of u over the triangle (Lengyel 2001). It is computed in doubles, since
/// both areas may be tiny.
FaceTangent faceTangent(const RawMesh& mesh, const std::uint32_t* corners) {
    const glm::dvec3 origin(mesh.positions[corners[0]]);
    const glm::dvec3 e1 = glm::dvec3(mesh.positions[corners[1]]) - origin;
    const glm::dvec3 e2 = glm::dvec3(mesh.positions[corners[2]]) - origin;
    const glm::dvec2 uv(mesh.uvs[corners[0]]);
    const glm::dvec2 d1 = glm::dvec2(mesh.uvs[corners[1]]) - uv;
    const glm::dvec2 d2 = glm::dvec2(mesh.uvs[corners[2]]) - uv;
    const double area = d1.x * d2.y - d2.x * d1.y;
    const double sign = area < 0.0 ? -1.0 : 1.0;
    const glm::dvec3 t = sign * (d2.y * e1 - d1.y * e2);
    const double length = glm::length(t);
    if (!(std::abs(area) > 0.0) || !(length > 0.0) || !std::isfinite(length)) {
        return {};
    }
    return {glm::vec3(t / length), static_cast<float>(sign)};
}

/// Appends a copy of a vertex for the other side of a mirror seam.
std::uint32_t twinOf(RawMesh& mesh, std::uint32_t vertex, float side) {
    const auto twin = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.emplace_back(mesh.positions[vertex]);
    mesh.normals.emplace_back(mesh.normals[vertex]);
    mesh.uvs.emplace_back(mesh.uvs[vertex]);
    if (!mesh.colors.empty()) {
        mesh.colors.emplace_back(mesh.colors[vertex]);
    }
    mesh.tangents.emplace_back(0.0f, 0.0f, 0.0f, side);
    return twin;
}

/// Sums face tangents per vertex and side of the mirror.
class Accumulator {
  public:
    explicit Accumulator(RawMesh& mesh)
        : mesh_(mesh), known_(mesh.tangents.begin(), mesh.tangents.end()),
          twins_(mesh.positions.size(), none) {
        known_.resize(mesh.positions.size(), glm::vec4(0.0f));
        mesh_.tangents.assign(mesh.positions.size(), glm::vec4(0.0f));
    }

    void addFaces() {
        for (std::size_t i = 0; i + 2 < mesh_.indices.size(); i += 3) {
            const FaceTangent face = faceTangent(mesh_, &mesh_.indices[i]);
            for (std::size_t k = 0; k < 3 && face.side != 0.0f; ++k) {
                add(mesh_.indices[i + k], face);
            }
        }
    }

    /// Restores the tangents of the file, which take precedence over computed ones.
    void preferKnown() {
        for (std::size_t i = 0; i < known_.size(); ++i) {
            if (glm::vec3(known_[i]) != glm::vec3(0.0f)) {
                mesh_.tangents[i] = known_[i];
            }
        }
    }

  private:
    static constexpr std::uint32_t none = 0xffffffff;

    void add(std::uint32_t& index, const FaceTangent& face) {
        if (glm::vec3(known_[index]) != glm::vec3(0.0f)) {
            return;
        }
        std::uint32_t vertex = index;
        float& side = mesh_.tangents[vertex].w;
        side = side == 0.0f ? face.side : side;
        if (side != face.side) {
            if (twins_[vertex] == none) {
                twins_[vertex] = twinOf(mesh_, vertex, face.side);
            }
            index = vertex = twins_[vertex];
        }
        mesh_.tangents[vertex] += glm::vec4(face.direction, 0.0f);
    }

    RawMesh& mesh_;
    std::vector<glm::vec4> known_;
    std::vector<std::uint32_t> twins_;
};

} // namespace

void completeTangents(RawMesh& mesh) {
    if (!mesh.uvs.empty()) {
        Accumulator accumulator(mesh);
        accumulator.addFaces();
        accumulator.preferKnown();
    }
    mesh.tangents.resize(mesh.positions.size(), glm::vec4(0.0f));
    for (std::size_t i = 0; i < mesh.tangents.size(); ++i) {
        const glm::vec3& n = mesh.normals[i];
        const glm::vec3 t = orthogonal(glm::vec3(mesh.tangents[i]), n);
        const bool usable = glm::dot(t, t) > 0.5f; // unit, or zero, or NaN from the file
        mesh.tangents[i] = usable ? glm::vec4(t, mesh.tangents[i].w < 0.0f ? -1.0f : 1.0f)
                                  : glm::vec4(aroundAxis(n), 1.0f);
    }
}

} // namespace patina
