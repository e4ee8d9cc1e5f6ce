// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace patina {

/// Holds one vertex as the GPU reads it: 48 bytes, object space, metres.
struct Vertex {
    glm::vec3 position{0.0f};
    glm::vec3 normal{0.0f, 0.0f, 1.0f};        ///< unit
    glm::vec4 tangent{1.0f, 0.0f, 0.0f, 1.0f}; ///< xyz unit or zero (unknown); w = +1 or -1
    glm::vec2 uv{0.0f};

    friend bool operator==(const Vertex&, const Vertex&) = default;
};

/// Says how much of its surroundings a vertex sees past its own mesh, as the GPU reads it: 8 bytes
/// (mesh_openness.h). The initial value says that nothing is hidden.
struct VertexOpenness {
    /// Holds, with y and z, the mean of the unoccluded directions times their share, minus the
    /// normal, in object space, in units of `unit`.
    std::int16_t x = 0;
    std::int16_t y = 0;
    std::int16_t z = 0;
    std::int16_t back = 1; ///< is the share that is hidden from the back of the surface, 1 .. 32767

    static constexpr float unit = 1.4142136f / 32767.0f;

    friend bool operator==(const VertexOpenness&, const VertexOpenness&) = default;
};

/// Holds a vertex's colour in linear light and its alpha, as the GPU reads it: 8 bytes, 65535 is 1.
/// The initial value is white.
struct VertexColor {
    /// Says, with green and blue, how much is missing from white.
    std::uint16_t red = 0;
    std::uint16_t green = 0;
    std::uint16_t blue = 0;
    std::uint16_t alpha = 65535;

    friend bool operator==(const VertexColor&, const VertexColor&) = default;
};

/// Is an axis-aligned box, empty (lower > upper) until the first point is added.
struct Bounds {
    glm::vec3 lower{1e30f};
    glm::vec3 upper{-1e30f};

    bool empty() const { return lower.x > upper.x; }
    glm::vec3 center() const { return 0.5f * (lower + upper); }
    glm::vec3 size() const { return upper - lower; }
    void add(const glm::vec3& point);

    friend bool operator==(const Bounds&, const Bounds&) = default;
};

/// Refers to a triangle list that somebody else owns (a Mesh, or memory shared with another
/// process).
struct MeshView {
    std::span<const Vertex> vertices;
    /// Holds three per triangle, counter-clockwise from outside.
    std::span<const std::uint32_t> indices;
    Bounds bounds;
    /// Holds one per vertex; if it is empty, nothing is hidden.
    std::span<const VertexOpenness> openness{};
    /// Holds one per vertex; if it is empty, all are white.
    std::span<const VertexColor> colors{};
};

/// Owns a triangle list.
struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    Bounds bounds;

    MeshView view() const { return {vertices, indices, bounds}; }
};

/// Returns the box around all vertices; it is empty for none.
Bounds boundsOf(std::span<const Vertex> vertices);

} // namespace patina
