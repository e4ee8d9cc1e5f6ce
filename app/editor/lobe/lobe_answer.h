// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <variant>
#include <vector>

#include "lobe/lobe_subjects.h"
#include "measure/lobe/lobe_table.h"

namespace patina {

class EvalGpu;

/// Names the tabs of the dock, in their order.
enum class LobePage { Polar, Solid, Albedo, Fresnel, Spectrum, Slice, Float32, Float16 };

/// Returns the plot of a tab's lines; the polar one where it has none.
LobePlot linesOf(LobePage page);

/// Says what is to be found of a material for a tab; `lines.plot` counts where the tab has lines.
struct LobeQuestion {
    LobePage page = LobePage::Polar;
    LobeRequest lines;

    friend bool operator==(const LobeQuestion&, const LobeQuestion&) = default;
};

/// Is what was found of one material: its plot, or why it has none.
struct LobeAnswer {
    LobeMaterial material;
    LobeQuestion question;
    Result<std::variant<LobeSubject, NamedSolid, NamedSlice>> plot;
    std::vector<LobeLine> turned; ///< are its albedo's whole lines for light from other azimuths
};
using SharedAnswer = std::shared_ptr<const LobeAnswer>;

/// Computes the plot of a material. Where `isWanted` becomes false, its lines end early.
SharedAnswer lobeAnswer(const LobeMaterial& material, const LobeQuestion& question,
                        const Catalog& catalog, const std::function<bool()>& isWanted,
                        EvalGpu* device);

/// Keeps what was found of the materials of a plot, sketched and whole, so that a tick computes
/// only what it changes.
class LobeAnswers {
  public:
    /// Returns an answer for each material: the one that is known, or nothing. A sketch is not
    /// needed of lines that are known as a whole.
    std::vector<SharedAnswer> known(const std::vector<LobeMaterial>& materials,
                                    const LobeQuestion& question) const;

    /// Adds answers to one question; those of other materials and of other questions are forgotten.
    void keep(const std::vector<SharedAnswer>& answers);

    void clear() { all_.clear(); }

  private:
    std::vector<SharedAnswer> all_;
};

} // namespace patina
