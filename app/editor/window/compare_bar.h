// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "session/compare_look.h"

class QComboBox;
class QSlider;

namespace patina {

class CompareArea;
class Comparison;
class Document;

/// Lets the user choose how many views are compared, how A and B are shown together, and the number
/// that this mode has.
class CompareBar : public QWidget {
    Q_OBJECT

  public:
    CompareBar(Document& document, Comparison& comparison, CompareArea& views,
               QWidget* parent = nullptr);

  private:
    void showLook(const CompareLook& look);

    CompareArea& views_;
    QComboBox* count_;
    QComboBox* mode_;
    QSlider* amount_;
};

} // namespace patina
