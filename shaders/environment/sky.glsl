// SPDX-License-Identifier: MIT-0
#include "lib/sky_ray.glsl"

// Perez' five terms: how bright the sky is at the angle `toSun` from the sun and `up`, the cosine
// of the angle from the zenith.
float skyDistribution(float up, float toSun, float a, float b, float c, float d, float e) {
    float cosine = cos(toSun);
    return (1.0 + a * exp(b / max(up, 0.01))) * (1.0 + c * exp(d * toSun) + e * cosine * cosine);
}

// The same as a share of what it is at the zenith, with the sun at the angle `sun` from there.
float skyShare(float up, float toSun, float sun, float a, float b, float c, float d, float e) {
    return skyDistribution(up, toSun, a, b, c, d, e) / skyDistribution(1.0, sun, a, b, c, d, e);
}

// Luminance in kcd/m^2 and chromaticity x and y of the sky: Preetham et al. 1999, A.2. `t` is the
// turbidity, `sun` the angle of the sun from the zenith.
vec3 skyYxy(float up, float toSun, float t, float sun) {
    float sun2 = sun * sun;
    float sun3 = sun2 * sun;
    float chi = (4.0 / 9.0 - t / 120.0) * (PI - 2.0 * sun);
    float zenithY = (4.0453 * t - 4.9710) * tan(chi) - 0.2155 * t + 2.4192;
    float zenithX = (0.00166 * sun3 - 0.00375 * sun2 + 0.00209 * sun) * t * t +
                    (-0.02903 * sun3 + 0.06377 * sun2 - 0.03202 * sun + 0.00394) * t +
                    (0.11693 * sun3 - 0.21196 * sun2 + 0.06052 * sun + 0.25886);
    float zenithSmallY = (0.00275 * sun3 - 0.00610 * sun2 + 0.00317 * sun) * t * t +
                         (-0.04214 * sun3 + 0.08970 * sun2 - 0.04153 * sun + 0.00516) * t +
                         (0.15346 * sun3 - 0.26756 * sun2 + 0.06670 * sun + 0.26688);
    float a = 0.1787 * t - 1.4630;
    float b = -0.3554 * t + 0.4275;
    float c = -0.0227 * t + 5.3251;
    float d = 0.1206 * t - 2.5771;
    float e = -0.0670 * t + 0.3703;
    float luminance = zenithY * skyShare(up, toSun, sun, a, b, c, d, e);
    a = -0.0193 * t - 0.2592;
    b = -0.0665 * t + 0.0008;
    c = -0.0004 * t + 0.2125;
    d = -0.0641 * t - 0.8989;
    e = -0.0033 * t + 0.0452;
    float x = zenithX * skyShare(up, toSun, sun, a, b, c, d, e);
    a = -0.0167 * t - 0.2608;
    b = -0.0950 * t + 0.0092;
    c = -0.0079 * t + 0.2102;
    d = -0.0441 * t - 1.6537;
    e = -0.0109 * t + 0.0529;
    float y = zenithSmallY * skyShare(up, toSun, sun, a, b, c, d, e);
    return vec3(luminance, x, y);
}

// Linear Rec. 709 of a luminance and a chromaticity; what lies outside of the gamut is cut to it.
vec3 colorOfYxy(vec3 Yxy) {
    float scale = Yxy.x / max(Yxy.z, 1e-3);
    float X = Yxy.y * scale;
    float Z = (1.0 - Yxy.y - Yxy.z) * scale;
    return max(vec3(3.2404542 * X - 1.5371385 * Yxy.x - 0.4985314 * Z,
                    -0.9692660 * X + 1.8760108 * Yxy.x + 0.0415560 * Z,
                    0.0556434 * X - 0.2040259 * Yxy.x + 1.0572252 * Z),
               vec3(0.0));
}

// What a level ground receives from the sky, over pi, at a tenth of the paper's luminance: a fit to
// sums over the hemisphere, quadratic in the turbidity `t` and in the sine of the sun's height. It
// is within a tenth in most cases and within a quarter everywhere.
vec3 lightOfSky(float t, float rise) {
    vec3 still = vec3(0.4943, 0.5375, 0.4976) + t * (vec3(-0.0787, -0.0898, -0.0847) + t * vec3(0.0033, 0.0039, 0.0037));
    vec3 linear = vec3(0.1528, 0.8997, 3.1778) + t * (vec3(0.1516, 0.0553, -0.4399) + t * vec3(0.0188, 0.0115, 0.0302));
    vec3 square = vec3(-0.6518, -1.4399, -3.6305) + t * (vec3(0.1868, 0.4417, 1.3113) + t * vec3(-0.0216, -0.0216, -0.0766));
    return max(still + rise * (linear + rise * square), vec3(0.0));
}

// The sky above the horizon, the ground below it, and the sun's disc, whose edge fades over a tenth
// of its radius. A disc of radius r that is L bright gives L sin^2 r to a surface that faces it.
vec3 skyEnvironment(SkyRay o, SkyEnvironment p) {
    float scale = 0.1; // of kcd/m^2: a clear day then is about 1
    vec3 toSun = vec3(cos(p.sunHeight) * sin(p.sunAzimuth), sin(p.sunHeight),
                      cos(p.sunHeight) * cos(p.sunAzimuth));
    float sun = 0.5 * PI - p.sunHeight;
    float away = angleBetween(o.d, toSun);
    vec3 sky = scale * colorOfYxy(skyYxy(max(o.d.y, 0.0), away, p.turbidity, sun));
    float radius = sin(p.sunSize);
    float disc = fallingStep(0.95 * p.sunSize, 1.05 * p.sunSize, away);
    sky += p.sunColor * (p.sunIntensity * disc / (radius * radius));
    vec3 sunOnGround = p.sunColor * (p.sunIntensity * toSun.y);
    vec3 ground = p.groundColor * (lightOfSky(p.turbidity, toSun.y) + sunOnGround);
    float edge = 0.002 + 0.25 * p.horizon;
    return smoothLerp(ground, sky, -edge, edge, o.d.y) * p.tint * p.intensity;
}
