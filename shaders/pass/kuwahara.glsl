// SPDX-License-Identifier: MIT-0
#include "lib/picture_point.glsl"

// The structure tensor (E, F, G) of the colours by Sobel's differences, a step of the picture's
// scale apart (Kyprianidis et al. 2009, section 3.1).
vec4 kuwaharaPassTensor(PicturePoint at, KuwaharaPass p) {
    float h = max(at.scale, 1.0);
    vec3 corners[4];
    corners[0] = pictureMean(at.pixel + vec2(-h, -h), h);
    corners[1] = pictureMean(at.pixel + vec2(h, -h), h);
    corners[2] = pictureMean(at.pixel + vec2(-h, h), h);
    corners[3] = pictureMean(at.pixel + vec2(h, h), h);
    vec3 across = pictureMean(at.pixel + vec2(h, 0.0), h) - pictureMean(at.pixel - vec2(h, 0.0), h);
    vec3 upward = pictureMean(at.pixel + vec2(0.0, h), h) - pictureMean(at.pixel - vec2(0.0, h), h);
    vec3 dx = 0.25 * (2.0 * across + corners[1] + corners[3] - corners[0] - corners[2]);
    vec3 dy = 0.25 * (2.0 * upward + corners[2] + corners[3] - corners[0] - corners[1]);
    return vec4(dot(dx, dx), dot(dx, dy), dot(dy, dy), 0.0);
}

// The mean of the last stage along a line, weighted by a bell curve that ends at 2.5 deviations.
vec4 kuwaharaMean(PicturePoint at, vec2 direction, float deviation) {
    int reach = 7;
    float apart = 2.5 * deviation * at.scale / float(reach);
    vec4 sum = vec4(0.0);
    float weights = 0.0;
    for (int i = -reach; i <= reach; ++i) {
        float x = 2.5 * float(i) / float(reach);
        float weight = exp(-0.5 * x * x);
        sum += weight * stageValue(at.pixel + (float(i) * apart) * direction);
        weights += weight;
    }
    return sum * (1.0 / weights);
}

vec4 kuwaharaPassAcross(PicturePoint at, KuwaharaPass p) {
    return kuwaharaMean(at, vec2(1.0, 0.0), p.smoothing);
}

vec4 kuwaharaPassSmoothed(PicturePoint at, KuwaharaPass p) {
    return kuwaharaMean(at, vec2(0.0, 1.0), p.smoothing);
}

// Where the picture has no direction a stroke has one of its own, which changes slowly.
vec4 kuwaharaWander(PicturePoint at, vec4 tensor) {
    vec2 u = (at.pixel - 0.5 * at.size) * (1.0 / (90.0 * at.scale));
    int octaves = 2;
    float angle = 3.0 * pictureTurbulence(u, octaves);
    vec2 d = 0.003 * vec2(cos(angle), sin(angle));
    return tensor + vec4(d.x * d.x, d.x * d.y, d.y * d.y, 0.0);
}

// What bristles leave in the paint, about -1 .. 1: noise that is smeared along the stroke.
float kuwaharaBristles(PicturePoint at, vec2 along, float size) {
    int reach = 8;
    vec2 u = (at.pixel - 0.5 * at.size) * (1.0 / (max(size, 0.1) * at.scale));
    float sum = 0.0;
    for (int i = -reach; i <= reach; ++i) {
        sum += pictureNoise(u + (0.8 * float(i)) * along) - 0.5;
    }
    return sum * 0.5;
}

// The unit direction in which the picture changes least, and how much longer a stroke is there than
// a round one: 1 where the picture has no direction (section 3.2).
vec3 kuwaharaAxis(vec4 tensor, float stretch) {
    float difference = tensor.x - tensor.z;
    float root = sqrt(difference * difference + 4.0 * tensor.y * tensor.y);
    float sum = tensor.x + tensor.z;
    float anisotropy = sum > 1e-6 ? min(root / sum, 1.0) : 0.0;
    float greatest = 0.5 * (sum + root);
    vec2 along = vec2(greatest - tensor.x, -tensor.y); // each may be 0
    vec2 other = vec2(-tensor.y, greatest - tensor.z);
    along = dot(along, along) > dot(other, other) ? along : other;
    float size = sqrt(dot(along, along));
    vec2 unit = size > 1e-8 ? along * (1.0 / size) : vec2(1.0, 0.0);
    return vec3(unit.x, unit.y, 1.0 + stretch * anisotropy);
}

