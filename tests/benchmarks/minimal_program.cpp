// SPDX-License-Identifier: GPL-3.0-or-later
#include "minimal_program.h"

#include <array>
#include <cctype>
#include <cstdlib>

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>

#include "gl/shader.h"
#include "shading/source_builder.h"
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

std::vector<float> numbersOf(const Parameter& parameter, const Value& value) {
    if (const auto* number = std::get_if<double>(&value)) {
        const bool isAngle = parameter.type == ParameterType::Angle;
        return {static_cast<float>(isAngle ? glm::radians(*number) : *number)};
    }
    if (const auto* vector = std::get_if<glm::dvec3>(&value)) {
        return {float(vector->x), float(vector->y), float(vector->z)};
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
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const BlockValues& light = scene.lights[i].block;
        add(uniforms, fmt::format("light{}", i), *catalog.find("lights", light.id),
            light.parameters);
    }
    if (scene.fog) {
        add(uniforms, "fog", *catalog.find("fog", scene.fog->id), scene.fog->parameters);
    }
    return uniforms;
}

void set(int location, const std::vector<float>& numbers) {
    numbers.size() == 1 ? glUniform1fv(location, 1, numbers.data())
                        : glUniform3fv(location, 1, numbers.data());
}

} // namespace

MinimalProgram::MinimalProgram(const Catalog& catalog, const std::string& model,
                               const std::string& surrounding, const Scene& scene,
                               const BallStage& stage)
    : name_(model + ", " + surrounding) {
    SourceBuilder builder(catalog.roots.front().folder);
    builder.add("#version 410 core\n#define OUT(T) out T\n");
    builder.addFile(folder / "surface.glsl");
    builder.addFile(folder / (model + ".glsl"));
    builder.addFile(folder / (surrounding + ".frag"));
    const auto source = builder.finish();
    if (!source) {
        fail(name_, text(source.error()));
    }
    const auto vertex =
        gl::Shader::compile(GL_VERTEX_SHADER, tests::readFile(folder / "ball.vert"));
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
    values["eye"] = {float(from.x), float(from.y), float(from.z)};
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
            const glm::mat4 worldToClip(stage.worldToClip());
            glUniformMatrix4fv(location, 1, GL_FALSE, glm::value_ptr(worldToClip));
        } else if (found == values.end() || found->second.empty()) {
            fail(name_, fmt::format("the scene has no \"{}\"", name.data()));
        } else {
            set(location, found->second);
        }
    }
}

} // namespace patina::benchmarks
