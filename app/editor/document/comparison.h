// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"

namespace patina {

/// Begins, changes and ends comparing: which materials or pictures a document's two sides show just
/// to be looked at, and what side B had last. Each function is one undo step.
class Comparison : public QObject {
    Q_OBJECT

  public:
    explicit Comparison(Document& document, QObject* parent = nullptr);

    /// Starts comparing with what was last on side B of this object, at first with a copy of side
    /// A; or stops.
    void setComparing(bool on);
    /// Shows so many sides, 1 .. 4: those that come have what the active one has.
    void setSideCount(std::size_t count);
    /// Compares two materials. Side A shows the first one until comparing ends, keeps its own
    /// meanwhile, also in files, and then has it again.
    void previewMaterials(const Material& first, const Material& second, const QString& label);
    /// Compares two ways to draw the scene's picture, which is otherwise the active side's, until
    /// comparing ends: the scene keeps its own.
    void previewPictures(const Scene& first, const Scene& second, const QString& label);
    /// Chooses levels for good, also where side A shows others just to be looked at.
    void setLevels(Side side, const AccuracyLevels& levels, const QString& label);
    void swapSides();

  private:
    void end();
    void putBack();
    void setPreview(std::optional<MaterialPreview> preview);

    Document& document_;
    std::optional<Material> lastSecond_;
    int lastSecondObject_ = -1; ///< what `lastSecond_` was compared on
};

} // namespace patina
