// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "material/material.h"

class QLineEdit;
class QPlainTextEdit;

namespace patina {

/// Edits a material's name, description, author, licence and tags.
class DetailsDialog : public QDialog {
    Q_OBJECT

  public:
    explicit DetailsDialog(const Material& material, QWidget* parent = nullptr);

    /// Returns the material with what was typed, without spaces around texts and without empty
    /// tags.
    Material edited() const;

  private:
    QLineEdit* line(const QString& name, const std::string& text);

    Material material_;
    QLineEdit* name_;
    QPlainTextEdit* description_;
    QLineEdit* author_;
    QLineEdit* license_;
    QLineEdit* tags_;
};

} // namespace patina
