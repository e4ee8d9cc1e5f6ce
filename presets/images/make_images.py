#!/usr/bin/python3
# SPDX-License-Identifier: MIT-0
"""Makes the images beside it that presets lay on their surfaces.

Only authors of images run it (Debian: python3-numpy, python3-pil); the images are kept with it:

    python3 presets/images/make_images.py [NAME...]

All of them tile, and all come from noise with fixed seeds and from patterns, so that a run makes
the same images again. Most colours are tints around white that a preset multiplies its own colour
with (the mode "multiply"); normal maps and directions of combing have green up. A pattern's u goes right and its v up.
"""

import pathlib
import sys

import numpy
from PIL import Image

FOLDER = pathlib.Path(__file__).resolve().parent


# Fields: arrays of height x width floats, the first row is the top.


def noise(seed, size=512, scale=8.0, slope=1.8, stretch=(1.0, 1.0)):
    """Noise from -2 to 2 or so, of unit variance.

    Its features are about 1/scale of the image wide, its detail fades with the frequency to the
    power -slope, and stretch makes it longer along u or v.
    """
    white = numpy.random.default_rng(seed).standard_normal((size, size))
    u = numpy.fft.fftfreq(size, 1.0 / size)[None, :] * stretch[0]
    v = numpy.fft.fftfreq(size, 1.0 / size)[:, None] * stretch[1]
    frequency = numpy.hypot(u, v)
    weight = 1.0 / (1.0 + (frequency / scale) ** 2) ** (0.5 * slope + 0.5)
    weight[0, 0] = 0.0
    field = numpy.fft.ifft2(numpy.fft.fft2(white) * weight).real
    return field / field.std()


def band(seed, size=512, low=8.0, high=32.0, stretch=(1.0, 1.0)):
    """Noise of the frequencies from low to high alone, of unit variance."""
    white = numpy.random.default_rng(seed).standard_normal((size, size))
    u = numpy.fft.fftfreq(size, 1.0 / size)[None, :] * stretch[0]
    v = numpy.fft.fftfreq(size, 1.0 / size)[:, None] * stretch[1]
    frequency = numpy.hypot(u, v)
    weight = numpy.exp(-((frequency / high) ** 4)) - numpy.exp(-((frequency / low) ** 4))
    field = numpy.fft.ifft2(numpy.fft.fft2(white) * numpy.maximum(weight, 0.0)).real
    return field / field.std()


def grid(size=512):
    """u to the right and v up, from 0 to 1."""
    at = (numpy.arange(size) + 0.5) / size
    return numpy.meshgrid(at, at[::-1])


def sampled(field, u, v):
    """The field at other places, between pixels and across its edges."""
    size = field.shape[0]
    x = u * size - 0.5
    y = (1.0 - v) * size - 0.5
    x0 = numpy.floor(x).astype(int)
    y0 = numpy.floor(y).astype(int)
    fx = x - x0
    fy = y - y0
    at = lambda i, j: field[j % size, i % size]
    return ((1 - fx) * (1 - fy) * at(x0, y0) + fx * (1 - fy) * at(x0 + 1, y0)
            + (1 - fx) * fy * at(x0, y0 + 1) + fx * fy * at(x0 + 1, y0 + 1))


def cells(seed, count, size=512, warp=None):
    """The distances to the nearest and the second nearest of count points, and which is nearest."""
    random = numpy.random.default_rng(seed)
    side = int(numpy.ceil(numpy.sqrt(count)))
    points = [((i + 0.15 + 0.7 * random.random()) / side, (j + 0.15 + 0.7 * random.random()) / side)
              for i in range(side) for j in range(side)]
    u, v = grid(size)
    if warp is not None:
        u = u + warp[0]
        v = v + warp[1]
    first = numpy.full((size, size), 9.0)
    second = first.copy()
    nearest = numpy.zeros((size, size), int)
    for index, (pu, pv) in enumerate(points):
        du = (u - pu + 0.5) % 1.0 - 0.5
        dv = (v - pv + 0.5) % 1.0 - 0.5
        distance = numpy.hypot(du, dv)
        isNearer = distance < first
        second = numpy.where(isNearer, first, numpy.minimum(second, distance))
        first = numpy.where(isNearer, distance, first)
        nearest = numpy.where(isNearer, index, nearest)
    return first * side, second * side, nearest


def smooth(low, high, x):
    """0 below low, 1 above high, and a soft step between."""
    t = numpy.clip((x - low) / (high - low), 0.0, 1.0)
    return t * t * (3.0 - 2.0 * t)


