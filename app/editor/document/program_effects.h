// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "document/frozen_effects.h"

namespace patina {

/// Knows which effects the views' programs need beyond those of the document's state: those of a
/// value that is dragged, and those that a value or model which the artist approaches may soon call
/// for.
class ProgramEffects : public QObject {
    Q_OBJECT

  public:
    explicit ProgramEffects(Document& document, QObject* parent = nullptr);

    /// Returns the scene whose effects a side's programs have while a value is dragged; null where
    /// they have those of the side's own scene.
    const Scene* scene(Side side) const { return frozen_.scene(side); }

  Q_SIGNALS:
    /// The views need other programs for the same picture: a drag has begun or ended.
    void changed();
    /// The views may need the programs of this state soon.
    void prewarmed(const patina::DocumentState& state);

  private:
    void follow(const DocumentChange& change);
    void begin(const ParameterTarget& dragged);
    void end();
    void prewarm(const ParameterTarget& approached);
    void prewarmModel(Side side, std::string_view modelId);

    Document& document_;
    FrozenEffects frozen_;
};

} // namespace patina
