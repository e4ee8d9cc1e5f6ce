// SPDX-License-Identifier: GPL-3.0-or-later
#include "lobe/lobe_subjects.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "text/display_number.h"
#include "viewport/side_view.h"

namespace patina {
namespace {

/// Tells whether the palette is one of light text on a dark ground.
bool isDark(const QPalette& palette) {
    return palette.color(QPalette::Base).lightnessF() < 0.5;
}

/// Returns the colour in the lightness that stands out from the palette's ground.
QColor standingOut(int hue, const QPalette& palette) {
    return isDark(palette) ? QColor::fromHsl(hue, 200, 165) : QColor::fromHsl(hue, 210, 95);
}

const Material* shownMaterial(const Document& document, const TriedMaterial& tried, Side side) {
    const Scene* scene = tried.scene(side);
    const int object = document.selection().object();
    const bool isThere =
        scene != nullptr && object >= 0 && static_cast<std::size_t>(object) < scene->objects.size();
    return isThere ? &scene->objects[static_cast<std::size_t>(object)].material
                   : document.material(side);
}

} // namespace

std::vector<LobeMaterial> lobeMaterials(const Document& document, const TriedMaterial& tried,
                                        bool hasSnapshots) {
    std::vector<LobeMaterial> all;
    for (std::size_t i = 0; i < document.shownSides(); ++i) {
        if (const Material* material = shownMaterial(document, tried, sides[i])) {
            all.push_back({letterOf(sides[i]).toStdString(), *material});
        }
    }
    for (const Snapshot& snapshot : document.state().snapshots) {
        if (hasSnapshots && all.size() < maxLobeSubjects) {
            all.push_back({snapshot.name, snapshot.material});
        }
    }
    return all;
}

QColor lobeColor(std::size_t place, const QPalette& palette) {
    constexpr int hues[] = {35, 207, 110, 300};
    if (place < std::size(hues)) {
        return standingOut(hues[place], palette);
    }
    return QColor::fromHsl(0, 0, isDark(palette) ? 200 : 85); // no fifth hue is far from all
}

QColor channelColor(int channel, const QPalette& palette) {
    constexpr int hues[] = {4, 115, 222};
    return standingOut(hues[channel], palette);
}

QString valueText(const glm::dvec3& v) {
    constexpr double rounding = 1e-6;
    const double max = std::max({v.x, v.y, v.z});
    if (max - std::min({v.x, v.y, v.z}) <= rounding * std::abs(max)) {
        return roundText(v.x);
    }
    return QStringLiteral("%1, %2, %3").arg(roundText(v.x), roundText(v.y), roundText(v.z));
}

} // namespace patina