def mixed(a, b, share):
    """Colours or fields between a and b."""
    a = numpy.asarray(a, float)
    b = numpy.asarray(b, float)
    if a.ndim == 1 or b.ndim == 1 or a.ndim != share.ndim:
        share = share[..., None]
    return a + (b - a) * share


def ramp(x, *stops):
    """Colours along x: stops are pairs of a place and an sRGB colour from 0 to 255."""
    places = [place for place, _ in stops]
    return numpy.stack([numpy.interp(x, places, [color[c] for _, color in stops])
                        for c in range(3)], axis=-1)


# Files.


def save_color(name, rgb, quality=82):
    """A photograph-like image of sRGB colours from 0 to 255."""
    pixels = numpy.clip(numpy.rint(rgb), 0, 255).astype(numpy.uint8)
    Image.fromarray(pixels).save(FOLDER / f"{name}.jpg", quality=quality, optimize=True)


def save_numbers(name, numbers):
    """Numbers from 0 to 1, of one channel or of three."""
    pixels = numpy.clip(numpy.rint(numbers * 255), 0, 255).astype(numpy.uint8)
    Image.fromarray(pixels).save(FOLDER / f"{name}.png", optimize=True)


def save_vectors(name, vectors):
    """Vectors of numbers from -1 to 1."""
    pixels = numpy.clip(numpy.rint(127.5 + 127.5 * vectors), 0, 255).astype(numpy.uint8)
    Image.fromarray(pixels).save(FOLDER / f"{name}.png", optimize=True)


def save_normal(name, height, size=None):
    """The normal map of a height that is given in widths of the image."""
    if size is not None and size != height.shape[0]:
        step = height.shape[0] // size
        height = height.reshape(size, step, size, step).mean(axis=(1, 3))
    pixels = height.shape[0]
    du = (numpy.roll(height, -1, 1) - numpy.roll(height, 1, 1)) * 0.5 * pixels
    dv = (numpy.roll(height, 1, 0) - numpy.roll(height, -1, 0)) * 0.5 * pixels
    n = numpy.stack([-du, -dv, numpy.ones_like(du)], axis=-1)
    n /= numpy.linalg.norm(n, axis=-1, keepdims=True)
    save_vectors(name, n)


# Materials.


def marble():
    """Soft grey clouds and dark veins where a warped noise crosses 0."""
    u, v = grid()
    warp = [0.09 * noise(11 + i, scale=2.5, slope=2.2) for i in range(2)]
    clouds = sampled(noise(13, scale=3.0, slope=2.0), u + warp[0], v + warp[1])
    broad = sampled(noise(14, scale=2.0, slope=2.4), u + warp[1], v + warp[0])
    fine = sampled(noise(15, scale=5.0, slope=2.0), u + 0.6 * warp[1], v - 0.6 * warp[0])
    veins = numpy.exp(-(numpy.abs(broad) / 0.06) ** 0.8) * smooth(-0.8, 0.9, clouds)
    threads = numpy.exp(-numpy.abs(fine) / 0.035) * smooth(-0.2, 1.2, clouds)
    grey = 0.14 * smooth(-0.5, 2.2, clouds) + 0.5 * veins + 0.28 * threads
    save_color("marble", ramp(grey, (0.0, (250, 249, 246)), (0.3, (205, 206, 208)),
                              (0.7, (128, 131, 138))))


def wood():
    """The flat-sawn face of a softwood: rings that run along u, fibres, a few knots."""
    u, v = grid()
    bend = 0.05 * noise(21, scale=1.6, slope=2.4, stretch=(1.6, 0.8)) \
        + 0.006 * noise(22, scale=12.0, stretch=(6.0, 1.0))
    knots = [(0.23, 0.62, 0.05), (0.74, 0.21, 0.035)]
    dark = numpy.zeros_like(u)
    for ku, kv, radius in knots:
        du = (u - ku + 0.5) % 1.0 - 0.5
        dv = (v - kv + 0.5) % 1.0 - 0.5
        away = numpy.hypot(du * 0.55, dv) / radius
        bend = bend + 0.55 * radius * numpy.sign(dv) * numpy.exp(-away * 0.75) * smooth(0.0, 0.5,
                                                                                       away)
        dark = numpy.maximum(dark, smooth(1.0, 0.45, away))
    rings = (7.0 * (v + bend)) % 1.0
    late = smooth(0.25, 0.92, rings) * smooth(1.0, 0.955, rings)
    fibres = noise(23, scale=60.0, slope=1.0, stretch=(16.0, 1.0))
    streaks = noise(24, scale=14.0, slope=1.4, stretch=(10.0, 1.0))
    tone = 0.12 + 0.5 * late + 0.055 * fibres + 0.06 * streaks + 0.55 * dark
    save_color("wood", ramp(tone, (0.0, (255, 250, 240)), (0.35, (232, 210, 180)),
                            (0.75, (176, 132, 92)), (1.1, (112, 74, 46))))


