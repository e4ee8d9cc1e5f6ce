// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>

#include "render/gpu/gpu_mesh.h"

namespace patina {

/// Remembers how much is drawn of many objects of one mesh. It cuts them into slices of whole
/// objects, or of one object's triangles where there are many.
class DrawSlices {
  public:
    /// Returns the next slice and counts it as drawn. It has about `maxTriangles` triangles, at
    /// least one. The `count` objects have `triangles` each and begin at `first` in an
    /// InstanceBuffer.
    DrawRange next(int triangles, std::size_t first, std::size_t count, std::int64_t maxTriangles) {
        DrawRange range{triangle_, triangles - triangle_, first + instance_, 1};
        if (maxTriangles < range.triangles) {
            range.triangles = static_cast<int>(std::max<std::int64_t>(maxTriangles, 1));
        } else if (triangle_ == 0) {
            const auto whole = static_cast<std::size_t>(maxTriangles / std::max(triangles, 1));
            range.instances = std::clamp<std::size_t>(whole, 1, count - instance_);
        }
        triangle_ += range.triangles;
        if (triangle_ == triangles) {
            triangle_ = 0;
            instance_ += range.instances;
        }
        return range;
    }

    /// Returns true when nothing is drawn yet.
    bool isAtStart() const { return instance_ == 0 && triangle_ == 0; }

    /// Returns true when all `count` objects are drawn.
    bool isDone(std::size_t count) const { return instance_ == count; }

  private:
    std::size_t instance_ = 0;
    int triangle_ = 0;
};

} // namespace patina
