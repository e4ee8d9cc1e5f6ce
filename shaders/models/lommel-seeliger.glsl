// SPDX-License-Identifier: MIT-0
#include "lib/directions.glsl"
#include "lib/elementary.glsl"

// n.l / (n.l + n.v) of Seeliger 1887; extended, bias + scale times its power, kept from being
// negative. nl > 0 and nv > 0, so only flushed subnormals could make it 0/0.
float lommelSeeligerShape(Directions d, LommelSeeliger p) {
    float sum = max(d.nl + d.nv, 1e-30);
    float q = d.nl / sum;
    if (p.form == LOMMEL_SEELIGER_FORM_EXTENDED) {
        return max(p.bias + p.scale * pow1m(d.nv / sum, q, p.exponent), 0.0);
    }
    return p.form == LOMMEL_SEELIGER_FORM_PHYSICAL ? 0.25 * q : q;
}

vec3 lommelSeeliger(Directions d, LommelSeeliger p) {
    return p.diffuseColor * lommelSeeligerShape(d, p) + slotSpecular(d, p.specular);
}