def oak():
    """Oak with open pores: short dark dashes in bands, and pale rays across."""
    u, v = grid()
    bend = 0.035 * noise(31, scale=1.5, slope=2.4, stretch=(1.6, 0.8)) \
        + 0.004 * noise(32, scale=14.0, stretch=(6.0, 1.0))
    rings = (6.0 * (v + bend)) % 1.0
    early = smooth(0.6, 1.0, rings) * smooth(1.0, 0.97, rings)
    pores = smooth(1.0, 2.0, noise(33, scale=90.0, slope=1.6, stretch=(9.0, 1.0)) + 1.1 * early)
    fibres = noise(34, scale=70.0, slope=1.0, stretch=(14.0, 1.0))
    broad = noise(35, scale=5.0, slope=1.6, stretch=(5.0, 1.0))
    tone = 0.24 + 0.2 * early + 0.05 * fibres + 0.09 * broad + 0.5 * pores
    save_color("oak", ramp(tone, (0.0, (255, 246, 230)), (0.4, (222, 194, 158)),
                           (0.8, (140, 100, 64)), (1.1, (84, 54, 32))))


def concrete():
    """Cement with stains, grains of sand and air holes."""
    stains = noise(41, scale=3.0, slope=1.8)
    grains = noise(42, scale=120.0, slope=0.6)
    first, _, nearest = cells(43, 260)
    radius = numpy.random.default_rng(44).random(4096)[nearest]
    radius = numpy.where(radius > 0.72, 0.06 + 0.32 * (radius - 0.72) / 0.28, 0.0)
    holes = numpy.where(radius > 0.0, smooth(1.0, 0.7, first / numpy.maximum(radius, 1e-6)), 0.0)
    tone = 0.8 + 0.055 * stains + 0.035 * grains - 0.42 * holes
    save_color("concrete", tone[..., None] * numpy.array([255.0, 252.0, 246.0]))
    height = 0.0009 * noise(45, scale=26.0, slope=1.2) + 0.00035 * grains - 0.009 * holes
    save_normal("concrete-normal", height, 256)


def leather():
    """The grain of a hide: rounded cells of uneven size between creases."""
    warp = [0.006 * noise(51 + i, scale=12.0, slope=2.6) for i in range(2)]
    first, second, _ = cells(53, 900, warp=warp)
    creases = smooth(0.32, 0.0, second - first)
    folds = numpy.exp(-numpy.abs(noise(54, scale=3.0, slope=2.2)) / 0.05)
    wear = noise(55, scale=4.0)
    fine = noise(56, scale=90.0, slope=0.8)
    tone = 0.86 - 0.3 * creases + 0.07 * wear - 0.12 * folds + 0.02 * fine
    save_color("leather", ramp(tone, (0.35, (96, 70, 54)), (0.7, (196, 172, 154)),
                               (1.0, (255, 246, 236))))
    height = -0.0042 * creases - 0.003 * folds + 0.00012 * fine
    save_normal("leather-normal", height, 256)
    gloss = numpy.clip(0.85 - 0.6 * creases + 0.12 * wear, 0.1, 1.0)
    save_numbers("leather-gloss", gloss[::2, ::2])


def corduroy():
    """Twelve ribs along v, of short pile, with the weave's nap between them."""
    u, v = grid()
    waver = 0.0016 * noise(61, scale=6.0, slope=2.2)
    phase = (12.0 * (u + waver)) % 1.0
    ridge = numpy.sqrt(numpy.maximum(0.0, 1.0 - ((phase - 0.5) / 0.42) ** 2))
    pile = noise(62, scale=110.0, slope=0.8, stretch=(1.0, 0.5))
    nap = noise(63, scale=6.0)
    tufts = numpy.sin(2.0 * numpy.pi * 48.0 * v + 1.3 * noise(64, scale=20.0))
    tone = 0.3 + 0.56 * ridge ** 0.7 + 0.06 * pile * ridge + 0.05 * nap + 0.035 * tufts * ridge
    save_color("corduroy", ramp(tone, (0.0, (60, 52, 46)), (0.5, (170, 158, 146)),
                                (1.0, (255, 248, 240))))
    save_normal("corduroy-normal", 0.013 * ridge + 0.0006 * pile + 0.0005 * tufts * ridge, 256)


