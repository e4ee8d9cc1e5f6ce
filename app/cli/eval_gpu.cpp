// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/eval_gpu.h"

#include <algorithm>
#include <map>

#include <epoxy/gl.h>

#include "cli/eval_program.h"
#include "gl/framebuffer.h"
#include "gl/headless_context.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "gl/vertex_array.h"
#include "shading/compile_log.h"
#include "shading/source_builder.h"

namespace patina {
namespace {

/// Cases of one draw; what one drawing takes in memory stays in the tens of megabytes.
constexpr std::size_t largestDraw = 1u << 16;

int rowsFor(std::size_t texels) {
    return static_cast<int>((texels + evalWidth - 1) / evalWidth);
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
    const auto vertex = compiled(GL_VERTEX_SHADER, *vertexSource);
    const auto fragment = compiled(GL_FRAGMENT_SHADER, *fragmentSource);
    if (!vertex || !fragment) {
        return tl::unexpected((vertex ? fragment : vertex).error());
    }
    auto program = gl::Program::link(*vertex, *fragment);
    if (!program) {
        return failure(program.error());
    }
    return std::move(*program);
}

} // namespace

/// The context and the programs that were linked in it.
class EvalGpu::Device {
  public:
    explicit Device(std::unique_ptr<gl::HeadlessContext> context)
        : context_(std::move(context)), vertices_(gl::VertexArray::create()) {}

    /// The answers to cases of one key, or why there are none.
    Result<std::vector<std::vector<double>>> draw(std::span<const EvalCase* const> cases,
                                                  const std::filesystem::path& shaders) {
        const Result<EvalShape> shape = evalShape(*cases.front());
        if (!shape) {
            return tl::unexpected(shape.error());
        }
        const Result<gl::Program*> program = programFor(*cases.front(), *shape, shaders);
        if (!program) {
            return tl::unexpected(program.error());
        }
        (*program)->use();
        std::vector<std::vector<double>> answers;
        while (!cases.empty()) {
            const std::size_t count = std::min(cases.size(), largestDraw);
            if (const auto done = drawPart(cases.first(count), *shape, answers); !done) {
                return tl::unexpected(done.error());
            }
            cases = cases.subspan(count);
        }
        return answers;
    }

  private:
    Result<gl::Program*> programFor(const EvalCase& request, const EvalShape& shape,
                                    const std::filesystem::path& shaders) {
        const std::string key = evalKey(request);
        if (const auto found = programs_.find(key); found != programs_.end()) {
            return &found->second;
        }
        Result<gl::Program> program = linkedProgram(request, shape, shaders);
        if (!program) {
            return tl::unexpected(program.error());
        }
        return &programs_.emplace(key, std::move(*program)).first->second;
    }

    Result<void> drawPart(std::span<const EvalCase* const> cases, const EvalShape& shape,
                          std::vector<std::vector<double>>& answers) {
        const gl::Texture data = dataOf(cases, shape);
        const std::size_t pixels = cases.size() * static_cast<std::size_t>(shape.resultPixels);
        const glm::ivec2 size(evalWidth, rowsFor(pixels));
        const gl::Texture target = gl::Texture::create(size, GL_RGBA32F, GL_RGBA, GL_FLOAT);
        gl::Framebuffer framebuffer = gl::Framebuffer::create();
        framebuffer.attachColor(target);
        if (const auto whole = framebuffer.check(); !whole) {
            return whole;
        }
        glViewport(0, 0, size.x, size.y);
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, data.name());
        vertices_.bind();
        glDrawArrays(GL_TRIANGLES, 0, 3);
        std::vector<float> read(static_cast<std::size_t>(size.x) * size.y * 4);
        glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, read.data());
        for (std::size_t i = 0; i < cases.size(); ++i) {
            answers.push_back(answerAt(read, i, shape));
        }
        return {};
    }

    /// The last row is filled up: every pixel of the target reads a case.
    gl::Texture dataOf(std::span<const EvalCase* const> cases, const EvalShape& shape) {
        const std::size_t pixels = cases.size() * static_cast<std::size_t>(shape.resultPixels);
        const std::size_t drawn = static_cast<std::size_t>(rowsFor(pixels)) * evalWidth;
        const glm::ivec2 size(evalWidth, rowsFor((drawn / shape.resultPixels + 1) *
                                                 static_cast<std::size_t>(shape.caseTexels)));
        std::vector<float> texels;
        texels.reserve(static_cast<std::size_t>(size.x) * size.y * 4);
        for (const EvalCase* request : cases) {
            const std::vector<float> own = evalTexels(*request, shape);
            texels.insert(texels.end(), own.begin(), own.end());
        }
        texels.resize(static_cast<std::size_t>(size.x) * size.y * 4);
        return gl::Texture::create(size, GL_RGBA32F, GL_RGBA, GL_FLOAT, texels.data());
    }

    static std::vector<double> answerAt(const std::vector<float>& read, std::size_t index,
                                        const EvalShape& shape) {
        const auto pixels = static_cast<std::size_t>(shape.resultPixels);
        const std::size_t perPixel = shape.results == 3 * pixels ? 3 : 4;
        std::vector<double> answer;
        for (std::size_t i = 0; i < shape.results; ++i) {
            answer.push_back(read[4 * (index * pixels + i / perPixel) + i % perPixel]);
        }
        return answer;
    }

    std::unique_ptr<gl::HeadlessContext> context_;
    gl::VertexArray vertices_;
    std::map<std::string, gl::Program> programs_;
};

EvalGpu::EvalGpu() = default;
EvalGpu::~EvalGpu() = default;

Result<EvalGpu::Device*> EvalGpu::device() {
    if (device_ == nullptr) {
        auto context = gl::HeadlessContext::create();
        if (!context) {
            return tl::unexpected(context.error());
        }
        device_ = std::make_unique<Device>(std::move(*context));
    }
    return device_.get();
}

std::vector<Result<std::vector<double>>> EvalGpu::evaluate(std::span<const EvalCase> cases,
                                                           const Catalog& catalog) {
    std::map<std::string, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        groups[evalKey(cases[i])].push_back(i);
    }
    std::vector<Result<std::vector<double>>> results(cases.size());
    for (const auto& [key, members] : groups) {
        std::vector<const EvalCase*> group;
        for (const std::size_t i : members) {
            group.push_back(&cases[i]);
        }
        const Result<Device*> ready = device();
        const auto answers = ready ? (*ready)->draw(group, catalog.roots.front().folder)
                                   : tl::unexpected(ready.error());
        for (std::size_t k = 0; k < members.size(); ++k) {
            if (answers) {
                results[members[k]] = (*answers)[k];
            } else {
                results[members[k]] = tl::unexpected(answers.error());
            }
        }
    }
    return results;
}

} // namespace patina
