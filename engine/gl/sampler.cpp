// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/sampler.h"

#include <algorithm>

#include <epoxy/gl.h>

#include "gl/driver.h"

namespace patina::gl {
namespace {

constexpr float maxAnisotropy = 8.0f;

/// Returns the degree of anisotropic filtering, 1 .. maxAnisotropy. It is 1 for a driver that draws
/// on the CPU, where filtering would take several times as long.
float anisotropy() {
    if (!epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic") || isSoftware()) {
        return 1.0f;
    }
    GLfloat deviceMax = 1.0f;
    glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &deviceMax);
    return std::min(deviceMax, maxAnisotropy);
}

} // namespace

void deleteSampler(unsigned name) {
    glDeleteSamplers(1, &name);
}

Sampler Sampler::create(unsigned wrap, bool isSmooth) {
    Sampler sampler;
    GLuint name = 0;
    glGenSamplers(1, &name);
    sampler.name_ = Name<deleteSampler>(name);
    glSamplerParameteri(name, GL_TEXTURE_WRAP_S, static_cast<GLint>(wrap));
    glSamplerParameteri(name, GL_TEXTURE_WRAP_T, static_cast<GLint>(wrap));
    glSamplerParameteri(name, GL_TEXTURE_MIN_FILTER,
                        isSmooth ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_NEAREST);
    glSamplerParameteri(name, GL_TEXTURE_MAG_FILTER, isSmooth ? GL_LINEAR : GL_NEAREST);
    if (const float deviceMax = anisotropy(); isSmooth && deviceMax > 1.0f) {
        glSamplerParameterf(name, GL_TEXTURE_MAX_ANISOTROPY_EXT, deviceMax);
    }
    return sampler;
}

void Sampler::bind(unsigned unit) const {
    glBindSampler(unit, name_.get());
}

} // namespace patina::gl