def felt():
    """Matted fibres: threads in every direction, in clumps."""
    size = 512
    fibres = numpy.zeros((size, size))
    for index, angle in enumerate(numpy.linspace(0.0, numpy.pi, 9, endpoint=False)):
        # Whole numbers of waves, so that it tiles.
        white = numpy.random.default_rng(71 + index).standard_normal((size, size))
        fu = numpy.fft.fftfreq(size, 1.0 / size)[None, :]
        fv = numpy.fft.fftfreq(size, 1.0 / size)[:, None]
        along = fu * numpy.cos(angle) + fv * numpy.sin(angle)
        across = -fu * numpy.sin(angle) + fv * numpy.cos(angle)
        weight = numpy.exp(-(along / 14.0) ** 2) * numpy.exp(-((numpy.abs(across) - 55.0) / 35.0)
                                                             ** 2)
        field = numpy.fft.ifft2(numpy.fft.fft2(white) * weight).real
        fibres = numpy.maximum(fibres, field / field.std())
    fibres = (fibres - fibres.mean()) / fibres.std()
    clumps = noise(81, scale=14.0, slope=1.4)
    tone = 0.74 + 0.1 * fibres + 0.065 * clumps
    save_color("felt", ramp(tone, (0.3, (110, 100, 96)), (0.75, (214, 206, 204)),
                            (1.05, (255, 252, 250))))
    save_normal("felt-normal", 0.0009 * fibres + 0.0028 * clumps, 256)


def bamboo():
    """Six canes along u, each with nodes at its own places and streaks of its own tone."""
    u, v = grid()
    count = 6
    cane = numpy.floor(v * count).astype(int) % count
    phase = (v * count) % 1.0
    round_ = numpy.sqrt(numpy.maximum(0.0, 1.0 - ((phase - 0.5) / 0.485) ** 2))
    random = numpy.random.default_rng(91)
    tones = random.normal(0.0, 0.05, count)[cane]
    nodes = numpy.zeros_like(u)
    place = random.random(count)[cane]
    for extra in (0.0, 0.5):
        du = (u - place - extra + 0.5) % 1.0 - 0.5
        nodes = nodes + numpy.exp(-(du / 0.006) ** 2) - 0.6 * numpy.exp(-((du - 0.014) / 0.008)
                                                                        ** 2)
    fibres = noise(92, scale=50.0, slope=1.0, stretch=(22.0, 1.0))
    green = smooth(0.0, 2.0, noise(93, scale=3.0, stretch=(3.0, 1.0)))
    tone = 0.86 * round_ ** 0.45 + tones + 0.03 * fibres - 0.3 * numpy.maximum(nodes, 0.0)
    rgb = ramp(tone, (0.0, (52, 38, 22)), (0.45, (168, 138, 92)), (0.8, (232, 212, 166)),
               (1.0, (255, 244, 206)))
    save_color("bamboo", mixed(rgb, rgb * numpy.array([0.86, 0.97, 0.72]), 0.5 * green))
    save_normal("bamboo-normal", 0.035 * round_ + 0.004 * nodes + 0.00015 * fibres, 256)


def verdigris():
    """Bronze under patina: how much of it is there, its greens, and what is left of the metal."""
    broad = noise(101, scale=2.5, slope=1.5)
    fine = noise(102, scale=24.0, slope=1.2)
    runs = noise(103, scale=9.0, slope=1.4, stretch=(1.0, 5.0))
    patina = smooth(-0.55, 0.75, 0.8 * broad + 0.35 * runs + 0.28 * fine)
    green = ramp(0.5 + 0.22 * fine + 0.16 * runs, (0.0, (44, 88, 76)), (0.5, (88, 146, 126)),
                 (1.0, (158, 198, 176)))
    brown = ramp(0.5 + 0.25 * fine, (0.0, (38, 22, 12)), (1.0, (74, 46, 24)))
    save_color("verdigris", mixed(brown, green, patina))
    save_numbers("verdigris-bare", (1.0 - patina)[::2, ::2])
    save_normal("verdigris-normal", 0.0022 * patina + 0.0006 * fine * patina, 256)


