// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <glm/vec4.hpp>

#include "shading/program/block_place.h"
#include "shading/program/block_use.h"
#include "shading/program/table_layout.h"

namespace patina {

struct EffectSet;
struct Material;
struct Scene;

/// Says where the values of blocks lie that an owner may have or not; each is packed from the
/// owner's part of its kind.
struct PartPlaces {
    std::vector<BlockPlace> parts;

    /// Returns that of the kind's block; null: no effect has placed one.
    const BlockPlace* part(std::string_view kind) const;
};

/// Says where data of effects lie that are no block's values, and what packs them.
template <class Owner>
struct OwnData {
    /// Packs what a material or a scene says into the place; the set is the program's. Allocates
    /// nothing.
    using Pack = void (*)(std::span<glm::vec4> out, const Owner& owner, const EffectSet& set);

    struct Place {
        Pack pack = nullptr;
        int first = 0;
        int vec4s = 0;
    };
    std::vector<Place> own;

    /// Places so many vec4s at `next`, which moves behind them.
    void place(Pack pack, int vec4s, int& next) {
        own.push_back({pack, next, vec4s});
        next += vec4s;
    }

    /// Returns the first vec4 of what a function packs; nothing where no effect has placed it.
    std::optional<int> firstOf(Pack pack) const {
        const auto found = std::ranges::find(own, pack, &Place::pack);
        return found == own.end() ? std::nullopt : std::optional(found->first);
    }
};

/// Says where one light's values lie in those of its group: the light's, its shadows' and its
/// map's.
struct LightPlace {
    BlockPlace light;                 ///< `first` is the index of the group's header
    std::optional<BlockPlace> shadow; ///< `first` counts from the light's first vec4
    int colors = 0; ///< counts from there to the light's LightColors; 0: it has none

    int vec4s() const;
};

/// Says how a light's depth map looks at the scene (passes/shadows.glsl says what is where).
struct ShadowLayout {
    static constexpr int vec4s = 6;
};

/// Holds the array `objectData`: a material's values, shared by all objects that have them. Where
/// an object is comes to the vertices (render/instance.h).
struct ObjectLayout : PartPlaces, OwnData<Material> {
    static constexpr int surface = 0; ///< x: opacity; y: one over what the model does not pass
    static constexpr int fixed = 1;   ///< the model's values follow
    /// Are the rows that take (u, v, 1) to a place in the image, with its strength and its
    /// threshold in their w.
    static constexpr int vec4sPerTexture = 2;

    std::optional<BlockPlace> model;
    std::vector<BlockPlace> slots; ///< right behind the model, in its order
    int firstTexture = fixed;      ///< of EffectSet::textures, each with vec4sPerTexture
    std::optional<int> ground;     ///< of the ground: colour and opacity, its disk, and the
                                   ///< environment's light on it where there is one
    std::optional<BlockPlace> transparency; ///< of a surface that is put together with others: a
                                            ///< block's values, then what layers() says
    std::optional<BlockPlace> refraction;   ///< then the colour behind the objects
    TableLayout tables;                     ///< that the model and its parts read
    int vec4s = fixed;

    int refractionBackground() const { return refraction->first + refraction->vec4s(); }

    /// Tells whether such surfaces are put in order, one layer after the other.
    bool isPeeled() const;

    /// Returns in x the depth of the nearest surface of that sort; y: one over that from there to
    /// the last.
    int layers() const { return transparency->first + transparency->vec4s(); }

    int texture(std::size_t index) const {
        return firstTexture + vec4sPerTexture * static_cast<int>(index);
    }
};

/// Holds the array `sceneData`: fog, ambient and lights, shared by all programs of a scene. The
/// effects place their data from the last one to the first: lights, of which there may be any
/// number, end it.
struct SceneLayout : PartPlaces, OwnData<Scene> {
    static constexpr int ambient = 0;
    static constexpr int fixed = 1;
    /// Is what every driver offers in one block (16 KiB), and the most that is used of it (64 KiB).
    static constexpr int minCapacity = 1024;
    static constexpr int maxCapacity = 4096;

    std::vector<LightPlace> groups; ///< as EffectSet::lights; a group's header:
                                    ///< x: number of lights, y: index of the first one's values,
                                    ///< z: of the key light's, 0 where it is not among them
    int firstLight = fixed;
    const Block* environment = nullptr; ///< its values are in an array of their own
};

/// Holds the array `environmentData`, shared by all programs that look at the environment.
struct EnvironmentLayout {
    static constexpr int turn = 0;  ///< x, y: cosine and sine of its rotation; z: the first round
                                    ///< of samples; w: how many rounds
    static constexpr int sizes = 1; ///< x, y: columns and rows of the table; z: how many samples;
                                    ///< w: which series of them
    static constexpr int fixed = 2; ///< the block's values follow
    static constexpr int harmonics = 9; ///< behind them: the light on a matte surface by its normal
};

/// Lays out the array `viewData`.
struct ViewLayout {
    static constexpr int clip = 0; ///< four columns of the matrix from world to clip space
    static constexpr int eye = 4;
    static constexpr int farSide = 5;
    static constexpr int vec4s = 6;
};

/// Returns the place of a block at `next`, which moves behind it.
BlockPlace placed(const BlockUse& use, int& next);

/// They point into the catalogue's blocks, which must stay.
ObjectLayout objectLayout(const EffectSet& set);
SceneLayout sceneLayout(const EffectSet& set);

} // namespace patina
