// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"

namespace patina {

/// Holds a material that a side shows on the current object just to be tried. The document does not
/// know it: it is no edit and in no file, and the next edit ends it.
class TriedMaterial : public QObject {
    Q_OBJECT

  public:
    explicit TriedMaterial(Document& document, QObject* parent = nullptr);

    /// Shows a material on a side, on B only while the document compares. `what` names it, so that
    /// isShown() tells it from others.
    void show(Side side, const Material& material, const QString& what = {});
    void end();

    bool isShown() const { return shown_.has_value(); }
    bool isShown(const QString& what) const { return shown_ && shown_->what == what; }
    /// Returns what the side shows in place of the document's scene; null where no material is
    /// tried.
    const Scene* scene(Side side) const;

  Q_SIGNALS:
    void changed();

  private:
    struct Shown {
        Side side = Side::A;
        Scene scene;
        QString what;
    };

    Document& document_;
    std::optional<Shown> shown_;
};

} // namespace patina