def sheeting():
    """Prismatic road-sign sheeting: bright cells in a hexagonal grid of dull seams."""
    u, v = grid()
    columns, rows = 7.0, 8.0  # 8 / 7 is close to 2 / sqrt(3)
    x, y = u * columns, v * rows

    def distance(x, y):
        """To the nearest seam between hexagons whose centres are 1 apart in a row."""
        best = numpy.full(x.shape, 9.0)
        second = best.copy()
        for row in range(-1, int(rows) + 2):
            shift = 0.5 * (row % 2)
            column = numpy.floor(x - shift + 0.5)
            for step in (-1.0, 0.0, 1.0):
                d = numpy.hypot(x - (column + step + shift), (y - row) * 0.866)
                second = numpy.minimum(second, numpy.maximum(best, d))
                best = numpy.minimum(best, d)
        return second - best

    seam = smooth(0.17, 0.1, distance(x, y))
    sparkle = band(111, low=70.0, high=150.0)
    tone = 0.97 + 0.03 * sparkle - 0.45 * seam
    save_color("sheeting", tone[..., None] * numpy.array([255.0, 255.0, 255.0]), 88)


def char():
    """Charred wood: blocks between deep cracks, and fibres along v."""
    warp = [0.02 * noise(121 + i, scale=8.0) for i in range(2)]
    u, v = grid()
    first, second, nearest = cells(123, 190, warp=warp)
    crack = smooth(0.16, 0.02, second - first)
    fibres = noise(124, scale=44.0, slope=1.0, stretch=(1.0, 7.0))
    ash = smooth(0.9, 2.2, noise(125, scale=12.0, slope=1.2) + 0.5 * fibres)
    shade = numpy.random.default_rng(126).random(4096)[nearest]
    tone = (0.26 + 0.16 * shade + 0.06 * fibres) * (1.0 - 0.8 * crack)
    rgb = tone[..., None] * numpy.array([255.0, 252.0, 248.0])
    save_color("char", mixed(rgb, numpy.array([150.0, 148.0, 145.0]), 0.55 * ash * (1.0 - crack)))
    save_normal("char-normal", -0.016 * crack + 0.0014 * fibres + 0.004 * shade, 256)


def rust():
    """Rust in scabs over dark iron, orange where it is young."""
    broad = noise(131, scale=3.0, slope=1.3)
    fine = noise(132, scale=40.0, slope=0.9)
    scabs = smooth(-0.7, 0.8, broad + 0.4 * fine)
    rgb = ramp(scabs + 0.12 * fine, (-0.2, (34, 30, 30)), (0.25, (70, 44, 34)),
               (0.6, (128, 62, 30)), (0.9, (168, 88, 40)), (1.3, (206, 128, 64)))
    save_color("rust", rgb)
    save_numbers("rust-bare", smooth(0.45, 0.0, scabs)[::2, ::2])
    save_normal("rust-normal", 0.0028 * scabs + 0.0008 * fine, 256)


def brick():
    """A stretcher bond of eight courses with pale mortar."""
    u, v = grid()
    warp = 0.0016 * noise(141, scale=30.0)
    course = numpy.floor((v + warp) * 8.0)
    x = ((u + 0.0016 * noise(142, scale=30.0)) * 4.0 + 0.5 * (course % 2)) % 1.0
    column = numpy.floor(u * 4.0 + 0.5 * (course % 2)) % 4
    y = ((v + warp) * 8.0) % 1.0
    inside = smooth(0.0, 0.035, numpy.minimum(x, 1.0 - x) - 0.018) \
        * smooth(0.0, 0.07, numpy.minimum(y, 1.0 - y) - 0.045)
    shade = numpy.random.default_rng(143).random((8, 4))[course.astype(int) % 8,
                                                          column.astype(int)]
    grain = noise(144, scale=70.0, slope=0.8)
    stains = noise(145, scale=7.0)
    bricks = ramp(shade + 0.09 * grain + 0.1 * stains, (0.0, (118, 48, 34)),
                  (0.5, (158, 74, 50)), (1.0, (186, 104, 72)))
    mortar = ramp(0.5 + 0.2 * grain, (0.0, (150, 142, 130)), (1.0, (196, 188, 174)))
    save_color("brick", mixed(mortar, bricks, inside))
    save_normal("brick-normal", 0.008 * inside + 0.0006 * grain, 256)


