// SPDX-License-Identifier: MIT-0

// A half float ends at 65504; what is not a number is not light.
float storable(float x) {
    return x > 0.0 ? min(x, 65504.0) : 0.0;
}
