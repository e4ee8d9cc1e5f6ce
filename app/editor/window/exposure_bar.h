// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace patina {

class CompareArea;
class Document;
class ParameterEditor;

/// Edits the scene's exposure where it is always at hand.
class ExposureBar : public QWidget {
    Q_OBJECT

  public:
    ExposureBar(Document& document, CompareArea& views, QWidget* parent = nullptr);

  private:
    void show(const Document& document);

    ParameterEditor* stops_;
};

} // namespace patina
