// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "document/document_state.h"
#include "session/compare_look.h"

class QComboBox;
class QHBoxLayout;
class QSlider;

namespace patina {

class CompareArea;
class Comparison;
class Document;

/// Lets the user choose how many views are compared, how A and B are shown together, and the number
/// that this mode has. Its arrows and those of the keyboard put one preset after the other on B,
/// with Shift on A.
class CompareBar : public QWidget {
    Q_OBJECT

  public:
    CompareBar(Document& document, Comparison& comparison, CompareArea& views,
               QWidget* parent = nullptr);

  Q_SIGNALS:
    /// Asks for the preset that lies `by` places behind that of a side.
    void stepWished(patina::Side side, int by);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void makeSteps(QHBoxLayout* row);
    void step(int by, Qt::KeyboardModifiers modifiers);
    void showLook(const CompareLook& look);

    CompareArea& views_;
    QComboBox* count_;
    QComboBox* mode_;
    QSlider* amount_;
};

} // namespace patina
