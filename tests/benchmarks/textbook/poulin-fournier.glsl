// SPDX-License-Identifier: GPL-3.0-or-later
// The arc of a ridge that a direction at the angle phi from the normal reaches.
vec2 textbookArc(float phi, float spacing, float height) {
    float end = acos(height);
    float reach = asin(min(1.0, spacing * cos(phi) - 1.0));
    vec2 arc = phi >= 0.0 ? vec2(phi - 0.5 * PI, phi + reach) : vec2(phi - reach, phi + 0.5 * PI);
    return vec2(max(arc.x, -end), min(arc.y, end));
}

// The strip of the floor between two ridges that the direction reaches.
vec2 textbookStrip(float phi, float spacing, float height) {
    float foot = sqrt(1.0 - height * height);
    float shadow = (1.0 - height * sin(abs(phi))) / cos(phi);
    return phi >= 0.0 ? vec2(foot, spacing - shadow) : vec2(shadow, spacing - foot);
}

// Poulin and Fournier 1990 by 16 even samples of the common arc.
vec3 poulinFournier(Directions d, PoulinFournier p) {
    vec3 b = cos(p.tangentAngle) * B - sin(p.tangentAngle) * T;
    vec3 H = normalize(L + V);
    float nl = dot(N, L);
    float phiL = atan(dot(L, b), nl);
    float phiV = atan(dot(V, b), dot(N, V));
    float phiH = atan(dot(H, b), dot(N, H));
    float across = length(vec2(dot(L, b), nl));
    float acrossH = length(vec2(dot(H, b), dot(N, H)));
    vec2 l = textbookArc(phiL, p.spacing, p.height);
    vec2 v = textbookArc(phiV, p.spacing, p.height);
    vec2 arc = vec2(max(l.x, v.x), min(l.y, v.y));
    vec2 sl = textbookStrip(phiL, p.spacing, p.height);
    vec2 sv = textbookStrip(phiV, p.spacing, p.height);
    float open = max(min(sl.y, sv.y) - max(sl.x, sv.x), 0.0) / p.spacing;
    float width = max(arc.y - arc.x, 0.0);
    float matte = 0.5 * (width * cos(phiL - phiV) + 0.5 * (sin(2.0 * arc.y - phiL - phiV)
        - sin(2.0 * arc.x - phiL - phiV)));
    float lobe = 0.0;
    for (int i = 0; i < 16; ++i) {
        float psi = arc.x + width * (float(i) + 0.5) / 16.0;
        lobe += pow(max(acrossH * cos(psi - phiH), 0.0), p.shininess) * cos(psi - phiV)
            * cos(psi - phiL) * width / 16.0;
    }
    float share = across / (p.spacing * cos(phiV));
    float e = p.shininess;
    float norm = (e + 2.0) * (e + 4.0) / (8.0 * (pow(2.0, -0.5 * e) + e));
    vec3 f0 = p.fresnel.f0;
    vec3 F = f0 + (vec3(1.0) - f0) * pow(1.0 - dot(V, H), 5.0);
    float flatLobe = open * pow(dot(N, H), e) * nl;
    return p.diffuseColor * (share * max(width > 0.0 ? matte : 0.0, 0.0) + open * nl)
        + p.gloss * p.specularColor * F * (norm * (share * lobe + flatLobe));
}