// The share of a place of the unit disk in the sector about +x: a polynomial that is 0 beyond 67.5
// degrees (Kyprianidis et al. 2010, eq. 9).
float kuwaharaShare(float x, float y) {
    float overlap = 0.33;
    float bend = 0.838; // (overlap + cos 67.5) / sin^2 67.5
    float share = max(x + overlap - bend * y * y, 0.0);
    return share * share;
}

int kuwaharaReach(KuwaharaPass p) {
    int coarse = 4;
    int normal = 6;
    int fine = 10;
    if (p.samples == KUWAHARA_PASS_SAMPLES_COARSE) {
        return coarse;
    }
    return p.samples == KUWAHARA_PASS_SAMPLES_FINE ? fine : normal;
}

// Weights of sectors fall with the power `sharpness` of how much they vary (eq. 14).
vec3 kuwaharaPass(PicturePoint at, KuwaharaPass p) {
    int sectors = p.sectors == KUWAHARA_PASS_SECTORS_FOUR ? 4 : 8;
    int reach = kuwaharaReach(p);
    vec3 axis = kuwaharaAxis(kuwaharaWander(at, stageValue(at.pixel)), p.stretch);
    float radius = p.radius * at.scale;
    vec2 along = vec2(axis.x, axis.y) * (radius * axis.z);
    vec2 across = vec2(-axis.y, axis.x) * (radius / axis.z);
    float apart = radius / float(reach); // of two places, where strokes are round
    vec4 means[8];
    float squares[8];
    for (int k = 0; k < sectors; ++k) {
        means[k] = vec4(0.0);
        squares[k] = 0.0;
    }
    float half45 = 0.70710678;
    for (int j = -reach; j <= reach; ++j) {
        for (int i = -reach; i <= reach; ++i) {
            float x = float(i) / (float(reach) + 0.25);
            float y = float(j) / (float(reach) + 0.25);
            float away = x * x + y * y;
            if (away <= 1.0) {
                vec3 color = pictureMean(at.pixel + x * along + y * across, apart);
                float bell = exp(-0.78 * away);
                float s = half45 * (x + y);
                float t = half45 * (y - x);
                float shares[8];
                shares[0] = kuwaharaShare(x, y);
                shares[1] = kuwaharaShare(y, x);
                shares[2] = kuwaharaShare(-x, y);
                shares[3] = kuwaharaShare(-y, x);
                shares[4] = kuwaharaShare(s, t);
                shares[5] = kuwaharaShare(t, s);
                shares[6] = kuwaharaShare(-s, t);
                shares[7] = kuwaharaShare(-t, s);
                float square = dot(color, color);
                float sum = 0.0;
                for (int k = 0; k < sectors; ++k) {
                    sum += shares[k];
                }
                for (int k = 0; k < sectors; ++k) {
                    float weight = bell * shares[k] / max(sum, 1e-6);
                    means[k] += vec4(color * weight, weight);
                    squares[k] += square * weight;
                }
            }
        }
    }
    float deviations[8];
    float least = 1e30;
    for (int k = 0; k < sectors; ++k) {
        float one = 1.0 / max(means[k].w, 1e-6);
        means[k] = means[k] * one;
        vec3 mean = vec3(means[k].x, means[k].y, means[k].z);
        deviations[k] = 1.0 + 255.0 * sqrt(max(squares[k] * one - dot(mean, mean), 0.0));
        least = min(least, deviations[k]);
    }
    vec3 total = vec3(0.0);
    float weights = 0.0; // the most even sector has 1
    for (int k = 0; k < sectors; ++k) {
        float weight = pow(least / deviations[k], p.sharpness);
        total += weight * vec3(means[k].x, means[k].y, means[k].z);
        weights += weight;
    }
    float wet = p.bristles * min(p.radius, 1.0); // without a brush there are no bristles
    float paint = wet * kuwaharaBristles(at, vec2(axis.x, axis.y), p.bristleWidth);
    vec3 mean = total * (1.0 / weights);
    return max(mean * (1.0 + paint), vec3(0.0));
}
