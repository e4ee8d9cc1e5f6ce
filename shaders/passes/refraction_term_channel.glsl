// SPDX-License-Identifier: MIT-0
// Each channel has a ray of its own, which sees what the term has for it.

vec3 termSeenBy(Interface c) {
    return vec3(equal(ivec3(0, 1, 2), ivec3(c.channel)));
}
