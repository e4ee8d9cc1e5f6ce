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
/// another document everything is on.
class EffectSwitches : public QObject {
    Q_OBJECT

  public:
    EffectSwitches(Document& document, ProgramEffects& effects, TriedMaterial& tried,
                   QObject* parent = nullptr);

    bool isOff(std::string_view effect) const;
    void setOff(const std::string& effect, bool off);
    const std::vector<std::string>& off() const { return off_; }

    /// The document's scene as a view of a side shows it, with the material that is tried there;
    /// valid until one of them changes.
    const Scene& scene(Side side);
    /// ProgramEffects::scene() in the same way.
    const Scene* effects(Side side);

  Q_SIGNALS:
    void changed();

  private:
    void forget();
    void switchAllOn();

    Document& document_;
    ProgramEffects& programs_;
    TriedMaterial& tried_;
    std::vector<std::string> off_;
    std::array<std::optional<Scene>, sides.size()> scenes_; ///< by side; made on demand
    std::array<std::optional<Scene>, sides.size()> effects_;
};

} // namespace patina
