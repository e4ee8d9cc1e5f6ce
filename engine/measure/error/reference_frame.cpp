// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/error/reference_frame.h"

#include <algorithm>

#include "measure/error/parallel.h"

namespace patina {
namespace {

/// Is how many pixels are computed at once: some milliseconds of a costly model, beside which
/// starting threads costs little.
constexpr std::size_t pixelsAtOnce = 8192;

} // namespace

Result<std::unique_ptr<ReferenceFrame>> ReferenceFrame::create(SurfaceBuffer buffer,
                                                               const std::vector<bool>& wanted,
                                                               const BufferedScene* around) {
    std::unique_ptr<ReferenceFrame> made(new ReferenceFrame());
    made->codes_.resize(buffer.objects.size());
    for (std::size_t i = 0; i < buffer.objects.size(); ++i) {
        if (!buffer.objects[i].pipeline || i >= wanted.size() || !wanted[i]) {
            continue;
        }
        Result<SurfaceCode> code = SurfaceCode::of(i, buffer, around);
        if (!code) {
            return tl::unexpected(code.error());
        }
        made->codes_[i] = std::make_unique<SurfaceCode>(std::move(*code));
    }
    made->frame_.size = buffer.size;
    made->frame_.colors.resize(buffer.pixels());
    made->frame_.counts.resize(buffer.pixels());
    made->still_.resize(buffer.pixels());
    made->sampled_.resize(buffer.pixels());
    made->passed_.resize(buffer.pixels());
    made->buffer_ = std::move(buffer);
    return made;
}

bool ReferenceFrame::step(std::chrono::milliseconds patience) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (done_ < buffer_.pixels()) {
        const std::size_t first = done_;
        done_ = std::min(first + pixelsAtOnce, buffer_.pixels());
        inParallel(done_ - first, [this, first](std::size_t, std::size_t begin, std::size_t end) {
            compute(first + begin, first + end);
        });
        if (std::chrono::steady_clock::now() >= deadline) {
            break;
        }
    }
    return done_ == buffer_.pixels();
}

void ReferenceFrame::goOn(SurfaceBuffer next) {
    buffer_ = std::move(next);
    done_ = 0;
    ++buffers_;
}

bool ReferenceFrame::isSampled() const {
    return std::ranges::any_of(
        codes_, [](const std::unique_ptr<SurfaceCode>& code) { return code && code->isSampled; });
}

double ReferenceFrame::progress() const {
    return buffer_.pixels() == 0 ? 1.0 : double(done_) / double(buffer_.pixels());
}

void ReferenceFrame::compute(std::size_t first, std::size_t last) {
    std::vector<std::unique_ptr<SurfaceShader>> shaders(codes_.size());
    for (std::size_t pixel = first; pixel < last; ++pixel) {
        const std::optional<std::size_t> object = buffer_.objectAt(pixel);
        if (!object || !codes_[*object]) {
            continue;
        }
        if (!shaders[*object]) {
            shaders[*object] = std::make_unique<SurfaceShader>(*codes_[*object]);
        }
        SurfaceShader& shader = *shaders[*object];
        shader.lookAt(buffer_, pixel);
        if (buffers_ == 0) {
            still_[pixel] = shader.still();
            frame_.counts[pixel] = 1;
        }
        sampled_[pixel] += shader.sampled();
        passed_[pixel] += shader.passed(static_cast<std::uint32_t>(buffers_));
        const double rounds = buffers_ + 1;
        const glm::dvec3 finished = shader.finished(still_[pixel] + sampled_[pixel] / rounds);
        frame_.colors[pixel] = shader.over(passed_[pixel] / rounds, finished);
    }
}

} // namespace patina
