// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/half_timing.h"

#include <algorithm>
#include <array>
#include <utility>

#include <epoxy/gl.h>

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "gl/vertex_array.h"
#include "measure/approximation/half_text.h"
#include "measure/approximation/shader_price.h"
#include "measure/time/frame_timer.h"

namespace patina {
namespace {

constexpr int side = 1024; ///< pixels
constexpr int timedPairs = 41;
constexpr double fewMilliseconds = 4.0; ///< are what one timed draw takes at least
constexpr int maxCopies = 4096;

/// Are the dialects that drivers of OpenGL may have, the most useful first.
constexpr std::array<HalfDialect, 4> dialects{
    {{"GL_EXT_shader_explicit_arithmetic_types_float16", true},
     {"GL_AMD_gpu_shader_half_float", true},
     {"GL_NV_gpu_shader5", true},
     {"GL_NV_gpu_shader5", false}}};

tl::expected<gl::Program, std::string> linked(const ProgramText& text) {
    const auto vertex = gl::Shader::compile(GL_VERTEX_SHADER, text.vertex);
    if (!vertex) {
        return tl::unexpected(vertex.error());
    }
    const auto fragment = gl::Shader::compile(GL_FRAGMENT_SHADER, text.fragment);
    return fragment ? gl::Program::link(*vertex, *fragment) : tl::unexpected(fragment.error());
}

std::vector<float> paddedToVec4(std::vector<float> numbers) {
    numbers.resize(std::max<std::size_t>((numbers.size() + 3) / 4, 1) * 4);
    return numbers;
}

void setUniforms(const gl::Program& program, const EvalCase& subject) {
    program.use();
    const auto set = [&program](const char* name, const std::vector<float>& numbers) {
        glUniform4fv(program.uniform(name), int(numbers.size() / 4), numbers.data());
    };
    set("casePlaces", paddedToVec4(placeTexels(subject)));
    set("caseValues", paddedToVec4(valueTexels(subject)));
}

/// Draws into an image of 8 bits, whose memory costs little beside what is computed.
class TimedDraws {
  public:
    TimedDraws()
        : color_(gl::Texture::create({side, side}, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE)),
          target_(gl::Framebuffer::create()), vertices_(gl::VertexArray::create()) {
        target_.attachColor(color_);
    }

    /// Chooses how often a program is drawn, so that a timer can tell.
    void findCopies(const gl::Program& program) {
        timeOf(program);
        while (copies_ < maxCopies && timeOf(program) < fewMilliseconds) {
            copies_ *= 2;
        }
    }

    /// Returns the milliseconds of all copies.
    double timeOf(const gl::Program& program) {
        glViewport(0, 0, side, side);
        vertices_.bind();
        program.use();
        timer_.begin();
        glDrawArraysInstanced(GL_TRIANGLES, 0, 3, copies_);
        timer_.end();
        glFinish();
        timer_.collect();
        return timer_.milliseconds();
    }

    std::string method() const { return std::string(timer_.methodText()); }

  private:
    gl::Texture color_;
    gl::Framebuffer target_;
    gl::VertexArray vertices_;
    FrameTimer timer_;
    int copies_ = 1;
};

HalfTiming timedBoth(const gl::Program& exact, const gl::Program& half) {
    TimedDraws draws;
    draws.findCopies(exact);
    draws.timeOf(half);
    std::vector<double> ratios;
    std::vector<double> times;
    std::vector<double> halfTimes;
    for (int i = 0; i < timedPairs; ++i) {
        const bool isExactFirst = i % 2 == 0;
        const double first = draws.timeOf(isExactFirst ? exact : half);
        const double second = draws.timeOf(isExactFirst ? half : exact);
        times.push_back(isExactFirst ? first : second);
        halfTimes.push_back(isExactFirst ? second : first);
        ratios.push_back(halfTimes.back() / times.back());
    }
    HalfTiming timing;
    timing.ratio = medianInterval(std::move(ratios));
    timing.milliseconds = medianInterval(std::move(times));
    timing.halfMilliseconds = medianInterval(std::move(halfTimes)).median;
    timing.pairs = timedPairs;
    timing.method = draws.method();
    return timing;
}

} // namespace

Result<HalfTiming> halfTiming(const EvalCase& subject, const HalfReport& report,
                              const std::vector<std::size_t>& lines) {
    const ShaderPrice programs(subject, report.text->source(), report.text->syntax(),
                               gpuFamilies().front());
    const auto exact = linked(programs.programOf({}));
    if (!exact) {
        return failure("the block does not compile here: " + exact.error());
    }
    setUniforms(*exact, subject);
    std::string refusals;
    for (const HalfDialect& dialect : dialects) {
        const auto half =
            linked(programs.programOf(halfEdits(*report.text, report.halvedBy(lines), dialect)));
        if (!half) {
            refusals += (refusals.empty() ? " " : "; ") + std::string(dialect.extension) + ": " +
                        half.error().substr(0, half.error().find('\n'));
            continue;
        }
        setUniforms(*half, subject);
        HalfTiming timing = timedBoth(*exact, *half);
        timing.extension = dialect.extension;
        timing.hasFunctions = dialect.hasFunctions;
        return timing;
    }
    return failure("this graphics device has no floats of 16 bits:" + refusals);
}

} // namespace patina