def denim():
    """A twill of 32 threads: a blue warp over two and under two of a white weft."""
    u, v = grid()
    count = 32
    x, y = u * count, v * count
    column = numpy.floor(x).astype(int)
    row = numpy.floor(y).astype(int)
    over = (column + row) % 4 < 2
    across = numpy.where(over, x % 1.0, y % 1.0) - 0.5
    arch = numpy.sqrt(numpy.maximum(0.0, 1.0 - (across / 0.52) ** 2))
    twist = numpy.sin(2.0 * numpy.pi * (numpy.where(over, y, x) * 1.0 + across * 1.2))
    uneven = noise(151, scale=40.0, slope=0.8)
    thread = numpy.where(over, noise(152, scale=20.0, stretch=(1.0, 12.0)),
                         noise(153, scale=20.0, stretch=(12.0, 1.0)))
    tone = 0.42 + 0.42 * arch + 0.05 * uneven + 0.05 * thread + 0.03 * twist
    fade = noise(154, scale=3.0)
    blue = ramp(tone + 0.05 * fade, (0.2, (18, 24, 44)), (0.6, (40, 62, 108)),
                 (1.0, (96, 124, 172)))
    weft = ramp(tone, (0.2, (40, 48, 70)), (0.6, (92, 108, 142)), (1.0, (160, 172, 194)))
    save_color("denim", numpy.where(over[..., None], blue, weft))
    save_normal("denim-normal", 0.008 * arch + 0.0006 * uneven + 0.0006 * twist, 256)


def brushed():
    """Brush marks along u: fine lines of uneven depth."""
    lines = noise(161, scale=130.0, slope=0.7, stretch=(60.0, 1.0))
    broad = noise(162, scale=20.0, slope=1.0, stretch=(30.0, 1.0))
    save_normal("brushed-normal", 0.0002 * lines + 0.0007 * broad, 256)


def strands():
    """Combed hair along v: strands in locks."""
    locks = noise(165, scale=9.0, slope=1.6, stretch=(1.0, 9.0))
    fine = noise(166, scale=120.0, slope=0.7, stretch=(1.0, 60.0))
    save_normal("strands-normal", 0.0009 * fine + 0.004 * locks, 256)


def crumpled():
    """Foil that was crumpled and smoothed again: flat facets between creases."""
    height = numpy.zeros((512, 512))
    for index, (count, depth) in enumerate(((30, 1.0), (110, 0.4), (420, 0.14))):
        warp = [0.03 * noise(171 + 2 * index + i, scale=4.0) for i in range(2)]
        first, _, nearest = cells(180 + index, count, warp=warp)
        tall = numpy.random.default_rng(190 + index).random(4096)[nearest]
        height = height + depth * (tall * 0.25 - first * 0.9)
    for _ in range(2):
        height = (height + numpy.roll(height, 1, 0) + numpy.roll(height, 1, 1)
                  + numpy.roll(height, (1, 1), (0, 1))) / 4.0
    save_normal("crumpled-normal", 0.022 * height, 256)


def waves():
    """Ripples that run into each other, sharper at their crests."""
    u, v = grid()
    warp = [0.02 * noise(201 + i, scale=3.0, slope=2.4) for i in range(2)]
    swell = sampled(band(203, low=3.0, high=9.0, stretch=(0.6, 1.0)), u + warp[0], v + warp[1])
    ripples = sampled(band(204, low=9.0, high=22.0, stretch=(0.7, 1.0)), u - warp[1], v + warp[0])
    crest = -numpy.abs(swell) ** 1.2
    save_normal("waves-normal", 0.0075 * crest + 0.0022 * ripples, 256)


def orange_peel():
    """The dimples of sprayed and baked paint, also of skin and of hides."""
    save_normal("peel-normal", 0.0011 * band(211, low=14.0, high=34.0), 256)


def flakes():
    """Metal flakes in paint: small facets, each tilted its own way."""
    size = 256
    _, _, nearest = cells(221, 8100, size)
    random = numpy.random.default_rng(222)
    tilt = random.normal(0.0, 0.16, (16384, 2))[nearest]
    n = numpy.concatenate([tilt, numpy.ones((size, size, 1))], axis=-1)
    n /= numpy.linalg.norm(n, axis=-1, keepdims=True)
    codes = numpy.clip(numpy.rint(n * 127.5 + 127.5), 0, 255).astype(numpy.uint8)
    Image.fromarray(codes).save(FOLDER / "flakes-normal.png", optimize=True)


