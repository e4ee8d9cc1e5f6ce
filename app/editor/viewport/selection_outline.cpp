// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/selection_outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include <QPainter>

#include <glm/geometric.hpp>

#include "viewport/ray_cast.h"

namespace patina {
namespace {

/// Limits the triangles of all objects together; more of them get boxes instead of outlines.
constexpr std::size_t maxTriangles = 300000;
constexpr int lineWidth = 2;    ///< pixels
constexpr int maxObjects = 250; ///< objects that a byte of the mask can tell apart
const QColor lineColor(255, 170, 40);

/// Fills triangles into a mask of one byte per pixel.
class MaskFiller {
  public:
    MaskFiller(std::vector<unsigned char>& mask, const QSize& size)
        : mask_(mask), width_(size.width()), height_(size.height()) {}

    void fill(const std::array<glm::dvec2, 3>& corners, unsigned char value) {
        const auto [low, high] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
        const int first = static_cast<int>(std::clamp(std::floor(low), 0.0, double(height_)));
        const int last = static_cast<int>(std::clamp(std::ceil(high), 0.0, double(height_)));
        for (int y = first; y < last; ++y) {
            fillRow(corners, y, value);
        }
    }

  private:
    /// Fills all pixels that the triangle touches in a row, so that thin ones leave no holes.
    void fillRow(const std::array<glm::dvec2, 3>& corners, int y, unsigned char value) {
        double left = width_;
        double right = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec2 a = corners[i];
            const glm::dvec2 b = corners[(i + 1) % 3];
            const double lower = std::max(std::min(a.y, b.y), double(y));
            const double upper = std::min(std::max(a.y, b.y), y + 1.0);
            if (lower > upper) {
                continue;
            }
            for (const double at : {lower, upper}) {
                const double share = a.y == b.y ? 0.0 : (at - a.y) / (b.y - a.y);
                const double x = a.x + share * (b.x - a.x);
                left = std::min({left, x, a.y == b.y ? b.x : x});
                right = std::max({right, x, a.y == b.y ? b.x : x});
            }
        }
        const int begin = static_cast<int>(std::clamp(std::floor(left), 0.0, double(width_)));
        const int end = static_cast<int>(std::clamp(std::ceil(right), 0.0, double(width_)));
        if (begin < end) {
            const auto row = mask_.begin() + std::ptrdiff_t(y) * width_;
            std::fill(row + begin, row + end, value);
        }
    }

    std::vector<unsigned char>& mask_;
    int width_;
    int height_;
};

void fillMesh(MaskFiller& filler, const MeshView& mesh, const glm::dmat4& world,
              const Camera& camera, const QSize& size, unsigned char value) {
    const glm::dmat4 toCamera = viewMatrix(camera) * world;
    const double scale =
        pixelsPerMetre(camera, eye(camera) - glm::dvec3(glm::inverse(viewMatrix(camera))[2]),
                       size.height()); // at a depth of one metre
    const glm::dvec2 middle(0.5 * size.width(), 0.5 * size.height());
    std::vector<glm::dvec3> seen(mesh.vertices.size());
    std::ranges::transform(mesh.vertices, seen.begin(), [&](const Vertex& vertex) {
        const glm::dvec3 place(toCamera * glm::dvec4(vertex.position, 1.0));
        return glm::dvec3(middle + glm::dvec2(place.x, -place.y) * (scale / -place.z), place.z);
    });
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::dvec3& a = seen[mesh.indices[i]];
        const glm::dvec3& b = seen[mesh.indices[i + 1]];
        const glm::dvec3& c = seen[mesh.indices[i + 2]];
        if (a.z < 0.0 && b.z < 0.0 && c.z < 0.0) {
            filler.fill({glm::dvec2(a), glm::dvec2(b), glm::dvec2(c)}, value);
        }
    }
}

/// Tells whether a pixel lies at the edge of what its object covers.
bool isAtEdge(const std::vector<unsigned char>& mask, const QSize& size, int x, int y) {
    const unsigned char own = mask[static_cast<std::size_t>(y * size.width() + x)];
    for (int dy = -lineWidth; dy <= lineWidth; ++dy) {
        for (int dx = -lineWidth; dx <= lineWidth; ++dx) {
            const int nx = x + dx;
            const int ny = y + dy;
            const bool isInside = nx >= 0 && ny >= 0 && nx < size.width() && ny < size.height();
            if (isInside && dx * dx + dy * dy <= lineWidth * lineWidth &&
                mask[static_cast<std::size_t>(ny * size.width() + nx)] > own) {
                return true;
            }
        }
    }
    return false;
}

