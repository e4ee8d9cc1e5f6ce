// SPDX-License-Identifier: GPL-3.0-or-later
vec3 lommelSeeliger(Directions d, LommelSeeliger p) {
    float nl = dot(N, L);
    float q = nl / (nl + dot(N, V));
    if (p.form == LOMMEL_SEELIGER_FORM_EXTENDED) {
        q = p.bias + p.scale * pow(q, p.exponent);
    }
    if (p.form == LOMMEL_SEELIGER_FORM_PHYSICAL) {
        q *= 0.25;
    }
    return p.diffuseColor * q;
}
