// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/polygon_tessellator.h"

#include <cstddef>
#include <deque>
#include <memory>

#include <GL/glu.h>

#include "io/thin_triangles.h"

namespace patina {
namespace {

/// Collects what GLU's callbacks report. GLU knows points by the addresses of their numbers.
struct Work {
    Polygon& polygon;
    std::deque<std::uint32_t> numbers; ///< is a deque, because the addresses must stay valid
    Tessellation made;
    bool failed = false;

    std::uint32_t* nextNumber() {
        return &numbers.emplace_back(static_cast<std::uint32_t>(numbers.size()));
    }
};

void takeCorner(void* number, void* work) {
    static_cast<Work*>(work)->made.triangles.push_back(*static_cast<std::uint32_t*>(number));
}

/// Does nothing, but makes GLU produce single triangles, neither strips nor fans.
void takeEdgeFlag(GLboolean, void*) {}

/// Merges two points at one place into the first of them; where outlines cross, it makes a new
/// point.
void takeCrossing(GLdouble place[3], void* points[4], GLfloat shares[4], void** result,
                  void* data) {
    auto& work = *static_cast<Work*>(data);
    if (points[2] == nullptr) {
        *result = points[0];
        return;
    }
    CrossingPoint crossing;
    for (std::size_t i = 0; i < crossing.points.size() && points[i] != nullptr; ++i) {
        crossing.points[i] = *static_cast<std::uint32_t*>(points[i]);
        crossing.shares[i] = shares[i];
    }
    work.made.crossings.push_back(crossing);
    work.polygon.add({place[0], place[1], place[2]});
    *result = work.nextNumber();
}

void takeError(GLenum, void* work) {
    static_cast<Work*>(work)->failed = true;
}

struct Delete {
    void operator()(GLUtesselator* tessellator) const { gluDeleteTess(tessellator); }
};

template <class Function>
void setCall(GLUtesselator* tessellator, GLenum which, Function* function) {
    gluTessCallback(tessellator, which, reinterpret_cast<_GLUfuncptr>(function));
}

void run(GLUtesselator* tessellator, Work& work) {
    setCall(tessellator, GLU_TESS_VERTEX_DATA, takeCorner);
    setCall(tessellator, GLU_TESS_EDGE_FLAG_DATA, takeEdgeFlag);
    setCall(tessellator, GLU_TESS_COMBINE_DATA, takeCrossing);
    setCall(tessellator, GLU_TESS_ERROR_DATA, takeError);
    gluTessProperty(tessellator, GLU_TESS_WINDING_RULE, GLU_TESS_WINDING_NONZERO);
    const glm::dvec3 normal = work.polygon.normal();
    gluTessNormal(tessellator, normal.x, normal.y, normal.z);
    gluTessBeginPolygon(tessellator, &work);
    gluTessBeginContour(tessellator);
    for (std::size_t i = 0, corners = work.polygon.size(); i < corners; ++i) {
        const glm::dvec3& point = work.polygon.point(i);
        GLdouble place[3] = {point.x, point.y, point.z};
        gluTessVertex(tessellator, place, work.nextNumber());
    }
    gluTessEndContour(tessellator);
    gluTessEndPolygon(tessellator);
}

} // namespace

std::optional<Tessellation> tessellate(Polygon& polygon) {
    const std::unique_ptr<GLUtesselator, Delete> tessellator(gluNewTess());
    if (tessellator == nullptr || polygon.normal() == glm::dvec3(0.0)) {
        return std::nullopt;
    }
    Work work{polygon, {}, {}};
    run(tessellator.get(), work);
    if (work.failed || work.made.triangles.empty() || work.made.triangles.size() % 3 != 0) {
        return std::nullopt;
    }
    turnThinTriangles(polygon, work.made.triangles);
    return std::move(work.made);
}

} // namespace patina
