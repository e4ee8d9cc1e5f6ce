// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>

namespace patina {

/// Is a field to search in. While it is empty, undo keys go to the document.
class SearchBox : public QLineEdit {
    Q_OBJECT

  public:
    using QLineEdit::QLineEdit;

  protected:
    bool event(QEvent* event) override;
};

} // namespace patina
