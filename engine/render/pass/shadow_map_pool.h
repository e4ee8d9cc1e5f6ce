// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "render/pass/shadow_maps.h"

namespace patina {

/// Lends shadow maps to the frames of several views. Frames whose lights and casters are the same
/// share theirs; others have their own, within one budget of memory. Maps with which no frame draws
/// are kept for later ones while there is room.
class ShadowMapPool {
  public:
    /// Is after how many frames, of all views, maps that none of them wanted are freed.
    static constexpr std::uint64_t framesKept = 64;

    /// Limits the texels of each map, and the bytes of all maps together.
    void setLimits(const ShadowLimits& limits) { limits_ = limits; }
    const ShadowLimits& limits() const { return limits_; }

    /// Forgets all maps; frames on their way keep theirs.
    void forget() { maps_.clear(); }

    /// Notes that a frame begins, whether or not it has shadows.
    void beginFrame();

    struct Lent {
        std::shared_ptr<ShadowMaps> maps; ///< is null when the frame must wait for others
        bool areNew = false;              ///< says that images were made
    };

    /// Lends maps of what is wished until they are given back: those that show it already, else
    /// `last`, which the view had before and may be null, where no other view has it, else others.
    /// Only where the whole budget is lent there are none, until other frames are done; then a
    /// frame loses its maps with which nobody has gone on for long, or at once if `mustHave`. It
    /// sees it by ShadowMaps::areReleased(). Fails when no maps can be made.
    Result<Lent> lend(const ShadowWish& wish, const std::shared_ptr<ShadowMaps>& last,
                      bool mustHave);

    /// Notes a step of a frame that has these maps.
    void noteUse(const ShadowMaps& maps);

    void giveBack(const ShadowMaps& maps);

    /// Returns the bytes of all maps.
    std::int64_t bytes() const;

  private:
    struct Entry {
        std::shared_ptr<ShadowMaps> maps;
        int borrowers = 0;           ///< counts the frames that draw with them
        std::uint64_t lastTurn = 0;  ///< is the turn in which one did
        std::uint64_t lastFrame = 0; ///< is the last frame to which they were lent
    };

    Entry* entryOf(const ShadowMaps& maps);
    Entry* find(const ShadowWish& wish, const std::shared_ptr<ShadowMaps>& last);
    bool makeRoom(std::int64_t bytes, bool mustHave);
    bool freeIdle(const ShadowMaps& except);
    std::vector<Entry>::iterator dispensable(bool mustHave);

    ShadowLimits limits_;
    std::vector<Entry> maps_;
    std::uint64_t turn_ = 0;  ///< counts lend() and noteUse()
    std::uint64_t frame_ = 0; ///< counts beginFrame()
};

} // namespace patina
