// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "session/mesh_import.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;

namespace patina {

/// Asks how a mesh file becomes an object: fit, scale, up axis, normals, and
/// whether each of its materials is one of its own.
class ImportDialog : public QDialog {
    Q_OBJECT

  public:
    ImportDialog(const QString& file, const MeshImport& import, QWidget* parent = nullptr);

    MeshImport chosen() const;

  private:
    QCheckBox* fits_;
    QDoubleSpinBox* scale_;
    QComboBox* up_;
    QCheckBox* flips_;
    QCheckBox* joins_;
};

} // namespace patina
