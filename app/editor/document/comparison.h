// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"

namespace patina {

/// Begins, changes and ends the comparison of a document's sides, and remembers what side B had
/// last. Each function is one undo step.
class Comparison : public QObject {
    Q_OBJECT

  public:
    explicit Comparison(Document& document, QObject* parent = nullptr);

    /// Starts comparing with what was last on side B of this object, at first with a copy of side
    /// A; or stops.
    void setComparing(bool on);
    /// Shows this many sides, 1 .. 4. New sides C and D get the material and the own view of the
    /// active one; side B comes as from setComparing().
    void setSideCount(std::size_t count);
    /// Compares two materials. Side A shows the first one until comparing ends, keeps its own
    /// meanwhile, also in files, and then has it again.
    void previewMaterials(const Material& first, const Material& second, const QString& label);
    /// Compares two sets of picture settings, both with the active side's material, until comparing
    /// ends. The scene keeps its own settings.
    void previewPictures(const Scene& first, const Scene& second, const QString& label);
    /// Sets the accuracy levels of a side's material for good, even where side A only previews
    /// others.
    void setLevels(Side side, const AccuracyLevels& levels, const QString& label);
    void swapSides();

  private:
    void end();
    void putBack();
    void setPreview(std::optional<MaterialPreview> preview);

    Document& document_;
    std::optional<Material> lastSecond_;
    int lastSecondObject_ = -1; ///< is the object that `lastSecond_` was compared on
};

} // namespace patina
