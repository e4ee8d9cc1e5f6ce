// SPDX-License-Identifier: MIT-0
// A level of the environment's octahedral picture, from the level before it: the mean over a lobe of
// von Mises' and Fisher's form.
#include "lib/directions.glsl"
#include "passes/octahedral_levels.glsl"

uniform sampler2D environmentBlurred; // all levels
uniform float finerShare;             // of the level that is read, see octahedralLevel()
uniform float addedKappa;             // of the lobe

layout(location = 0) out vec4 storedRadiance;

const int SIDE = 5;
const float REACH = 2.3; // standard deviations

void main() {
    float texels = 0.5 * finerShare * OCTAHEDRAL_WIDTH;
    vec3 d = octahedralDirection((gl_FragCoord.xy - 1.0) / (texels - 2.0));
    vec3 t = anyTangent(d);
    vec3 b = cross(d, t);
    float deviation = inversesqrt(addedKappa);
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int i = 0; i < SIDE * SIDE; ++i) {
        vec2 p = (2.0 * vec2(float(i % SIDE), float(i / SIDE)) / float(SIDE - 1) - 1.0) * REACH;
        // Azimuthal: as far on the sphere as on the plane, whose areas are larger then.
        float angle = min(length(p) * deviation, PI);
        float sine = sin(angle);
        vec2 towards = angle > 0.0 ? p * (sine / length(p)) : vec2(0.0);
        float half_ = sin(0.5 * angle);
        float area = angle > 0.0 ? sine / angle : 1.0;
        float weight = area * exp(-2.0 * addedKappa * half_ * half_);
        vec2 place = octahedralPlace(cos(angle) * d + towards.x * t + towards.y * b);
        vec2 at = octahedralLevel(place, octahedralOrigin(finerShare), finerShare);
        sum += weight * texture(environmentBlurred, at * vec2(2.0 / 3.0, 1.0)).rgb;
        weights += weight;
    }
    storedRadiance = vec4(sum / weights, 1.0);
}
