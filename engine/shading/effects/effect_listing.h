// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "shading/effects/effect_subject.h"
#include "shading/program/block_use.h"

namespace patina {

/// Holds one line of a listing of effects.
struct EffectLine {
    std::string effect; ///< "models/<id>", "lights/<id>", "ambient", "opacity": each once
    std::string detail; ///< compiled values and counts; may be empty
    std::string reason;

    friend bool operator==(const EffectLine&, const EffectLine&) = default;
};

/// "models/<id>": what a block is called in listings.
std::string effectName(std::string_view kind, std::string_view id);
std::string effectName(const BlockUse& use);

/// Returns "distribution=ggx, shadowing=exact": what of it is compiled.
std::string compiledText(const BlockUse& use);

/// Takes the lines of what is in a program. A reason is asked for only where somebody reads it.
class EffectListing {
  public:
    using Reason = std::function<std::string(const EffectSubject&)>;

    /// With a null subject it lists names and details only.
    explicit EffectListing(const EffectSubject* subject) : subject_(subject) {}

    const EffectSubject* subject() const { return subject_; }

    void add(std::string effect, std::string detail, const Reason& reason);
    void add(const BlockUse& use, const Reason& reason);

    std::vector<EffectLine> take() { return std::move(lines_); }

  private:
    const EffectSubject* subject_;
    std::vector<EffectLine> lines_;
};

/// Returns what a listing says of something that is always the same.
EffectListing::Reason always(std::string sentence);

/// Appends to the detail of a line.
std::string detailed(std::string detail, bool counts, std::string_view more);

/// Holds the lines of what is not in a program.
class LeftOutListing {
  public:
    explicit LeftOutListing(const EffectSubject& subject) : subject_(subject) {}

    const EffectSubject& subject() const { return subject_; }

    void add(std::string what, std::string reason) {
        lines_.push_back({std::move(what), {}, std::move(reason)});
    }

    std::vector<EffectLine> take() { return std::move(lines_); }

  private:
    const EffectSubject& subject_;
    std::vector<EffectLine> lines_;
};

} // namespace patina
