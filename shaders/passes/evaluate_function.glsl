// SPDX-License-Identifier: MIT-0
// A function of the library. Texels: its arguments, four to a texel. The program defines
// FUNCTION_CALL, which reads ARGUMENT(i) and writes RESULT(i, x).
#define ARGUMENT(i) caseData((i) / 4)[(i) % 4]
#define RESULT(i, x) numbers[i] = x

vec4 evaluated(int part) {
    float numbers[4 * RESULT_PIXELS];
    for (int i = 0; i < 4 * RESULT_PIXELS; ++i) {
        numbers[i] = 0.0;
    }
    FUNCTION_CALL
    return vec4(numbers[4 * part], numbers[4 * part + 1], numbers[4 * part + 2],
        numbers[4 * part + 3]);
}
