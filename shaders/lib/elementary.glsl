// SPDX-License-Identifier: MIT-0
// Elementary functions with a bounded error in float. GLSL's own pow, acos and asin may lose half
// their digits or more near 1, which is where a highlight is. These are the only terms that are
// written twice: in double precision each is its exact twin over the C++ library, and a test holds
// both to the error stated here. The coefficients are minimax fits on the stated interval.

// atanh(z) / z from w = z^2, 0 <= w <= 1/9; relative error 5e-9.
float atanhOverZ(float w) {
    return 1.000000004 + w * (0.3333316082 + w * (0.2001229762
        + w * (0.1398257887 + w * 0.1407888918)));
}

// cos(theta)^e from s2 : c2 = sin^2 : cos^2 on any common scale, e >= 0; 0 where c2 is not positive
// (also for e = 0: a lobe ends at the horizon). 1e-37 keeps a flushed subnormal out of log2. Uses
// ln cos = -atanh(s2 / (s2 + 2 c2)), which does not lose the small angle; relative error 2e-6 +
// 2e-7 e L where L = -ln cos(theta).
float powSC(float s2, float c2, float e) {
    if (!(c2 > 0.0)) {
        return 0.0;
    }
    float z = s2 / (s2 + 2.0 * c2);
    float L = -0.34657359027997265 * log2(max(c2 / (s2 + c2), 1e-37));
    if (z < 1.0 / 3.0) {
        L = z * atanhOverZ(z * z);
    }
    return exp2(-1.4426950408889634 * e * L);
}

// c^e where the caller knows d = 1 - c without cancellation, c <= 1, e >= 0; 0 where c is not
// positive. Uses ln c = -2 atanh(d / (1 + c)); relative error 2e-6 + 2e-7 e L where L = -ln c.
float pow1m(float d, float c, float e) {
    if (!(c > 0.0)) {
        return 0.0;
    }
    float z = d / (1.0 + c);
    float L = -0.69314718055994531 * log2(max(c, 1e-37));
    if (z < 1.0 / 3.0) {
        L = 2.0 * z * atanhOverZ(z * z);
    }
    return exp2(-1.4426950408889634 * e * L);
}

// -ln cos(theta) / s2 from s2 : c2 = sin^2 : cos^2 on any common scale, c2 > 0; at s2 = 0 the limit
// 1 / (2 c2). Relative error 3e-7.
float minusLnCosBySin2(float s2, float c2) {
    float sum = s2 + 2.0 * c2;
    float z = s2 / sum;
    if (z < 1.0 / 3.0) {
        return atanhOverZ(z * z) / sum;
    }
    return -0.34657359027997265 * log2(max(c2 / (s2 + c2), 1e-37)) / s2;
}

// c^e like pow1m, but c may be above 1 and d below 0; never above 2^100, so that a
// float still holds what is made of it.
float powNear1(float d, float c, float e) {
    if (!(c > 0.0)) {
        return 0.0;
    }
    float z = d / (1.0 + c);
    float L = -0.69314718055994531 * log2(max(c, 1e-37));
    if (abs(z) < 1.0 / 3.0) {
        L = 2.0 * z * atanhOverZ(z * z);
    }
    return exp2(min(-1.4426950408889634 * e * L, 100.0));
}

// acos(1 - x / 2)^2, 0 <= x <= 2: the square of an angle is analytic in its versine, the angle is
// not; relative error 3e-7.
float acos2(float x) {
    return x * (0.9999999669 + x * (0.08333544658 + x * (0.0110893108 + x * (0.001869977294
        + x * (0.0001610606938 + x * (0.0002123322145 + x * (-6.492908552e-5
        + x * 1.950334767e-5)))))));
}

// asin(z), |z| <= sqrt(1/2); relative error 2e-8.
float asinS(float z) {
    float w = z * z;
    return z * (0.9999999855 + w * (0.166670202 + w * (0.07485976127 + w * (0.04674141616
        + w * (0.015223688 + w * (0.08000865722 + w * (-0.09664398391 + w * 0.1134496994)))))));
}

