// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/primitives.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "scene/gem_cuts.h"
#include "scene/lathe.h"

namespace patina {

namespace {

using std::numbers::pi;

/// Is the number of steps round an axis. An outline of 1000 pixels across is then at most 0.16
/// pixels from the true circle, and triangles are large enough to be cheap for a renderer without a
/// GPU.
constexpr int columns = 128;

Mesh finished(Mesh mesh) {
    mesh.bounds = boundsOf(mesh.vertices);
    return mesh;
}

Mesh sphere() {
    Mesh mesh;
    addLathe(mesh, {arc({0.0, 0.0}, 1.0, pi, 0.0, columns / 2)}, columns);
    return finished(std::move(mesh));
}

Mesh torus() {
    Mesh mesh;
    addLathe(mesh, {arc({0.72, 0.0}, 0.28, -pi, pi, 64)}, 160);
    return finished(std::move(mesh));
}

Mesh cylinder() {
    Mesh mesh;
    const glm::dvec2 bottomCentre(0.0, -1.0);
    const glm::dvec2 bottomRim(0.8, -1.0);
    const glm::dvec2 topRim(0.8, 1.0);
    const glm::dvec2 topCentre(0.0, 1.0);
    addLathe(mesh,
             {segment(bottomCentre, bottomRim, 8), segment(bottomRim, topRim, 32),
              segment(topRim, topCentre, 8)},
             128);
    return finished(std::move(mesh));
}

Mesh cone() {
    Mesh mesh;
    const glm::dvec2 bottomCentre(0.0, -1.0);
    const glm::dvec2 rim(0.9, -1.0);
    addLathe(mesh, {segment(bottomCentre, rim, 8), segment(rim, {0.0, 1.0}, 64)}, 128);
    return finished(std::move(mesh));
}

/// Adds a square grid of side 2 round `centre` that faces along `n`; u runs along t, v along n x t.
void addSquare(Mesh& mesh, const glm::vec3& centre, const glm::vec3& n, const glm::vec3& t,
               int cells) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const glm::vec3 b = glm::cross(n, t);
    const auto side = static_cast<std::uint32_t>(cells + 1);
    for (std::uint32_t row = 0; row < side; ++row) {
        for (std::uint32_t column = 0; column < side; ++column) {
            const glm::vec2 uv = glm::vec2(static_cast<float>(column), static_cast<float>(row)) /
                                 static_cast<float>(cells);
            const glm::vec3 position = centre + (2.0f * uv.x - 1.0f) * t + (2.0f * uv.y - 1.0f) * b;
            mesh.vertices.push_back({position, n, glm::vec4(t, 1.0f), uv});
        }
    }
    for (std::uint32_t row = 0; row + 1 < side; ++row) {
        for (std::uint32_t column = 0; column + 1 < side; ++column) {
            const std::uint32_t corner = first + row * side + column;
            mesh.indices.insert(mesh.indices.end(), {corner, corner + 1, corner + side + 1, corner,
                                                     corner + side + 1, corner + side});
        }
    }
}

Mesh plane() {
    Mesh mesh;
    addSquare(mesh, glm::vec3(0.0f), {0.0f, 1.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, 16);
    return finished(std::move(mesh));
}

Mesh cube() {
    const std::array<std::pair<glm::vec3, glm::vec3>, 6> normalAndTangent{{
        {{1, 0, 0}, {0, 0, -1}},
        {{-1, 0, 0}, {0, 0, 1}},
        {{0, 1, 0}, {1, 0, 0}},
        {{0, -1, 0}, {1, 0, 0}},
        {{0, 0, 1}, {1, 0, 0}},
        {{0, 0, -1}, {-1, 0, 0}},
    }};
    Mesh mesh;
    for (const auto& [n, t] : normalAndTangent) {
        addSquare(mesh, n, n, t, 8);
    }
    for (Vertex& vertex : mesh.vertices) {
        vertex.position *= 0.75f;
    }
    return finished(std::move(mesh));
}

/// Returns a right-handed rotation that takes +y to `up` (unit).
glm::mat3 turnedTo(const glm::vec3& up) {
    const glm::vec3 x = glm::normalize(glm::cross(up, glm::vec3(0.0f, 0.0f, 1.0f)));
    return {x, up, glm::cross(x, up)};
}

/// Returns the outline of the ball: a sphere that a plane cuts flat, with a chamfer round the cut,
/// and a round channel parallel to the cut. The axis is the cut's normal.
Profile ballProfile() {
    const double radius = 0.82;
    const double groove = 0.05;
    const double grooveAngle = 1.30; // radians from the cut's normal
    const double halfGroove =
        2.0 * std::asin(0.5 * groove / radius); // radians, half of the channel
    const double cutAngle = 0.46;
    const double chamfer = 0.035;
    const auto onSphere = [&](double angle) {
        return radius * glm::dvec2(std::sin(angle), std::cos(angle));
    };
    const glm::dvec2 cutRim(onSphere(cutAngle).x - chamfer, onSphere(cutAngle).y);
    const double lowLip = grooveAngle + halfGroove;
    const double highLip = grooveAngle - halfGroove;
    // The channel is the part of a small circle about a point of the sphere that lies inside it.
    const double inward = grooveAngle + pi;
    const double reach = 0.5 * pi - 0.5 * halfGroove;
    Span channel = arc(onSphere(grooveAngle), groove, inward - reach, inward + reach, 12);
    for (ProfilePoint& point : channel) {
        point.normal = -point.normal;
    }
    return {arc({0.0, 0.0}, radius, pi, lowLip, 36), channel,
            arc({0.0, 0.0}, radius, highLip, cutAngle + 0.045, 16),
            segment(onSphere(cutAngle + 0.045), cutRim, 2), segment(cutRim, {0.0, cutRim.y}, 2)};
}

/// Returns the outline of the pedestal: a disc with a sharp rim, from which a hollow curve narrows
/// to a neck under the ball.
Profile pedestalProfile() {
    const glm::dvec2 underside(0.0, -1.0);
    const glm::dvec2 foot(0.66, -1.0);
    const glm::dvec2 wall(0.66, -0.93);
    const glm::dvec2 rim(0.64, -0.91);
    const double hollow = 0.30;
    Span curve = arc({0.58, -0.91 + hollow}, hollow, pi, 1.5 * pi, 12);
    for (ProfilePoint& point : curve) {
        point.normal = -point.normal;
    }
    return {segment(underside, foot, 1), segment(foot, wall, 1), segment(wall, rim, 1),
            segment(rim, {0.58, -0.91}, 1), curve};
}

Mesh shaderball() {
    Mesh ball;
    addLathe(ball, ballProfile(), columns);
    const glm::mat3 turn = turnedTo(glm::normalize(glm::vec3(0.42f, 0.82f, 0.32f)));
    for (Vertex& vertex : ball.vertices) {
        vertex.position = turn * vertex.position + glm::vec3(0.0f, 0.14f, 0.0f);
        vertex.normal = turn * vertex.normal;
        vertex.tangent = glm::vec4(turn * glm::vec3(vertex.tangent), vertex.tangent.w);
    }
    addLathe(ball, pedestalProfile(), columns);
    return finished(std::move(ball));
}

using Maker = Mesh (*)();
constexpr std::array<std::pair<std::string_view, Maker>, 9> makers{{
    {"shaderball", shaderball},
    {"sphere", sphere},
    {"torus", torus},
    {"cube", cube},
    {"plane", plane},
    {"cylinder", cylinder},
    {"cone", cone},
    {"brilliant", roundBrilliant},
    {"emeraldcut", emeraldCut},
}};

} // namespace

std::vector<std::string> primitiveNames() {
    std::vector<std::string> names;
    for (const auto& [name, maker] : makers) {
        names.emplace_back(name);
    }
    return names;
}

std::optional<Mesh> primitive(std::string_view name) {
    for (const auto& [known, maker] : makers) {
        if (known == name) {
            return maker();
        }
    }
    return std::nullopt;
}

} // namespace patina