def craters():
    """Regolith: bowls with raised rims, small ones on large ones, and dust."""
    size = 512
    random = numpy.random.default_rng(231)
    u, v = grid(size)
    height = 0.05 * noise(232, scale=6.0, slope=1.6)
    bright = numpy.zeros((size, size))
    for _ in range(420):
        radius = 0.006 * (1.0 - random.random()) ** -0.62
        radius = min(radius, 0.085)
        cu, cv = random.random(2)
        du = (u - cu + 0.5) % 1.0 - 0.5
        dv = (v - cv + 0.5) % 1.0 - 0.5
        away = numpy.hypot(du, dv) / radius
        bowl = numpy.where(away < 1.0, (away ** 2 - 1.0) * 0.9 + 0.25,
                           0.25 * numpy.exp(-((away - 1.0) / 0.28)))
        height = height * numpy.where(away < 1.0, 0.45, 1.0) + radius * 7.0 * bowl
        bright = bright + random.random() ** 3 * numpy.exp(-(away / 1.5) ** 2)
    fine = noise(233, scale=70.0, slope=1.0)
    maria = smooth(0.2, 1.4, noise(234, scale=2.2, slope=2.0))
    tone = 0.72 - 0.22 * maria + 0.18 * bright + 0.03 * fine
    save_color("regolith", numpy.clip(tone, 0.0, 1.0)[..., None]
               * numpy.array([255.0, 252.0, 247.0]))
    save_normal("regolith-normal", 0.045 * height + 0.0005 * fine, 256)


def belts():
    """The belts and zones of a gas giant along u, torn by storms."""
    u, v = grid()
    warp = 0.011 * noise(241, scale=10.0, slope=2.2, stretch=(1.6, 1.0)) \
        + 0.003 * noise(242, scale=24.0, slope=1.8, stretch=(1.6, 1.0))
    spot = numpy.hypot(((u - 0.36 + 0.5) % 1.0 - 0.5) / 0.085, (v - 0.47) / 0.05)
    inside = smooth(1.15, 0.8, spot)
    y = (v + warp * (1.0 - 0.7 * inside)
         + 0.03 * numpy.sign(v - 0.47) * numpy.exp(-spot ** 2 / 3.0)) % 1.0
    profile = noise(243, scale=9.0, slope=1.2)[:, 0]
    profile = (profile - profile.min()) / (profile.max() - profile.min())
    belt = profile[numpy.clip(((1.0 - y) * 512).astype(int), 0, 511)]
    fine = noise(244, scale=40.0, slope=1.0, stretch=(5.0, 1.0))
    rgb = ramp(belt + 0.05 * fine, (0.0, (146, 92, 58)), (0.3, (196, 146, 104)),
               (0.6, (232, 206, 170)), (1.0, (252, 244, 228)))
    red = ramp(0.5 + 0.25 * numpy.sin(9.0 * spot) + 0.1 * fine, (0.0, (164, 74, 44)),
               (1.0, (204, 116, 78)))
    save_color("belts", mixed(rgb, red, inside))


def tiles():
    """Four by four glazed tiles with joints, and a body that is not quite flat."""
    u, v = grid()
    count = 4
    x, y = (u * count) % 1.0, (v * count) % 1.0
    edge = numpy.minimum(numpy.minimum(x, 1.0 - x), numpy.minimum(y, 1.0 - y))
    glaze = smooth(0.02, 0.032, edge)
    cushion = smooth(0.02, 0.075, edge)
    shade = numpy.random.default_rng(251).random((count, count))[
        numpy.floor(v * count).astype(int), numpy.floor(u * count).astype(int)]
    tone = 0.9 + 0.08 * (shade - 0.5) + 0.02 * noise(252, scale=8.0)
    rgb = tone[..., None] * numpy.array([255.0, 255.0, 255.0])
    save_color("tiles", mixed(numpy.array([122.0, 118.0, 110.0]), rgb, glaze), 88)
    save_numbers("tiles-glaze", glaze[::2, ::2])
    save_normal("tiles-normal", 0.009 * cushion + 0.0008 * noise(253, scale=5.0, slope=2.4), 256)


def speckles():
    """Small soft specks, sparse: eggshell, terracotta, soap stone."""
    field = band(261, low=20.0, high=60.0)
    specks = smooth(2.0, 3.2, field)
    clouds = noise(262, scale=4.0)
    tone = 0.93 + 0.028 * clouds - 0.3 * specks + 0.012 * noise(263, scale=120.0, slope=0.6)
    save_color("speckles", ramp(tone, (0.5, (150, 118, 92)), (0.9, (240, 230, 220)),
                                (1.0, (255, 252, 248))))


