// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QObject>
#include <QStringList>

#include "background/worker.h"
#include "docks/dock_context.h"
#include "lobe/lobe_subjects.h"
#include "measure/cost/material_times.h"

class QToolButton;

namespace patina {

/// Measures what a pixel of each plotted material takes on the current object, when its button is
/// clicked.
class LobeTimes : public QObject {
    Q_OBJECT

  public:
    LobeTimes(const DockContext& context, QWidget* parent);

    QToolButton* button() const { return button_; }
    bool isMeasuring() const { return !worker_.isIdle(); }

    /// Names the materials that are plotted; times of others are forgotten.
    void setMaterials(const std::vector<LobeMaterial>& materials);

    /// Returns the time of each material, in words; empty where nobody measured them.
    const QStringList& times() const { return times_; }

    /// Says the times, and what of the document is not in the materials' programs.
    const QString& note() const { return note_; }

    void forget();
    /// Ends a measurement that runs.
    void cancel();

  Q_SIGNALS:
    void changed();

  private:
    void measure();
    void take(const std::vector<LobeMaterial>& materials,
              const Result<std::vector<MaterialTime>>& times);
    /// Says what of the document a material's program does not have.
    QString leftOutText(const LobeMaterial& material) const;

    Document& document_;
    MessageLog& messages_;
    MeshLibrary& meshes_;
    TextureLibrary& textures_;
    EnvironmentLibrary& environments_;
    QToolButton* button_;
    std::vector<LobeMaterial> materials_;
    QStringList times_;
    QString note_;
    Worker worker_;
};

} // namespace patina