// The angle 0 .. pi/2 with the sine s and the cosine c, s^2 + c^2 = 1, both >= 0; made from the
// smaller of the two, relative error 2e-8.
float angleOf(float s, float c) {
    float a = asinS(min(s, c));
    return s < c ? a : 1.57079632679489662 - a;
}

// 1 - cos(a), 0 <= a <= pi, with every digit of a small angle; relative error 4e-7.
float versineOf(float a) {
    float w = a * a;
    return w * (0.4999999954247251 + w * (-0.04166663326988191 + w * (0.0013888492914353897
        + w * (-2.47843616236833e-5 + w * (2.7216673352592613e-7
        + w * -1.7729953116727984e-9)))));
}

// The integral of erfc from a to infinity, e^(-a^2)/sqrt(pi) - a erfc(a), a >= 0; the error is
// below 4e-8 (2 a + ierfc(a)), the sum in which Smith's masking has it.
float ierfc(float a) {
    float x = min(a, 10.0); // 0 in float from a = 9 on
    return 0.5641896 * exp2(-x * (2.557115786 + x * (0.8233961439 + x * (0.1211867362
        + x * (-0.01207291036 + x * (-0.001165413965 + x * 0.0003953996219))))));
}

// The integral of e^(-theta^2 / w) sin(2 theta) over 0 .. pi/2, divided by w, 0 < w <= 1.45: how
// much of its small-angle limit 1 a Gaussian in the angle keeps on the hemisphere; relative error
// 2e-7. The polynomials are Dawson's integral and what of it lies past the horizon.
float gaussianShare(float w) {
    float whole = 0.9999999965 + w * (-0.6666663858 + w * (0.26666284 + w * (-0.07617019917
        + w * (0.01687745022 + w * (-0.002999301924 + w * (0.0004070031202
        + w * -3.18943214e-5))))));
    float past = 0.2024444596 + w * (-0.1221637617 + w * (0.04057687598
        + w * (-0.0084342209 + w * 0.000876537178)));
    return whole + exp2(-3.5597071 / w) * w * past;
}

// The highlight of a round ridge: the integral over psi = arc.x .. arc.y of
//   cos^e sin(view.x + view.y psi) sin(light.x + light.y psi),
// cos being that of the ridge's normal at psi with the half vector, which lies at the angle h.x and
// has the shares h.y along and h.z across the ridge, on any common scale. e >= 0. By 16
// Gauss-Legendre points from where the lobe is largest on the arc to where it has fallen by e^-15,
// as at 5.5 deviations, or the distance R^2 / (sqrt(d^2 + R^2) + d) beyond the distance d from its
// middle. The error is below 2e-6 of the integral of the lobe alone over all angles; where only its
// slope lies on the arc, below 1e-5 + 3e-7 e L of the integral itself, L = -ln cos at its start.
float ridgeLobe(vec2 arc, vec3 h, float e, vec2 view, vec2 light) {
    float largest = max(arc.x, min(h.x, arc.y));
    float off = abs(largest - h.x);
    float reach2 = 30.25 / (e + 1.0);
    float reach = reach2 / (sqrt(off * off + reach2) + off);
    float from = max(arc.x, largest - reach);
    float to = min(arc.y, largest + reach);
    if (!(to > from)) {
        return 0.0;
    }
    float nodes[8];
    float weights[8];
    nodes[0] = 0.09501250983763745;
    nodes[1] = 0.2816035507792589;
    nodes[2] = 0.4580167776572274;
    nodes[3] = 0.6178762444026438;
    nodes[4] = 0.755404408355003;
    nodes[5] = 0.8656312023878318;
    nodes[6] = 0.9445750230732326;
    nodes[7] = 0.9894009349916499;
    weights[0] = 0.1894506104550686;
    weights[1] = 0.1826034150449236;
    weights[2] = 0.1691565193950026;
    weights[3] = 0.1495959888165768;
    weights[4] = 0.124628971255534;
    weights[5] = 0.09515851168249259;
    weights[6] = 0.06225352393864771;
    weights[7] = 0.02715245941175404;
    float sum = 0.0;
    for (int i = 0; i < 8; ++i) {
        for (int side = -1; side < 2; side += 2) {
            float psi = 0.5 * (from + to + float(side) * nodes[i] * (to - from));
            float s = sin(psi - h.x);
            float c = cos(psi - h.x);
            float lobe = c > 0.0 ? powSC(h.y + h.z * s * s, h.z * c * c, e) : 0.0;
            float facing = sin(view.x + view.y * psi) * sin(light.x + light.y * psi);
            sum += weights[i] * lobe * max(facing, 0.0);
        }
    }
    return 0.5 * (to - from) * sum;
}

