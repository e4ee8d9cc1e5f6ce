// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/eval/eval_program.h"

#include <epoxy/gl.h>

#include "gl/framebuffer.h"
#include "gl/texture.h"
#include "material/measured_preset.h"
#include "shading/glsl/compile_log.h"
#include "shading/program/block_gate.h"
#include "shading/program/source_builder.h"

namespace patina {
namespace {

constexpr unsigned tableUnit = 1; ///< holds the table of a measured file; unit 0 has the cases

int rowsFor(std::size_t texels) {
    return static_cast<int>((texels + evalWidth - 1) / evalWidth);
}

std::size_t area(glm::ivec2 size) {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}

Error asError(const Errors& errors) {
    return errors.empty() ? Error{{}, 0, 0, "the driver refused the program", {}} : errors.front();
}

tl::expected<gl::Shader, Error> compiled(unsigned stage, const ShaderSource& source) {
    auto shader = gl::Shader::compile(stage, source.text);
    if (!shader) {
        return tl::unexpected(asError(compileErrors(shader.error(), source)));
    }
    return std::move(*shader);
}

Result<gl::Program> linkedProgram(const EvalCase& request, const EvalShape& shape,
                                  const std::filesystem::path& shaders) {
    SourceBuilder triangle(shaders);
    triangle.add("#version 410 core\n");
    triangle.addFile("passes/evaluate_triangle.glsl");
    const Checked<ShaderSource> vertexSource = triangle.finish();
    const Checked<ShaderSource> fragmentSource = evalSource(request, shape, shaders);
    if (!vertexSource || !fragmentSource) {
        return tl::unexpected(asError((vertexSource ? fragmentSource : vertexSource).error()));
    }
    if (const auto answer = gateAnswer(fragmentSource->strangers); !answer.mistakes.empty()) {
        return tl::unexpected(answer.mistakes.front());
    }
    const auto vertex = compiled(GL_VERTEX_SHADER, *vertexSource);
    const auto fragment = compiled(GL_FRAGMENT_SHADER, *fragmentSource);
    if (!vertex || !fragment) {
        return tl::unexpected((vertex ? fragment : vertex).error());
    }
    auto program = gl::Program::link(*vertex, *fragment);
    if (!program) {
        return failure(program.error());
    }
    program->bindSampler("measuredTable", tableUnit);
    return std::move(*program);
}

/// Returns the results of each case, without the unused numbers of its pixels.
std::vector<float> wanted(const std::vector<float>& pixels, std::size_t count,
                          const EvalShape& shape) {
    const auto pixelsPerCase = static_cast<std::size_t>(shape.resultPixels);
    const std::size_t perPixel = shape.results == 3 * pixelsPerCase ? 3 : 4;
    std::vector<float> results;
    results.reserve(count * shape.results);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < shape.results; ++k) {
            results.push_back(pixels[4 * (i * pixelsPerCase + k / perPixel) + k % perPixel]);
        }
    }
    return results;
}

} // namespace

EvalProgram::EvalProgram(gl::Program program, const EvalShape& shape)
    : program_(std::move(program)), shape_(shape), vertices_(gl::VertexArray::create()) {}

void EvalProgram::bindMeasured(MeasuredStore& store, const EvalCase& request) {
    const Block* block = request.block.block;
    if (block != nullptr && tableParameter(*block) != nullptr) {
        store.bind(measuredTableOf(*block, request.block.values), tableUnit);
    }
}

Result<EvalProgram> EvalProgram::link(const EvalCase& request,
                                      const std::filesystem::path& shaders) {
    const Result<EvalShape> shape = evalShape(request);
    if (!shape) {
        return tl::unexpected(shape.error());
    }
    Result<gl::Program> program = linkedProgram(request, *shape, shaders);
    if (!program) {
        return tl::unexpected(program.error());
    }
    return EvalProgram(std::move(*program), *shape);
}

// The data also fill the target's last row, since every pixel of the target reads a case.
Result<std::vector<float>> EvalProgram::draw(std::vector<float> texels, std::size_t count) const {
    const auto pixelsPerCase = static_cast<std::size_t>(shape_.resultPixels);
    const glm::ivec2 size(evalWidth, rowsFor(count * pixelsPerCase));
    const std::size_t drawn = area(size) / pixelsPerCase + 1;
    const glm::ivec2 dataSize(evalWidth,
                              rowsFor(drawn * static_cast<std::size_t>(shape_.caseTexels)));
    texels.resize(area(dataSize) * 4);
    const gl::Texture data =
        gl::Texture::create(dataSize, GL_RGBA32F, GL_RGBA, GL_FLOAT, texels.data());
    const gl::Texture target = gl::Texture::create(size, GL_RGBA32F, GL_RGBA, GL_FLOAT);
    gl::Framebuffer framebuffer = gl::Framebuffer::create();
    framebuffer.attachColor(target);
    if (const auto whole = framebuffer.check(); !whole) {
        return tl::unexpected(whole.error());
    }
    program_.use();
    glViewport(0, 0, size.x, size.y);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, data.name());
    vertices_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<float> pixels(area(size) * 4);
    glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, pixels.data());
    return wanted(pixels, count, shape_);
}

} // namespace patina
