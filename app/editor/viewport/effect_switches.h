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

/// Switches effects off in the views, so that an artist sees what each one does. This is not part
/// of the document: it is neither saved nor undone, and exports have all effects. Loading another
/// document switches everything on. A view with effects of its own has its switches in the
/// document, where they are saved, undone and exported.
class EffectSwitches : public QObject {
    Q_OBJECT

  public:
    EffectSwitches(Document& document, ProgramEffects& effects, TriedMaterial& tried,
                   QObject* parent = nullptr);

    // These read and change the switches of the active view.
    bool isOff(std::string_view effect) const;
    void setOff(const std::string& effect, bool off);
    void switchAllOn();
    const std::vector<std::string>& off() const { return offOn(document_.selection().side()); }

    /// Returns the ids of the effects that are switched off on a side.
    const std::vector<std::string>& offOn(Side side) const;

    /// Returns the document's scene as a view of a side shows it, with the material that is tried
    /// there; valid until one of them changes.
    const Scene& scene(Side side);
    /// Returns the scene as it is exported: without the material that is tried, and with all
    /// effects except those switched off in the view's own set.
    const Scene& whole(Side side);
    /// Returns ProgramEffects::scene() without the effects that are switched off on the side; null
    /// where that is null.
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
    std::vector<std::string> off_;   ///< applies to all views without effects of their own
    std::vector<std::string> shown_; ///< holds the active view's ids at the last changed()
    std::array<std::optional<Scene>, sides.size()> scenes_; ///< holds one per side, made on demand
    std::array<std::optional<Scene>, sides.size()> wholes_;
    std::array<std::optional<Scene>, sides.size()> effects_;
};

} // namespace patina
