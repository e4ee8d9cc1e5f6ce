// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "material/material.h"

class QLineEdit;
class QPlainTextEdit;

namespace patina {

/// Shows what a material says of itself: name, description, author, licence and tags.
class DetailsDialog : public QDialog {
    Q_OBJECT

  public:
    explicit DetailsDialog(const Material& material, QWidget* parent = nullptr);

    /// The material with what was typed; spaces around texts and empty tags are left out.
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
