// SPDX-License-Identifier: GPL-3.0-or-later
#include "minimal_program.h"

#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "catalog/unit_direction.h"
#include "gl/shader.h"
#include "render/gpu/binding.h"
#include "shading/program/source_builder.h"
#include "support/program.h"

namespace patina::benchmarks {
namespace {

const std::filesystem::path folder =
    std::filesystem::path(PATINA_SOURCE_DIR) / "tests" / "benchmarks" / "minimal";

[[noreturn]] void fail(const std::string& name, const std::string& why) {
    fmt::print(stderr, "minimal {}: {}\n", name, why);
    std::exit(2);
}

using Uniforms = std::map<std::string, std::vector<float>>;

std::vector<float> numbersOf(const glm::dvec3& vector) {
    return {float(vector.x), float(vector.y), float(vector.z)};
}

std::vector<float> numbersOf(const Parameter& parameter, const Value& value) {
    if (const auto* number = std::get_if<double>(&value)) {
        const bool isAngle = parameter.type == ParameterType::Angle;
        return {static_cast<float>(isAngle ? glm::radians(*number) : *number)};
    }
    if (const auto* vector = std::get_if<glm::dvec3>(&value)) {
        return numbersOf(isDirection(parameter) ? unitDirection(*vector) : *vector);
    }
    return {};
}

/// "light0Direction" for the parameter "direction" behind "light0".
std::string nameBehind(const std::string& prefix, const std::string& id) {
    std::string name = fieldName(id);
    if (!prefix.empty()) {
        name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
    }
    return prefix + name;
}

void add(Uniforms& uniforms, const std::string& prefix, const Block& block, const Values& values) {
    for (const Parameter& parameter : block.parameters) {
        const auto given = values.find(parameter.id);
        const Value& value = given == values.end() ? parameter.defaultValue : given->second;
        uniforms[nameBehind(prefix, parameter.id)] = numbersOf(parameter, value);
    }
}

/// The rows that take (u, v, 1) to a place in the image: turned about the middle, scaled, moved.
void add(Uniforms& uniforms, const TextureUse& use) {
    const double angle = glm::radians(use.rotation);
    const glm::dvec2 across = use.scale.x * glm::dvec2(std::cos(angle), std::sin(angle));
    const glm::dvec2 up = use.scale.y * glm::dvec2(-std::sin(angle), std::cos(angle));
    const glm::dvec2 start =
        0.5 * use.scale + use.offset - 0.5 * glm::dvec2(across.x + across.y, up.x + up.y);
    uniforms["imageAcross"] = numbersOf(glm::dvec3(across, start.x));
    uniforms["imageUp"] = numbersOf(glm::dvec3(up, start.y));
    uniforms["imageStrength"] = {float(use.strength)};
    uniforms["imageThreshold"] = {float(use.threshold)};
}

/// Returns a row of the matrix that takes (x, 1) into the map.
std::vector<float> rowOf(const ShadowView& view, const glm::dvec3& axis, double shift) {
    return {float(axis.x), float(axis.y), float(axis.z),
            float(shift - glm::dot(axis, view.origin))};
}

void add(Uniforms& uniforms, const ShadowView& view) {
    const double span = view.far - view.near;
    uniforms["shadowAcross"] = rowOf(view, view.window.x * view.right, view.window.z);
    uniforms["shadowUp"] = rowOf(view, view.window.y * view.up, view.window.w);
    uniforms["shadowDepth"] = rowOf(view, view.forward / span, -view.near / span);
    uniforms["shadowTexel"] = {float(view.texel)};
}

Uniforms uniformsOf(const Catalog& catalog, const Scene& scene) {
    Uniforms uniforms;
    const Material& material = scene.objects.front().material;
    const Block& model = *catalog.find("models", material.model.id);
    add(uniforms, {}, model, material.model.parameters);
    for (const Slot& slot : model.slots) {
        if (const Block* filler = catalog.find(slot.kind, slot.defaultBlock)) {
            add(uniforms, slot.kind, *filler, {});
        }
    }
    for (const auto& [kind, part] : material.parts) {
        add(uniforms, kind, *catalog.find(kind, part.id), part.parameters);
    }
    for (const auto& [key, use] : material.textures) {
        add(uniforms, use);
    }
    uniforms["opacity"] = {float(material.opacity)};
    uniforms["skyColor"] = numbersOf(scene.hemisphere.sky);
    uniforms["groundColor"] = numbersOf(scene.hemisphere.ground);
    uniforms["skyUp"] = numbersOf(scene.hemisphere.up);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const BlockValues& light = scene.lights[i].block;
        add(uniforms, fmt::format("light{}", i), *catalog.find("lights", light.id),
            light.parameters);
    }
    if (scene.part(kinds::fog)) {
        add(uniforms, "fog", *catalog.find("fog", scene.part(kinds::fog)->id),
            scene.part(kinds::fog)->parameters);
    }
    return uniforms;
}

void set(int location, const std::vector<float>& numbers) {
    const auto send = numbers.size() == 1   ? glUniform1fv
                      : numbers.size() == 3 ? glUniform3fv
                                            : glUniform4fv;
    send(location, 1, numbers.data());
}

bool readsImage(const std::string& surrounding) {
    return surrounding == "image" || surrounding == "relief" || surrounding == "cutout";
}

} // namespace

