// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QColor>
#include <QPalette>
#include <QString>

#include <glm/vec3.hpp>

#include "document/tried_material.h"

namespace patina {

/// Limits how many materials a plot shows: the one on screen and four more.
inline constexpr std::size_t maxLobeSubjects = 5;

/// Is a material that is plotted.
struct LobeMaterial {
    std::string name;
    Material material;

    friend bool operator==(const LobeMaterial&, const LobeMaterial&) = default;
};

/// Returns the current object's material on each side that is shown, with what is tried there, and
/// then the first snapshots where `hasSnapshots` says so, as many as a plot shows.
std::vector<LobeMaterial> lobeMaterials(const Document& document, const TriedMaterial& tried,
                                        bool hasSnapshots);

/// Returns the colour of a material by its place in a plot.
QColor lobeColor(std::size_t place, const QPalette& palette);

/// Returns the colour of a channel (0: red) where a plot shows the channels of one material.
QColor channelColor(int channel, const QPalette& palette);

/// Returns a value of three channels as text: one number where they are the same.
QString valueText(const glm::dvec3& v);

} // namespace patina
