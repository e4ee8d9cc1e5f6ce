// SPDX-License-Identifier: MIT-0
// Evaluates many cases in one draw. A case is CASE_TEXELS texels of the data texture, one after the
// other in rows of CASES_WIDTH, and fills RESULT_PIXELS pixels of the target, whose rows have
// RESULT_WIDTH. The program that includes this defines those names and `evaluated`.
uniform sampler2D cases;

layout(location = 0) out vec4 result;

int resultPixel() {
    return int(gl_FragCoord.y) * RESULT_WIDTH + int(gl_FragCoord.x);
}

// Texel i of the case that this pixel belongs to.
vec4 caseData(int i) {
    int texel = resultPixel() / RESULT_PIXELS * CASE_TEXELS + i;
    return texelFetch(cases, ivec2(texel % CASES_WIDTH, texel / CASES_WIDTH), 0);
}

// A function's result as the numbers of result pixel `part`.
vec4 numbersOf(float x, int part) {
    return vec4(x, 0.0, 0.0, 0.0);
}

vec4 numbersOf(vec2 x, int part) {
    return vec4(x, 0.0, 0.0);
}

vec4 numbersOf(vec3 x, int part) {
    return vec4(x, 0.0);
}

// The numbers of result pixel `part` of the case.
vec4 evaluated(int part);

void main() {
    result = evaluated(resultPixel() % RESULT_PIXELS);
}