MinimalProgram::MinimalProgram(const Catalog& catalog, const std::string& model,
                               const std::string& surrounding, const Scene& scene,
                               const BallStage& stage)
    : name_(model + ", " + surrounding) {
    SourceBuilder builder(catalog.roots.front().folder);
    builder.add("#version 410 core\n#define OUT(T) out T\n");
    builder.addFile(folder / "surface.glsl");
    if (readsImage(surrounding)) {
        builder.addFile(folder / "place.glsl");
    }
    builder.add(surrounding == "image" ? "vec3 imagedColor;\n#define DIFFUSE_COLOR imagedColor\n"
                                       : "#define DIFFUSE_COLOR diffuseColor\n");
    builder.addFile(folder / (model + ".glsl"));
    builder.addFile(folder / (surrounding + ".frag"));
    const auto source = builder.finish();
    if (!source) {
        fail(name_, text(source.error()));
    }
    const std::string vertexFile = surrounding == "relief"   ? "relief.vert"
                                   : readsImage(surrounding) ? "image.vert"
                                                             : "ball.vert";
    const auto vertex = gl::Shader::compile(GL_VERTEX_SHADER, tests::readFile(folder / vertexFile));
    const auto fragment = gl::Shader::compile(GL_FRAGMENT_SHADER, source->text);
    if (!vertex || !fragment) {
        fail(name_, vertex ? fragment.error() : vertex.error());
    }
    auto linked = gl::Program::link(*vertex, *fragment);
    if (!linked) {
        fail(name_, linked.error());
    }
    program_ = std::move(*linked);
    setUniforms(catalog, scene, stage);
}

void MinimalProgram::setUniforms(const Catalog& catalog, const Scene& scene,
                                 const BallStage& stage) {
    program_->use();
    Uniforms values = uniformsOf(catalog, scene);
    const glm::dvec3 from = eye(stage.camera());
    values["eye"] = numbersOf(from);
    add(values, stage.pictures().shadowView(catalog, scene.lights.front(),
                                            glm::inverse(viewMatrix(stage.camera()))));
    int count = 0;
    glGetProgramiv(program_->name(), GL_ACTIVE_UNIFORMS, &count);
    for (int i = 0; i < count; ++i) {
        std::array<char, 64> name{};
        int size = 0;
        GLenum type = 0;
        glGetActiveUniform(program_->name(), GLuint(i), GLsizei(name.size()), nullptr, &size, &type,
                           name.data());
        const int location = program_->uniform(name.data());
        const auto found = values.find(name.data());
        if (type == GL_FLOAT_MAT4) {
            const bool isCamera = std::string_view(name.data()) == "worldToClip";
            const glm::mat4 matrix = isCamera ? stage.worldToClip() : BallStage::objectToWorld;
            glUniformMatrix4fv(location, 1, GL_FALSE, glm::value_ptr(matrix));
        } else if (type == GL_FLOAT_MAT3) {
            const glm::mat3 matrix(glm::inverseTranspose(BallStage::objectToWorld));
            glUniformMatrix3fv(location, 1, GL_FALSE, glm::value_ptr(matrix));
        } else if (type == GL_SAMPLER_2D) {
            glUniform1i(location, binding::firstTexture);
        } else if (type == GL_SAMPLER_2D_ARRAY) {
            glUniform1i(location, binding::shadowMaps);
        } else if (found == values.end() || found->second.empty()) {
            fail(name_, fmt::format("the scene has no \"{}\"", name.data()));
        } else {
            set(location, found->second);
        }
    }
}

} // namespace patina::benchmarks