/// Returns the first and the last pixel of each row that some object covers; the first is greater
/// where none does.
std::vector<std::pair<int, int>> coveredSpans(const std::vector<unsigned char>& mask,
                                              const QSize& size) {
    std::vector<std::pair<int, int>> spans;
    for (int y = 0; y < size.height(); ++y) {
        const auto row = mask.begin() + std::ptrdiff_t(y) * size.width();
        const auto end = row + size.width();
        const auto isCovered = [](unsigned char value) { return value != 0; };
        const auto first = std::find_if(row, end, isCovered);
        const auto last =
            std::find_if(std::reverse_iterator(end), std::reverse_iterator(row), isCovered);
        spans.emplace_back(static_cast<int>(first - row), static_cast<int>(last.base() - row) - 1);
    }
    return spans;
}

/// Draws lines along the edges in the mask, but none on pixels that the last of `count` objects
/// covers.
void drawEdges(QImage& image, const std::vector<unsigned char>& mask, std::size_t count) {
    const QSize size = image.size();
    const std::vector<std::pair<int, int>> spans = coveredSpans(mask, size);
    for (int y = 0; y < size.height(); ++y) {
        int first = size.width();
        int last = -1;
        for (int near = std::max(y - lineWidth, 0);
             near <= std::min(y + lineWidth, size.height() - 1); ++near) {
            first = std::min(first, spans[static_cast<std::size_t>(near)].first - lineWidth);
            last = std::max(last, spans[static_cast<std::size_t>(near)].second + lineWidth);
        }
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width());
        for (int x = std::max(first, 0); x <= std::min(last, size.width() - 1); ++x) {
            const bool isInside = mask[row + static_cast<std::size_t>(x)] == count;
            if (!isInside && isAtEdge(mask, size, x, y)) {
                line[x] = lineColor.rgba();
            }
        }
    }
}

void drawBox(QPainter& painter, const Bounds& box, const glm::dmat4& world, const Camera& camera,
             const glm::dvec2& size) {
    const auto placeAt = [&](int corner) {
        const glm::dvec4 local((corner & 1) != 0 ? box.upper.x : box.lower.x,
                               (corner & 2) != 0 ? box.upper.y : box.lower.y,
                               (corner & 4) != 0 ? box.upper.z : box.lower.z, 1.0);
        return placeOf(camera, glm::dvec3(world * local), size);
    };
    for (int corner = 0; corner < 8; ++corner) {
        for (const int axis : {1, 2, 4}) {
            const auto from = placeAt(corner);
            const auto to = placeAt(corner | axis);
            if ((corner & axis) == 0 && from && to) {
                painter.drawLine(QPointF(from->x, from->y), QPointF(to->x, to->y));
            }
        }
    }
}

} // namespace

const QImage& SelectionOutline::draw(const Scene& scene, const std::vector<int>& objects,
                                     const Camera& camera, const QSize& size,
                                     const Meshes& meshes) {
    std::vector<Shown> wanted;
    std::vector<MeshView> views;
    std::size_t triangles = 0;
    for (const int index : objects) {
        const Object& object = scene.objects[static_cast<std::size_t>(index)];
        const MeshView view = object.visible ? meshes(object) : MeshView();
        wanted.push_back({worldMatrix(object), view.vertices.data(), view.indices.size() / 3});
        views.push_back(view);
        triangles += wanted.back().triangles;
    }
    if (wanted == shown_ && camera == camera_ && size == image_.size()) {
        return image_;
    }
    shown_ = std::move(wanted);
    camera_ = camera;
    image_ = QImage(size, QImage::Format_ARGB32_Premultiplied);
    image_.fill(Qt::transparent);
    const bool isTraced = triangles <= maxTriangles && shown_.size() <= maxObjects;
    if (isTraced) {
        mask_.assign(static_cast<std::size_t>(size.width()) * size.height(), 0);
        MaskFiller filler(mask_, size);
        for (std::size_t i = 0; i < shown_.size(); ++i) {
            fillMesh(filler, views[i], shown_[i].world, camera, size,
                     static_cast<unsigned char>(i + 1));
        }
        drawEdges(image_, mask_, shown_.size());
        return image_;
    }
    QPainter painter(&image_);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(lineColor, lineWidth));
    for (std::size_t i = 0; i < shown_.size(); ++i) {
        if (shown_[i].triangles > 0) {
            drawBox(painter, views[i].bounds, shown_[i].world, camera,
                    {size.width(), size.height()});
        }
    }
    return image_;
}

} // namespace patina
