// SPDX-License-Identifier: MIT-0
// A surface with an opacity map keeps light away where at least half of it is there.

const float MIN_SHADOWING = 0.5;
