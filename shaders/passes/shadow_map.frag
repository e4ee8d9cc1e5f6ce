// SPDX-License-Identifier: MIT-0
// A depth map holds nothing but depths.

void main() {
}
