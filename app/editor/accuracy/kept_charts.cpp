// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/kept_charts.h"

#include <algorithm>
#include <utility>

namespace patina {
namespace {

/// A chart is small, but the scene that it is of may be large.
constexpr std::size_t most = 8;

} // namespace

ChartSubject chartSubject(Scene scene, int object, std::string file,
                          std::shared_ptr<const Catalog> catalog) {
    const auto index = static_cast<std::size_t>(object);
    if (object >= 0 && index < scene.objects.size()) {
        Material& material = scene.objects[index].material;
        material.accuracy.clear();
        material.name.clear();
        material.description.clear();
        material.author.clear();
        material.license.clear();
        material.tags.clear();
    }
    scene.camera = {};
    scene.accuracy = {};
    scene.ground.mode = GroundMode::Off; // a measurement is made without it
    return {std::move(scene), object, std::move(file), std::move(catalog)};
}

KeptChart& KeptCharts::keep(KeptChart chart) {
    std::erase_if(charts_,
                  [&chart](const KeptChart& each) { return each.subject == chart.subject; });
    if (charts_.size() >= most) {
        charts_.pop_front();
    }
    return charts_.emplace_back(std::move(chart));
}

const KeptChart* KeptCharts::find(const ChartSubject& subject) {
    const auto same = std::find_if(
        charts_.rbegin(), charts_.rend(),
        [&subject](const KeptChart& each) { return each.subject == subject; });
    if (same != charts_.rend()) {
        same->subject.file = subject.file;
        return &*same;
    }
    const auto near = std::find_if(
        charts_.rbegin(), charts_.rend(), [&subject](const KeptChart& each) {
            return each.subject.file == subject.file && each.subject.object == subject.object;
        });
    return near != charts_.rend() ? &*near : nullptr;
}

} // namespace patina
