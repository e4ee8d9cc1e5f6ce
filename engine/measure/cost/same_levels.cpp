// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/cost/same_levels.h"

#include <algorithm>

#include "measure/choice/picture_choices.h"
#include "render/gpu/hdr_target.h"

namespace patina {
namespace {

/// Holds a level that differs from those before it.
struct Known {
    PixelSampling sampling;
    std::string level;
};

void addSame(std::vector<SameLevel>& same, const Choice& choice, glm::ivec2 size, bool dense) {
    std::vector<Known> known;
    for (const ChoiceLevel& level : choice.levels) {
        HdrTarget target;
        if (!target.fit(size, std::atoi(level.id.c_str()), dense, HdrNumbers::Full)) {
            continue;
        }
        const auto found = std::ranges::find(known, target.sampling(), &Known::sampling);
        if (found == known.end()) {
            known.push_back({target.sampling(), level.id});
        } else {
            const PixelSampling drawn = found->sampling;
            same.push_back({choice.id, level.id, found->level,
                            drawn.samples * drawn.fineness * drawn.fineness});
        }
    }
}

} // namespace

bool isDense(const Scene& scene, const MeshSource& meshes, glm::ivec2 size) {
    std::size_t corners = 0;
    for (const Object& object : scene.objects) {
        corners += object.visible ? meshes(object).indices.size() : 0;
    }
    return double(corners) / 3.0 > double(size.x) * double(size.y);
}

std::vector<SameLevel> sameSampleLevels(const std::vector<Choice>& choices, glm::ivec2 size,
                                        bool dense) {
    std::vector<SameLevel> same;
    for (const Choice& choice : choices) {
        if (isOfSamples(choice)) {
            addSame(same, choice, size, dense);
        }
    }
    return same;
}

std::vector<Choice> withoutSame(std::vector<Choice> choices, const std::vector<SameLevel>& same) {
    for (Choice& choice : choices) {
        std::erase_if(choice.levels, [&](const ChoiceLevel& level) {
            return std::ranges::any_of(same, [&](const SameLevel& each) {
                return each.choice == choice.id && each.level == level.id;
            });
        });
    }
    return choices;
}

} // namespace patina