def pile():
    """Short pile that leans this way and that: suede, velvet, plush, peach."""
    strokes = noise(271, scale=5.0, slope=2.0, stretch=(1.0, 0.6))
    fibres = noise(272, scale=120.0, slope=0.6)
    tone = 0.78 + 0.11 * numpy.tanh(0.8 * strokes) + 0.075 * fibres
    save_color("pile", tone[..., None] * numpy.array([255.0, 255.0, 255.0]))
    save_normal("pile-normal", 0.00085 * fibres + 0.003 * strokes, 256)


def embers():
    """Iron in the forge: orange in the heart, cherry where it cools, dark under scale."""
    scale = smooth(0.5, 1.5, noise(281, scale=12.0, slope=0.9))
    heat = noise(282, scale=2.2, slope=1.9)
    fine = noise(283, scale=40.0, slope=0.9)
    glow = (0.58 + 0.2 * heat + 0.035 * fine) * (1.0 - 0.7 * scale)
    save_color("embers", ramp(glow, (0.0, (6, 1, 0)), (0.25, (84, 6, 2)), (0.5, (196, 40, 10)),
                              (0.75, (244, 104, 28)), (1.05, (255, 176, 84))))


def tracks():
    """The grooves of a record along u, in bands between pauses."""
    u, v = grid()
    groove = numpy.sin(2.0 * numpy.pi * 64.0 * v)
    pauses = numpy.exp(-((((v * 3.0) % 1.0) - 0.5) / 0.035) ** 2)
    loud = noise(291, scale=12.0, stretch=(0.4, 1.0))
    save_normal("tracks-normal", (0.0012 + 0.0003 * loud) * groove * (1.0 - pauses), 256)


def rosettes():
    """Where hair is combed that grows in whorls: red along u, green along v, grey nowhere."""
    size = 128
    u, v = grid(size)
    red = numpy.zeros((size, size))
    green = numpy.zeros((size, size))
    for index, (pu, pv) in enumerate([(0.14, 0.3), (0.62, 0.42), (0.36, 0.72), (0.88, 0.8)]):
        du = (u - pu + 0.5) % 1.0 - 0.5
        dv = (v - pv + 0.5) % 1.0 - 0.5
        share = numpy.exp(-(du * du + dv * dv) / 0.018)
        twist = 0.7 if index % 2 else -0.7
        away = numpy.hypot(du, dv) + 0.02
        red += share * (du - twist * dv) / away
        green += share * (dv + twist * du) / away
    green -= 0.35  # elsewhere it falls down
    length = numpy.maximum(numpy.hypot(red, green), 1.0)
    pixels = numpy.stack([red / length, green / length, numpy.zeros_like(red)], axis=-1)
    save_vectors("rosettes-comb", pixels)


def chipped():
    """Machine enamel chipped off its primer and the steel below, as texture painting programs write
    it: one image of base colours, one with the roots of the widths in green and the metalness in
    blue."""
    broad = noise(301, scale=3.5, slope=1.2)
    fine = noise(302, scale=30.0, slope=0.8)
    depth = broad + 0.32 * fine
    primer = smooth(0.98, 1.02, depth)
    steel = smooth(1.22, 1.26, depth)
    scratches = band(303, low=30.0, high=120.0, stretch=(0.08, 1.0))
    dirt = smooth(0.2, 1.6, noise(304, scale=6.0, slope=1.6, stretch=(1.0, 0.35)) + 0.4 * broad)
    enamel = mixed((226, 152, 12), (176, 112, 14), 0.55 * dirt)
    rgb = mixed(enamel, numpy.array([112.0, 46.0, 36.0]), primer)
    rgb = mixed(rgb, (186 + 6 * scratches)[..., None] * numpy.array([1.0, 0.985, 0.965]), steel)
    save_color("chipped", rgb)
    root = mixed(0.36 + 0.22 * dirt, numpy.full_like(dirt, 0.82), primer)
    root = mixed(root, 0.5 + 0.05 * scratches, steel)
    packed = numpy.stack([numpy.ones_like(root), root, steel], axis=-1)[::2, ::2]
    save_numbers("chipped-metal-roughness", packed)
    height = -0.0016 * primer - 0.0010 * steel + 0.00008 * scratches * steel
    save_normal("chipped-normal", height, 256)


IMAGES = [marble, wood, oak, concrete, leather, corduroy, felt, bamboo, verdigris, sheeting, char,
          rust, brick, denim, brushed, strands, crumpled, waves, orange_peel, flakes, craters, belts, tiles,
          speckles, pile, embers, tracks, rosettes, chipped]

if __name__ == "__main__":
    for make in IMAGES:
        if len(sys.argv) == 1 or make.__name__ in sys.argv[1:]:
            make()
