// SPDX-License-Identifier: GPL-3.0-or-later
// How a frame's cost grows with objects and lights, and what many objects cost beside one mesh.

#include <glm/matrix.hpp>

#include "benchmarks.h"
#include "material/block_values.h"
#include "stage.h"
#include "statistics.h"

namespace patina::benchmarks {
namespace {

constexpr int side = 100; // of the square of objects
constexpr int objects = side * side;
constexpr int materials = 12;
constexpr int rounds = 9;
constexpr double minStraightness = 0.98;

/// Small things side by side, none before another, so that each costs as many pixels as the next.
Object placed(const Object& like, int i) {
    Object object = like;
    const glm::dvec2 cell(i % side, i / side);
    object.translation = glm::dvec3((cell + 0.5) / double(side) * 2.2 - 1.1, 0.0);
    object.rotation = glm::dvec3(7.0, 11.0, 13.0) * double(i);
    object.scale = glm::dvec3(0.45 * 2.2 / side);
    const double shade = double(i % materials) / materials;
    object.material.model.parameters["diffuse.color"] = glm::dvec3(shade, 0.5, 1.0 - shade);
    return object;
}

Scene squareOf(const Stage& stage, int count, const std::string& mesh) {
    Scene scene = stage.scene;
    scene.camera.yaw = 0.0;
    scene.camera.pitch = 0.0;
    Object like = scene.objects.front();
    like.mesh = mesh;
    like.fitUnitBox = false;
    scene.objects.clear();
    for (int i = 0; i < count; ++i) {
        scene.objects.push_back(placed(like, i));
    }
    return scene;
}

/// Twelve triangles: as good as nothing to draw, so that what is done for each object shows.
Mesh box() {
    Mesh mesh;
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2;
        const float sign = face % 2 == 0 ? 1.0f : -1.0f;
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const glm::vec2 corner : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
            Vertex vertex;
            vertex.position[axis] = sign;
            vertex.position[(axis + 1) % 3] = corner.x;
            vertex.position[(axis + 2) % 3] = sign * corner.y;
            vertex.normal = glm::vec3(0.0f);
            vertex.normal[axis] = sign;
            mesh.vertices.push_back(vertex);
        }
        for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) {
            mesh.indices.push_back(first + corner);
        }
    }
    mesh.bounds = boundsOf(mesh.vertices);
    return mesh;
}

/// All objects of a scene as one mesh.
Mesh joined(const Scene& scene, const Mesh& mesh) {
    Mesh all;
    for (const Object& object : scene.objects) {
        const glm::dmat4 world = worldMatrix(object);
        const glm::dmat3 turn = glm::dmat3(world) / object.scale.x;
        const auto first = static_cast<std::uint32_t>(all.vertices.size());
        for (Vertex vertex : mesh.vertices) {
            vertex.position = glm::vec3(world * glm::dvec4(glm::dvec3(vertex.position), 1.0));
            vertex.normal = glm::vec3(turn * glm::dvec3(vertex.normal));
            vertex.tangent = glm::vec4(turn * glm::dvec3(vertex.tangent), vertex.tangent.w);
            all.vertices.push_back(vertex);
        }
        for (const std::uint32_t index : mesh.indices) {
            all.indices.push_back(first + index);
        }
    }
    all.bounds = boundsOf(all.vertices);
    return all;
}

/// Medians of frames of each scene in turn.
std::vector<Spread> timed(Stage& stage, const std::vector<Scene>& scenes) {
    std::vector<std::vector<double>> seconds(scenes.size());
    for (int round = -1; round < rounds; ++round) { // the first one makes programs and memory
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            const double taken = stage.frameSeconds(scenes[i]);
            if (round >= 0) {
                seconds[i].push_back(taken);
            }
        }
    }
    std::vector<Spread> spreads;
    for (const std::vector<double>& each : seconds) {
        spreads.push_back(spreadOf(each));
    }
    return spreads;
}