// The angle theta in right angles from its cosine c >= 0 and squared sine s2: x = theta / (pi/2)
// and y = 1 - x, both with a relative error of 2e-7: neither is made from the other where it is
// small.
void angXY(float c, float s2, OUT(float) x, OUT(float) y) {
    if (c * c < 0.5) {
        y = 0.63661977236758134 * asinS(c);
        x = 1.0 - y;
    } else {
        x = 0.63661977236758134 * asinS(sqrt(s2));
        y = 1.0 - x;
    }
}

// atanh(z) / z - 1 from w = z^2, 0 <= w <= 1/9: w / 3 + w^2 / 5 + ..., with its own digits where w
// is small; relative error 6e-6.
float atanhExcess(float w) {
    return w * (0.3333316082 + w * (0.2001229762 + w * (0.1398257887 + w * 0.1407888918)));
}

// erfc(a), a >= 0: t P(t) e^(-a^2) with t = 1 / (1 + a / 2); relative error 4e-8, and that of exp2.
float erfcOf(float a) {
    float x = min(a, 10.0); // 0 in float from a = 10 on
    float t = 1.0 / (1.0 + 0.5 * x);
    float P = 0.28209479965 + t * (0.28209286733 + t * (0.24691356122 + t * (0.17494859632
        + t * (0.095827199393 + t * (-0.067958275314 + t * (0.15188517963
        + t * (-0.48247476051 + t * (0.5168995401 + t * (-0.24558003628
        + t * 0.045351336624)))))))));
    return t * P * exp2(-1.4426950408889634 * x * x);
}

// Lambert's W, the w >= 0 of w e^w = x, x >= 0, by Newton's method from x / (1 + x), or from
// ln x - ln ln x for large x; relative error 2e-6.
float lambertW(float x) {
    float L = 0.69314718055994531 * log2(max(x, 2.72));
    float w = x < 2.72 ? x / (1.0 + x) : L - 0.69314718055994531 * log2(L);
    for (int i = 0; i < 4; ++i) {
        w -= (w - x * exp2(-1.4426950408889634 * w)) / (w + 1.0);
    }
    return w;
}

// What Stirling's formula lacks, ln m! - ((m + 1/2) ln m - m + ln(2 pi) / 2), for whole m >= 1;
// the error is below 3e-8.
float stirlingError(float m) {
    float w = 1.0 / (m * m);
    float series = (1.0 / 12.0 + w * (-1.0 / 360.0 + w * (1.0 / 1260.0 - w / 1680.0))) / m;
    if (m < 1.5) {
        return 0.0810614668;
    }
    if (m < 2.5) {
        return 0.0413406960;
    }
    return m < 3.5 ? 0.0276779257 : series;
}

// The mean of e^-x over x = 0 .. u, (1 - e^-u) / u, u >= 0; relative error 1e-7.
float meanOfExp(float u) {
    if (u < 0.25) {
        return 1.0 - u * (0.5 - u * (0.16666666667 - u * (0.041666666667
            - u * (0.0083333333333 - u * 0.0013888888889))));
    }
    return (1.0 - exp2(-1.4426950408889634 * u)) / u;
}
