// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

namespace patina {
namespace {

const glm::dvec3 right(1.0, 0.0, 0.0);
const glm::dvec3 up(0.0, 1.0, 0.0);
const glm::dvec3 back(0.0, 0.0, 1.0);

glm::dmat4 rotated(const glm::dmat4& matrix, double degrees, const glm::dvec3& axis) {
    return glm::rotate(matrix, glm::radians(degrees), axis);
}

/// Returns the rotation from camera space to world space.
glm::dmat4 orbit(const Camera& camera) {
    return rotated(rotated(glm::dmat4(1.0), camera.yaw, up), -camera.pitch, right);
}

} // namespace

glm::dmat4 worldMatrix(const Object& object) {
    glm::dmat4 matrix = glm::translate(glm::dmat4(1.0), object.translation);
    matrix = rotated(matrix, object.rotation.z, back);
    matrix = rotated(matrix, object.rotation.y, up);
    matrix = rotated(matrix, object.rotation.x, right);
    glm::dmat4 slant(1.0);
    slant[1][0] = object.shear.x;
    slant[2][0] = object.shear.y;
    slant[2][1] = object.shear.z;
    return glm::scale(matrix * slant, object.scale);
}

glm::dvec3 eye(const Camera& camera) {
    return camera.pivot + glm::dvec3(orbit(camera) * glm::dvec4(back * camera.distance, 0.0));
}

glm::dmat4 viewMatrix(const Camera& camera) {
    const glm::dmat4 away = glm::translate(glm::dmat4(1.0), -camera.distance * back);
    glm::dmat4 view = rotated(rotated(away, camera.pitch, right), -camera.yaw, up);
    return glm::translate(view, -camera.pivot);
}

} // namespace patina
