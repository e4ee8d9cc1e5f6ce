// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/mesh.h"

namespace patina {

/// Is a point of a mesh's surface on which a mark is drawn, as the GPU reads it: 56 bytes.
struct SurfaceMark {
    Vertex at; ///< is interpolated; the normal is unit
    /// Is how many marks stand on a square metre of the mesh when this one is the last of them.
    float needed = 0.0f;
    /// Is how fast the normal turns along the edge of its triangle where it does so fastest, in
    /// radians for each metre of the mesh: above 0 outwards, below it inwards, 0 where it is flat.
    float bend = 0.0f;
};

/// Sets marks on a mesh, spread evenly by area, each prefix of them too: the mark number n keeps
/// the distance 0.62 sqrt(area / n) from those before it, as long as 48 random places have one that
/// does (dart throwing after R. Cook, ACM TOG 5(1), 1986, with a radius that falls). Those of a
/// sheet's two sides, whose normals are opposed, keep none. The same mesh gives the same marks,
/// however the work is cut into steps. Takes 8 bytes for each triangle and about 150 for each mark.
class SurfaceMarks {
  public:
    /// Are the marks of one mesh at most.
    static constexpr std::size_t maxCount = std::size_t(1) << 17;

    /// The mesh must stay as it is. One without area gets no marks.
    explicit SurfaceMarks(const MeshView& mesh);

    /// Works on about `items` more triangles or random places, until there are `count` marks.
    void proceed(const MeshView& mesh, std::size_t items, std::size_t count);

    /// Returns whether all triangles are measured, so that area() is known.
    bool isMeasured() const { return areas_.size() == triangles_; }
    double area() const { return areas_.empty() ? 0.0 : areas_.back(); } ///< square metres
    std::span<const SurfaceMark> marks() const { return marks_; }

  private:
    using Cell = std::array<std::int32_t, 3>;
    struct CellHash {
        std::size_t operator()(const Cell& cell) const;
    };

    void measure(const MeshView& mesh, std::size_t triangle);
    double nextNumber();
    SurfaceMark randomPlace(const MeshView& mesh);
    Cell cellOf(const glm::vec3& place) const;
    double nearest(const SurfaceMark& place) const;
    void throwDart(const MeshView& mesh);
    void add(const SurfaceMark& mark);
    void enter(std::uint32_t number);
    void refineCells();

    std::size_t triangles_ = 0;
    std::vector<double> areas_; ///< has for each triangle the area of all up to it
    std::vector<SurfaceMark> marks_;
    std::unordered_map<Cell, std::uint32_t, CellHash> cells_; ///< have 1 + the last mark in each
    std::vector<std::uint32_t> before_; ///< has for each mark 1 + the one before it in its cell
    double cellSize_ = 0.0;
    glm::vec3 origin_{0.0f};
    std::uint64_t numbers_ = 0; ///< counts the random numbers drawn
    int misses_ = 0;            ///< counts the places tried for the next mark
    SurfaceMark best_;          ///< is the farthest of these from all marks
    double bestDistance_ = -1.0;
};

} // namespace patina
