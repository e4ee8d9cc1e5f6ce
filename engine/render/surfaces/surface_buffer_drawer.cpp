// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/surfaces/surface_buffer_drawer.h"

#include <algorithm>
#include <array>

#include <epoxy/gl.h>

#include "gl/framebuffer.h"
#include "shading/effects/surface_buffer_layout.h"

namespace patina {
namespace {

constexpr int outputs = SurfaceBufferLayout::outputs;
constexpr int sharesPerValue = 4;

/// Owns the images that the programs write to.
class BufferTarget {
  public:
    static Result<BufferTarget> create(glm::ivec2 size) {
        BufferTarget target;
        target.size_ = size;
        target.depth_ = gl::Renderbuffer::create(size, GL_DEPTH_COMPONENT32F);
        target.framebuffer_ = gl::Framebuffer::create();
        target.framebuffer_.attachDepth(target.depth_);
        std::array<GLenum, outputs> all{};
        for (int i = 0; i < outputs; ++i) {
            gl::Texture& color = target.colors_[std::size_t(i)];
            color = gl::Texture::create(size, GL_RGBA32F, GL_RGBA, GL_FLOAT);
            all[std::size_t(i)] = gl::colorAttachment(std::size_t(i));
            glFramebufferTexture2D(GL_FRAMEBUFFER, gl::colorAttachment(std::size_t(i)),
                                   GL_TEXTURE_2D, color.name(), 0);
        }
        glDrawBuffers(outputs, all.data());
        if (auto drawable = target.framebuffer_.check(); !drawable) {
            return tl::unexpected(drawable.error());
        }
        return target;
    }

    void begin() const {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
        glViewport(0, 0, size_.x, size_.y);
        glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
        glDepthMask(GL_TRUE);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    }

    /// Returns the pixels of one output, rows from the top.
    std::vector<glm::vec4> read(int output) const {
        const auto columns = static_cast<std::size_t>(size_.x);
        const auto rows = static_cast<std::size_t>(size_.y);
        std::vector<glm::vec4> pixels(columns * rows);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name());
        glReadBuffer(gl::colorAttachment(std::size_t(output)));
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_FLOAT, pixels.data());
        for (std::size_t top = 0; top < rows / 2; ++top) {
            const auto first = pixels.begin() + std::ptrdiff_t(top * columns);
            const auto last = pixels.begin() + std::ptrdiff_t((rows - 1 - top) * columns);
            std::swap_ranges(first, first + std::ptrdiff_t(columns), last);
        }
        return pixels;
    }

  private:
    glm::ivec2 size_{0};
    std::array<gl::Texture, outputs> colors_;
    gl::Renderbuffer depth_;
    gl::Framebuffer framebuffer_;
};

/// Returns how many values a pixel of the object has.
std::size_t valuesOf(const BufferedObject& object, std::size_t lights) {
    return object.firstShare + (lights + sharesPerValue - 1) / sharesPerValue;
}

/// Counts the lights with shadows, from the headers that packScene() wrote.
std::size_t shadowedLights(const SurfaceBuffer& buffer, const Pipeline& pipeline) {
    std::size_t count = 0;
    for (const LightPlace& group : pipeline.scene.groups) {
        const float lights = buffer.sceneData[static_cast<std::size_t>(group.light.first)].x;
        count += group.shadow ? static_cast<std::size_t>(lights) : 0;
    }
    return count;
}

std::size_t maxValues(const SurfaceBuffer& buffer) {
    std::size_t maxCount = 0;
    for (const BufferedObject& object : buffer.objects) {
        if (object.pipeline) {
            maxCount =
                std::max(maxCount, valuesOf(object, shadowedLights(buffer, *object.pipeline)));
        }
    }
    return maxCount;
}

} // namespace

SurfaceBufferDrawer::SurfaceBufferDrawer(RenderResources& shared)
    : shared_(shared), items_(shared, SurfaceOutput::Buffer) {}

void SurfaceBufferDrawer::followCatalog() {
    if (catalog_ == shared_.catalog) {
        return;
    }
    catalog_ = shared_.catalog;
    items_.setCatalog(catalog_);
    environment_.forget();
}

Result<SurfaceBuffer> SurfaceBufferDrawer::capture(const Scene& scene, const View& view,
                                                   const MeshSource& meshes, int round) {
    followCatalog();
    if (!catalog_) {
        return failure("there are no shaders to draw with", "a call of setCatalog before draw");
    }
    items_.prepare(scene, view, meshes, true);
    if (!items_.report().messages.empty()) {
        return tl::unexpected(items_.report().messages.front());
    }
    environment_.follow({scene, scene, view.environmentImage, shared_.environments}, *catalog_,
                        items_.pipelines().programs());
    if (environment_.isIn()) {
        environment_.setSamples({round, SurfaceBufferLayout::samples, view.environmentSeries});
    }
    const Result<BufferTarget> target = BufferTarget::create(view.size);
    if (!target) {
        return tl::unexpected(target.error());
    }
    SurfaceBuffer buffer;
    buffer.size = view.size;
    buffer.eye = glm::vec3(eye(view.camera));
    describe(buffer, scene);
    const std::size_t maxCount = maxValues(buffer);
    for (std::size_t first = 0; first == 0 || first < maxCount;
         first += SurfaceBufferLayout::window) {
        target->begin();
        drawWindow(scene, static_cast<int>(first));
        for (std::size_t i = first;
             i < std::min<std::size_t>(first + SurfaceBufferLayout::window, maxCount); ++i) {
            buffer.values.push_back(
                target->read(static_cast<int>(i - first) + outputs - SurfaceBufferLayout::window));
        }
    }
    buffer.positions = target->read(0);
    buffer.normals = target->read(1);
    buffer.tangents = target->read(2);
    items_.end();
    glBindVertexArray(0);
    glUseProgram(0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return buffer;
}

void SurfaceBufferDrawer::describe(SurfaceBuffer& buffer, const Scene& scene) {
    const std::span<const glm::vec4> sceneData = items_.sceneData();
    buffer.sceneData.assign(sceneData.begin(), sceneData.end());
    buffer.objects.resize(scene.objects.size());
    for (const SurfaceItems::Item& item : items_.items()) {
        if (!item.pipeline) {
            continue;
        }
        BufferedObject& object = buffer.objects[item.index];
        object.pipeline = item.pipeline;
        const std::span<const glm::vec4> data = item.data->staging();
        object.data.assign(data.begin(), data.begin() + item.pipeline->object.vec4s);
        object.inputs = texturedInputs(item.pipeline->effects);
        object.firstSample = object.inputs.size();
        object.firstShare = firstShare(item.pipeline->effects);
    }
}

void SurfaceBufferDrawer::drawWindow(const Scene& scene, int firstValue) {
    if (environment_.isIn()) {
        environment_.bind();
    }
    items_.draw(scene, [firstValue](const SurfaceItems::Item& item) {
        glUniform1i(item.pipeline->program->uniform("firstValue"), firstValue);
        glUniform1f(item.pipeline->program->uniform("objectNumber"),
                    static_cast<float>(item.index + 1));
    });
}

} // namespace patina
