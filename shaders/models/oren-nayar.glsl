// SPDX-License-Identifier: MIT-0
#include "lib/diffuse.glsl"

// Whether the accuracy choice puts a cheaper form in the place of the one that is chosen.
bool orenNayarIsReplaced(OrenNayar p) {
    bool fujii = p.matte == OREN_NAYAR_MATTE_FUJII;
    if (p.form == OREN_NAYAR_FORM_EON) {
        return fujii;
    }
    bool published = p.form == OREN_NAYAR_FORM_FULL || p.form == OREN_NAYAR_FORM_INTERREFLECTION;
    return published && (fujii || p.matte == OREN_NAYAR_MATTE_QUALITATIVE);
}

// That cheaper form of white.
float orenNayarCheap(Directions d, OrenNayar p) {
    if (p.matte == OREN_NAYAR_MATTE_FUJII) {
        return fujiiDiffuse(d, min(p.roughness, 1.0));
    }
    return orenNayarQualitative(d, p.roughness * p.roughness, 0.33);
}

// The forms that the descriptor lists, as pi f cos(theta_l).
vec3 orenNayarMatte(Directions d, OrenNayar p) {
    float sigma2 = p.roughness * p.roughness;
    float r = min(p.roughness, 1.0);
    if (orenNayarIsReplaced(p)) {
        return p.diffuseColor * orenNayarCheap(d, p);
    }
    if (p.form == OREN_NAYAR_FORM_QUALITATIVE_057) {
        return p.diffuseColor * orenNayarQualitative(d, sigma2, 0.57);
    }
    if (p.form == OREN_NAYAR_FORM_FULL || p.form == OREN_NAYAR_FORM_INTERREFLECTION) {
        float bounce;
        float direct = orenNayarFull(d, sigma2, bounce);
        vec3 twice = vec3(0.0);
        if (p.form == OREN_NAYAR_FORM_INTERREFLECTION) {
            twice = p.diffuseColor * (0.17 * bounce);
        }
        return p.diffuseColor * max(vec3(direct) + twice, vec3(0.0)) * d.nl;
    }
    if (p.form == OREN_NAYAR_FORM_FUJII) {
        return p.diffuseColor * fujiiDiffuse(d, r);
    }
    if (p.form == OREN_NAYAR_FORM_EON) {
        return p.diffuseColor * fujiiDiffuse(d, r) + eonBounces(d, r, p.diffuseColor, p.matte == OREN_NAYAR_MATTE_FIT);
    }
    return p.diffuseColor * orenNayarQualitative(d, sigma2, 0.33);
}

vec3 orenNayar(Directions d, OrenNayar p) {
    return orenNayarMatte(d, p) + slotSpecular(d, p.specular);
}
