// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace patina {

/// Decides which groups of lights stand in a program line by line, not as a loop: those of few
/// lights that reach everything, for loops are slow where a device keeps their values in memory. A
/// light with an end stays in a loop, since an object that it does not reach has a shorter one.
class LightLines {
  public:
    struct Group {
        std::uint64_t key = 0; ///< lightKey() of its lights
        int count = 0;
        bool isEverywhere = true;
        bool isReached = false; ///< a light of it reaches what is drawn
    };

    void clear();

    /// Adds a light. One that is left out, with the key 0, is in no group. One that ends before
    /// what is drawn counts among them, so that the others do not become lines by its leaving.
    void add(std::uint64_t key, bool isEverywhere, bool isReached = true);

    /// Returns them sorted by key.
    const std::vector<Group>& groups() const { return groups_; }

    /// Returns lines for the lights of a group; 0: a loop.
    int of(const Group& group) const;
    int of(std::uint64_t key) const;

  private:
    std::vector<Group> groups_;
    int lights_ = 0;
};

} // namespace patina
