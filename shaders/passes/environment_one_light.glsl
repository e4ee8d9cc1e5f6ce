// SPDX-License-Identifier: MIT-0
// The light of a whole environment as one light, for models that want one.
#include "passes/environment_mean.glsl"

vec3 oneLight(Surface s, Model p) {
    return lit(s, meanLight(), p);
}
