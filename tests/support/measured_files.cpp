// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/measured_files.h"

#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "measured/warp_table.h"

namespace patina::tests {
namespace {

using namespace std::string_view_literals;
using std::numbers::pi;

template <class Number>
void append(std::string& bytes, Number number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

glm::dvec3 direction(double polar, double azimuth) {
    return {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
            std::cos(polar)};
}

/// The normals of a rough surface: their share falls with the square of the polar angle's sine.
double normalsAt(double polar) {
    return std::exp(-4.0 * std::sin(polar) * std::sin(polar)) + 0.05;
}

struct Array {
    std::string name;
    std::vector<std::size_t> shape;
    std::vector<float> numbers;
};

std::string tensorBytes(const std::vector<Array>& arrays, const std::string& description) {
    std::size_t header = 12 + 2 + 4 + (2 + 11 + 2 + 1 + 8 + 8);
    for (const Array& array : arrays) {
        header += 2 + array.name.size() + 2 + 1 + 8 + 8 * array.shape.size();
    }
    std::string bytes("tensor_file\0\1\0"sv);
    append(bytes, std::uint32_t(arrays.size() + 1));
    std::string data;
    const auto describe = [&](const std::string& name, std::uint8_t type,
                              const std::vector<std::size_t>& shape) {
        append(bytes, std::uint16_t(name.size()));
        bytes += name;
        append(bytes, std::uint16_t(shape.size()));
        append(bytes, type);
        append(bytes, std::uint64_t(header + data.size()));
        for (const std::size_t size : shape) {
            append(bytes, std::uint64_t(size));
        }
    };
    describe("description", 1, {description.size()});
    data += description;
    for (const Array& array : arrays) {
        describe(array.name, 10, array.shape);
        data.append(reinterpret_cast<const char*>(array.numbers.data()),
                    array.numbers.size() * sizeof(float));
    }
    return bytes + data;
}

/// Returns where the i-th point of a grid of size x size lies, 0 .. 1.
glm::dvec2 placeInGrid(std::size_t i, int size) {
    const std::size_t row = i / static_cast<std::size_t>(size);
    const std::size_t column = i % static_cast<std::size_t>(size);
    return glm::dvec2(double(column), double(row)) / double(size - 1);
}

} // namespace

std::string merlBytes(const std::array<int, 3>& bins, const Reflectance& reflectance) {
    constexpr std::array<double, 3> unit{1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0};
    std::string bytes;
    for (const int count : bins) {
        append(bytes, std::int32_t(count));
    }
    for (int c = 0; c < 3; ++c) {
        for (int i = 0; i < bins[0]; ++i) {
            const double root = (i + 0.5) / bins[0];
            const double half = root * root * 0.5 * pi;
            const glm::dvec3 h(std::sin(half), 0.0, std::cos(half));
            for (int j = 0; j < bins[1]; ++j) {
                const double difference = (j + 0.5) / bins[1] * 0.5 * pi;
                for (int k = 0; k < bins[2]; ++k) {
                    const glm::dvec3 d = direction(difference, (k + 0.5) / bins[2] * pi);
                    const glm::dvec3 l(d.x * h.z + d.z * h.x, d.y, d.z * h.z - d.x * h.x);
                    const DirectionPair pair{l, 2.0 * glm::dot(l, h) * h - l};
                    const bool isAbove = pair.l.z > 0.0 && pair.v.z > 0.0;
                    append(bytes, isAbove ? reflectance(pair)[c] / unit[static_cast<std::size_t>(c)]
                                          : -1.0);
                }
            }
        }
    }
    return bytes;
}

std::string RglFile::bytes(const Reflectance& reflectance) const {
    Array phi{"phi_i", {std::size_t(azimuths)}, {}};
    for (int i = 0; i < azimuths; ++i) {
        phi.numbers.push_back(azimuths == 1 ? 0.0f : float(-pi + 2.0 * pi * i / (azimuths - 1)));
    }
    Array theta{"theta_i", {std::size_t(polars)}, {}};
    for (int i = 0; i < polars; ++i) {
        theta.numbers.push_back(float(1.4 * (i + 0.01) / polars));
    }
    const std::size_t points = std::size_t(grid) * std::size_t(grid);
    Array ndf{"ndf", {std::size_t(grid), std::size_t(grid)}, {}};
    for (std::size_t i = 0; i < points; ++i) {
        const double u = placeInGrid(i, grid).x;
        ndf.numbers.push_back(float(normalsAt(u * u * 0.5 * pi)));
    }
    Array sigma{"sigma", {2, 2}, {0.9f, 0.4f, 0.9f, 0.4f}};
    Array vndf{"vndf", {phi.numbers.size(), theta.numbers.size(), ndf.shape[0], ndf.shape[1]}, {}};
    for (std::size_t slice = 0; slice < phi.numbers.size() * theta.numbers.size(); ++slice) {
        const double tilt = theta.numbers[slice % theta.numbers.size()];
        for (std::size_t i = 0; i < points; ++i) {
            const glm::dvec2 square = placeInGrid(i, grid);
            vndf.numbers.push_back(float(double(ndf.numbers[i]) * (0.1 + square.x) *
                                         (1.2 + std::sin(tilt) * std::cos(2.0 * pi * square.y))));
        }
    }
    const WarpTable warp(SquareTable(vndf.numbers, {grid, grid}, phi.numbers, theta.numbers));
    const SquareTable normals(ndf.numbers, {grid, grid}, {}, {});
    const SquareTable area(sigma.numbers, {2, 2}, {}, {});
    const std::size_t bands = isSpectral ? 9 : 3;
    Array colours{isSpectral ? "spectra" : "rgb",
                  {phi.numbers.size(), theta.numbers.size(), bands, ndf.shape[0], ndf.shape[1]},
                  {}};
    for (const float azimuth : phi.numbers) {
        for (const float polar : theta.numbers) {
            const auto slices = warp.density().slicesAt(azimuth, polar);
            const glm::dvec3 v = direction(polar, azimuth);
            const glm::dvec2 eye(std::sqrt(double(polar) * 2.0 / pi),
                                 (double(azimuth) + pi) / (2.0 * pi));
            for (std::size_t band = 0; band < bands; ++band) {
                for (std::size_t i = 0; i < points; ++i) {
                    const glm::dvec2 half = warp.forward(placeInGrid(i, grid), slices);
                    const glm::dvec3 h =
                        direction(half.x * half.x * 0.5 * pi,
                                  (2.0 * half.y - 1.0) * pi + (azimuths == 1 ? azimuth : 0.0f));
                    const glm::dvec3 l = 2.0 * glm::dot(v, h) * h - v;
                    const double scale = l.z * 4.0 * area.at(eye, {}) / normals.at(half, {});
                    const int channel = isSpectral ? 0 : int(band);
                    colours.numbers.push_back(
                        l.z > 0.0 ? float(reflectance({l, v})[channel] * scale) : 0.0f);
                }
            }
        }
    }
    std::vector<Array> arrays{phi, theta, ndf, sigma, vndf, colours};
    if (isSpectral) {
        Array wavelengths{"wavelengths", {bands}, {}};
        for (std::size_t band = 0; band < bands; ++band) {
            wavelengths.numbers.push_back(380.0f + 40.0f * float(band));
        }
        arrays.push_back(wavelengths);
    }
    return tensorBytes(arrays, "test file");
}

} // namespace patina::tests
