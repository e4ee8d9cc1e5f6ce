// SPDX-License-Identifier: MIT-0
// One face of the environment, more out of focus than the level that is read: the mean over a lobe
// of von Mises' and Fisher's form.
#include "lib/directions.glsl"
#include "passes/cube_face.glsl"

uniform samplerCube environmentBlurred; // the finer level alone
uniform float addedKappa;               // of the lobe

layout(location = 0) out vec4 storedRadiance;

const int SIDE = 7;
const float REACH = 2.6; // standard deviations

void main() {
    vec3 d = faceDirection(gl_FragCoord.xy);
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
        sum += weight * textureLod(environmentBlurred,
            cos(angle) * d + towards.x * t + towards.y * b, 0.0).rgb;
        weights += weight;
    }
    storedRadiance = vec4(sum / weights, 1.0);
}
