// SPDX-License-Identifier: MIT-0
// The environment behind the objects. Each round of samples looks a little beside the pixel's
// middle, over the whole pixel and over the disc of the blur, and the rounds are averaged.

// The camera's forward, rightward and upward directions, the latter two as long as half the image
// at the distance 1.
uniform vec3 backgroundForward;
uniform vec3 backgroundRight;
uniform vec3 backgroundUp;
uniform vec2 backgroundSize; // of the image that is drawn, in pixels

layout(location = 0) out vec4 storedColor;

vec3 lookedAlong(vec2 pixel) {
    vec2 place = 2.0 * pixel / backgroundSize - 1.0;
    return normalize(backgroundForward + place.x * backgroundRight + place.y * backgroundUp);
}

void main() {
    Environment p = unpackEnvironment(2);
    uint first = uint(environmentData[0].z);
    int count = int(environmentData[0].w);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < count; ++i) {
        vec2 u = environmentPoint(first + uint(i), environmentSeed(7u));
        vec3 d = lookedAlong(floor(gl_FragCoord.xy) + u);
        sum += backgroundRadiance(d, first + uint(i), p);
    }
    storedColor = vec4(environmentLimited(sum / float(count)), 1.0);
}
