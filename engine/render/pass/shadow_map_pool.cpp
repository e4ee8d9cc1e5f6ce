// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/shadow_map_pool.h"

#include <algorithm>
#include <functional>
#include <tuple>

namespace patina {
namespace {

/// After so many turns of others a frame is taken for one that nobody goes on with.
constexpr std::uint64_t longestPause = 64;

} // namespace

void ShadowMapPool::beginFrame() {
    ++frame_;
    std::erase_if(maps_, [this](const Entry& entry) {
        const bool isOld = entry.borrowers == 0 && entry.lastFrame + framesKept < frame_;
        if (isOld) {
            entry.maps->release();
        }
        return isOld;
    });
}

Result<ShadowMapPool::Lent> ShadowMapPool::lend(const ShadowWish& wish,
                                                const std::shared_ptr<ShadowMaps>& last,
                                                bool mustHave) {
    ++turn_;
    Entry* entry = find(wish, last);
    if (entry == nullptr || !entry->maps->haveSizeOf(wish.views)) {
        if (entry != nullptr) {
            entry->maps->release();
        }
        if (!makeRoom(wish.views.bytes(), mustHave)) {
            return Lent{};
        }
        entry = entry == nullptr ? nullptr : entryOf(*last); // making room has moved it
    }
    if (entry == nullptr) {
        entry = &maps_.emplace_back();
        entry->maps = std::make_shared<ShadowMaps>();
    }
    const std::shared_ptr<ShadowMaps> maps = entry->maps;
    Result<bool> planned = maps->plan(wish);
    if (!planned && freeIdle(*maps)) {
        planned = maps->plan(wish); // there is more memory now
        entry = entryOf(*maps);
    }
    if (!planned) {
        maps->release();
        return tl::unexpected(planned.error());
    }
    ++entry->borrowers;
    entry->lastTurn = turn_;
    entry->lastFrame = frame_;
    return Lent{maps, *planned};
}

ShadowMapPool::Entry* ShadowMapPool::entryOf(const ShadowMaps& maps) {
    const auto found =
        std::ranges::find(maps_, &maps, [](const Entry& entry) { return entry.maps.get(); });
    return found == maps_.end() ? nullptr : &*found;
}

/// Returns maps that show what is wished, else those that only this view has had, else some of the
/// same size that no view has.
ShadowMapPool::Entry* ShadowMapPool::find(const ShadowWish& wish,
                                          const std::shared_ptr<ShadowMaps>& last) {
    const auto found = std::ranges::find_if(
        maps_, [&wish](const Entry& entry) { return entry.maps->areOf(wish); });
    if (found != maps_.end()) {
        return &*found;
    }
    Entry* own = last == nullptr ? nullptr : entryOf(*last);
    constexpr long holders = 2; // the pool and this view
    if (own != nullptr && own->borrowers == 0 && last.use_count() == holders) {
        return own;
    }
    const auto free = std::ranges::find_if(maps_, [&wish](const Entry& entry) {
        return entry.maps.use_count() == 1 && entry.maps->haveSizeOf(wish.views);
    });
    return free == maps_.end() ? nullptr : &*free;
}

/// Frees all maps with which no frame draws, except these. Returns false where there are none.
bool ShadowMapPool::freeIdle(const ShadowMaps& except) {
    return std::erase_if(maps_, [&except](const Entry& entry) {
               const bool isIdle = entry.borrowers == 0 && entry.maps.get() != &except;
               if (isIdle) {
                   entry.maps->release();
               }
               return isIdle;
           }) > 0;
}

/// Frees maps until there is room for others; returns false where that is not to be had.
bool ShadowMapPool::makeRoom(std::int64_t bytes, bool mustHave) {
    while (this->bytes() + bytes > limits_.bytes) {
        const auto freed = dispensable(mustHave);
        if (freed == maps_.end()) {
            return false;
        }
        freed->maps->release();
        maps_.erase(freed);
    }
    return true;
}

/// Returns the maps that are missed least: of those that are not lent the oldest, else those of a
/// frame that nobody goes on with, or of any.
std::vector<ShadowMapPool::Entry>::iterator ShadowMapPool::dispensable(bool mustHave) {
    const auto rank = [](const Entry& entry) {
        return std::tuple(entry.maps->areReleased(), entry.borrowers > 0,
                          entry.borrowers > 0 ? entry.lastTurn : entry.lastFrame);
    };
    const auto first = std::ranges::min_element(maps_, std::less<>(), rank);
    const bool isLost =
        first == maps_.end() || first->maps->areReleased() ||
        (first->borrowers > 0 && !mustHave && first->lastTurn + longestPause >= turn_);
    return isLost ? maps_.end() : first;
}

void ShadowMapPool::noteUse(const ShadowMaps& maps) {
    ++turn_;
    if (Entry* entry = entryOf(maps)) {
        entry->lastTurn = turn_;
    }
}

void ShadowMapPool::giveBack(const ShadowMaps& maps) {
    if (Entry* entry = entryOf(maps)) {
        --entry->borrowers;
    }
}

std::int64_t ShadowMapPool::bytes() const {
    std::int64_t bytes = 0;
    for (const Entry& entry : maps_) {
        bytes += entry.maps->bytes();
    }
    return bytes;
}

} // namespace patina
