// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <QObject>

#include "document/program_effects.h"
#include "document/tried_material.h"

namespace patina {

/// Effects that are switched off in the views, so that an artist sees what each one does. They are
/// no part of the document: nothing of it is saved or undone, and what is exported has them all. In
/// another document everything is on. A view whose effects are its own has switches in the
/// document, which are undone, saved and in what is exported.
class EffectSwitches : public QObject {
    Q_OBJECT

  public:
    EffectSwitches(Document& document, ProgramEffects& effects, TriedMaterial& tried,
                   QObject* parent = nullptr);

    // These switch effects of the view that is active.
    bool isOff(std::string_view effect) const;
    void setOff(const std::string& effect, bool off);
    void switchAllOn();
    const std::vector<std::string>& off() const { return offOn(document_.selection().side()); }

    /// Returns what is switched off on a side.
    const std::vector<std::string>& offOn(Side side) const;

    /// The document's scene as a view of a side shows it, with the material that is tried there;
    /// valid until one of them changes.
    const Scene& scene(Side side);
    /// The same as it is exported: without what is tried, with all effects but those that the view
    /// has switched off for its own.
    const Scene& whole(Side side);
    /// ProgramEffects::scene() in the same way.
    const Scene* effects(Side side);

  Q_SIGNALS:
    void changed();

  private:
    void forget();
    void follow();
    void setSwitchedOff(std::vector<std::string> off, const QString& label);

    Document& document_;
    ProgramEffects& programs_;
    TriedMaterial& tried_;
    std::vector<std::string> off_;   ///< in all views whose effects are not their own
    std::vector<std::string> shown_; ///< of the active view, as was last told
    std::array<std::optional<Scene>, sides.size()> scenes_; ///< by side; made on demand
    std::array<std::optional<Scene>, sides.size()> wholes_;
    std::array<std::optional<Scene>, sides.size()> effects_;
};

} // namespace patina
