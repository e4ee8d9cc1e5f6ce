// SPDX-License-Identifier: MIT-0
// What is meant by images whose numbers are square roots.

float imageSquare(float root) {
    return root * root;
}

vec3 imageSquare(vec3 root) {
    return root * root;
}
