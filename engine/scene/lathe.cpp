// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/lathe.h"

#include <cmath>
#include <cstdint>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace patina {

namespace {

double lengthOf(const Span& span) {
    double length = 0.0;
    for (std::size_t i = 1; i < span.size(); ++i) {
        length += glm::distance(span[i - 1].position, span[i].position);
    }
    return length;
}

/// Adds a triangle that faces its normals, unless a pole folds it to a line.
void addTriangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const glm::vec3 origin = mesh.vertices[a].position;
    const glm::vec3 normal =
        glm::cross(mesh.vertices[b].position - origin, mesh.vertices[c].position - origin);
    if (glm::dot(normal, normal) == 0.0f) {
        return;
    }
    const glm::vec3 outside =
        mesh.vertices[a].normal + mesh.vertices[b].normal + mesh.vertices[c].normal;
    if (glm::dot(normal, outside) >= 0.0f) {
        mesh.indices.insert(mesh.indices.end(), {a, b, c});
    } else {
        mesh.indices.insert(mesh.indices.end(), {a, c, b});
    }
}

void addRow(Mesh& mesh, const ProfilePoint& point, double v, double handedness, int columns) {
    for (int column = 0; column <= columns; ++column) {
        // The last column repeats the first exactly, so that the seam is closed.
        const double angle = 2.0 * std::numbers::pi * (column % columns) / columns;
        const glm::dvec3 out(std::sin(angle), 0.0, std::cos(angle));
        const glm::dvec3 position = point.position.x * out + glm::dvec3(0, point.position.y, 0);
        const glm::dvec3 normal = point.normal.x * out + glm::dvec3(0, point.normal.y, 0);
        mesh.vertices.push_back({glm::vec3(position), glm::vec3(glm::normalize(normal)),
                                 glm::vec4(out.z, 0.0, -out.x, handedness),
                                 glm::vec2(static_cast<double>(column) / columns, v)});
    }
}

} // namespace

Span segment(const glm::dvec2& from, const glm::dvec2& to, int steps) {
    const glm::dvec2 along = glm::normalize(to - from);
    const glm::dvec2 normal(along.y, -along.x);
    Span span;
    for (int i = 0; i <= steps; ++i) {
        span.push_back({glm::mix(from, to, static_cast<double>(i) / steps), normal});
    }
    return span;
}

Span arc(const glm::dvec2& centre, double radius, double from, double to, int steps) {
    Span span;
    for (int i = 0; i <= steps; ++i) {
        const double angle = glm::mix(from, to, static_cast<double>(i) / steps);
        const glm::dvec2 normal(std::sin(angle), std::cos(angle));
        glm::dvec2 position = centre + radius * normal;
        // sin(pi) is not quite zero; a pole lies on the axis.
        position.x = std::abs(position.x) < 1e-12 ? 0.0 : position.x;
        span.push_back({position, normal});
    }
    return span;
}

void addLathe(Mesh& mesh, const Profile& profile, int columns) {
    double total = 0.0;
    for (const Span& span : profile) {
        total += lengthOf(span);
    }
    const auto stride = static_cast<std::uint32_t>(columns + 1);
    double length = 0.0;
    for (const Span& span : profile) {
        for (std::size_t i = 0; i < span.size(); ++i) {
            length += i == 0 ? 0.0 : glm::distance(span[i - 1].position, span[i].position);
            const glm::dvec2 along = i == 0 ? span[1].position - span[0].position
                                            : span[i].position - span[i - 1].position;
            // The bitangent is w (n x t); in the profile's plane n x t is the normal turned left.
            const glm::dvec2 bitangent(-span[i].normal.y, span[i].normal.x);
            const double handedness = glm::dot(bitangent, along) >= 0.0 ? 1.0 : -1.0;
            addRow(mesh, span[i], length / total, handedness, columns);
            if (i == 0) {
                continue;
            }
            const auto upper = static_cast<std::uint32_t>(mesh.vertices.size()) - stride;
            const std::uint32_t lower = upper - stride;
            for (std::uint32_t column = 0; column + 1 < stride; ++column) {
                addTriangle(mesh, lower + column, lower + column + 1, upper + column + 1);
                addTriangle(mesh, lower + column, upper + column + 1, upper + column);
            }
        }
    }
}

} // namespace patina
