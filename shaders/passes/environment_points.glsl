// SPDX-License-Identifier: MIT-0
// Points that fill the unit square evenly however many there are: the first two dimensions of
// Sobol's sequence, scrambled for each pixel in its own way.

// lowbias32, C. Wellons 2018.
uint environmentHash(uint x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    return x ^ (x >> 16);
}

// Owen's scrambling of a number whose bits are in reverse: Burley 2020, Practical Hash-based Owen
// Scrambling, JCGT 9(4), listing 3, which takes the hash from Laine and Karras 2011.
uint environmentScrambled(uint x, uint seed) {
    x += seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return bitfieldReverse(x);
}

// The second dimension of the sequence before its bits are reversed: the product with Pascal's
// triangle modulo 2.
uint environmentPascal(uint x) {
    x ^= x >> 16;
    x ^= (x & 0xff00ff00u) >> 8;
    x ^= (x & 0xf0f0f0f0u) >> 4;
    x ^= (x & 0xccccccccu) >> 2;
    return x ^ ((x & 0xaaaaaaaau) >> 1);
}

// Both in 0 .. 1, below 1.
vec2 environmentPoint(uint index, uint seed) {
    uint x = environmentScrambled(index, environmentHash(seed));
    uint y = environmentScrambled(environmentPascal(index), environmentHash(seed + 1u));
    return vec2(float(x >> 8), float(y >> 8)) * (1.0 / 16777216.0);
}

// Of a pixel; `use`, below 16, tells sequences of one pixel apart.
uint environmentSeed(uint use) {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    use += 16u * uint(environmentData[1].w);
    return environmentHash(pixel.x + environmentHash(pixel.y + environmentHash(use)));
}