bool isStraight(Stage& stage, const std::string& what, const std::vector<double>& counts,
                const std::vector<Scene>& scenes) {
    const std::vector<Spread> spreads = timed(stage, scenes);
    std::vector<double> medians;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        report(fmt::format("Frame of {} {}", counts[i], what), text(spreads[i], 1e3, "ms"), true,
               "");
        medians.push_back(spreads[i].median);
    }
    const double determination = straightness(counts, medians);
    const bool kept = determination > minStraightness;
    report(fmt::format("Frame time over {}: R^2", what), fmt::format("{:.4f}", determination),
           kept, "> 0.98");
    return kept;
}

bool growsWithObjects(Stage& stage) {
    const std::vector<double> counts{1000, 2500, 4000, 5500, 7000, 8500, 10000};
    std::vector<Scene> scenes;
    for (const double count : counts) {
        scenes.push_back(squareOf(stage, int(count), "box"));
    }
    return isStraight(stage, "objects", counts, scenes);
}

bool growsWithLights(Stage& stage) {
    const std::vector<double> counts{4, 8, 16, 24, 32, 48, 64};
    std::vector<Scene> scenes;
    const Block& block = *stage.catalog().find("lights", "point");
    for (const double count : counts) {
        Scene scene = stage.scene;
        scene.lights.clear();
        for (int i = 0; i < int(count); ++i) {
            Light& light = scene.lights.emplace_back();
            light.block = defaultBlockValues(block);
            light.block.parameters["position"] = glm::dvec3(3.0, 2.0 + 0.1 * i, 3.0 - 0.1 * i);
        }
        scenes.push_back(std::move(scene));
    }
    return isStraight(stage, "lights", counts, scenes);
}

bool costsLittleBesideOneMesh(Stage& stage, const std::string& mesh) {
    const Scene apart = squareOf(stage, objects, mesh);
    Scene together = apart;
    stage.meshes["joined"] = joined(apart, stage.meshes.at(mesh));
    together.objects = {stage.scene.objects.front()};
    Object& whole = together.objects.front();
    whole.mesh = "joined";
    whole.translation = glm::dvec3(0.0);
    whole.rotation = glm::dvec3(0.0);
    whole.scale = glm::dvec3(1.0);
    std::vector<double> ratios;
    std::vector<double> ofObjects;
    std::vector<double> ofOne;
    for (int round = -1; round < rounds; ++round) {
        const double many = stage.frameSeconds(apart);
        const double one = stage.frameSeconds(together);
        if (round >= 0) {
            ofObjects.push_back(many);
            ofOne.push_back(one);
            ratios.push_back(many / one);
        }
    }
    const FrameReport& frame = stage.draw(apart);
    const Spread ratio = spreadOf(ratios);
    const auto triangles = stage.meshes.at(mesh).indices.size() / 3;
    const std::string what = fmt::format("{} of {} triangles", objects, triangles);
    report(what, fmt::format("{}; {} calls", text(spreadOf(ofObjects), 1e3, "ms"), frame.drawCalls),
           true, "");
    report("The same triangles in one mesh", text(spreadOf(ofOne), 1e3, "ms"), true, "");
    report(what + " / one mesh", text(ratio, 1.0, ""), ratio.median <= 1.3, "<= 1.3");
    stage.meshes.erase("joined");
    return ratio.median <= 1.3;
}

} // namespace

bool manyObjects() {
    Stage stage({800, 600});
    stage.use("phong");
    stage.meshes["cube"] = primitive("cube").value();
    stage.meshes["box"] = box();
    bool kept = growsWithObjects(stage);
    kept = growsWithLights(stage) && kept;
    kept = costsLittleBesideOneMesh(stage, "cube") && kept;
    kept = costsLittleBesideOneMesh(stage, "box") && kept;
    return kept;
}

} // namespace patina::benchmarks
