// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>

#include "catalog/parameter.h"
#include "parameters/slider_range.h"

namespace patina {

class NumberBox;
class ScrubLabel;
class ValueSlider;

/// Represents a slider and a number box for one number. Whatever way a number is changed, it goes
/// through here: it is made finite, whole where it must be, and kept inside the hard range.
class NumberEdit : public QWidget {
    Q_OBJECT

  public:
    /// `defaultValue` is this number's own (one component of a vector, for instance).
    NumberEdit(const Parameter& parameter, double defaultValue, const QString& name,
               QWidget* parent = nullptr);

    /// Shows a number. One that comes from elsewhere (an undo, another material) has the slider it
    /// needs; while the number is edited here the slider only widens.
    void present(double value);
    double value() const { return value_; }
    ValueSlider* slider() const { return slider_; }
    NumberBox* box() const { return box_; }

    /// Dragging the label changes the number, as far as the hard range.
    void scrubWith(ScrubLabel& label);

  Q_SIGNALS:
    void interactionBegan();
    void edited(double value);
    void interactionEnded();

  protected:
    void hideEvent(QHideEvent* event) override;

  private:
    void ask(double wanted);
    bool keepsRange(double value) const;
    void cancelScrub();
    void step(double steps);
    void beginScrub();
    void scrub(double pixels, Qt::KeyboardModifiers modifiers);
    void endScrub();
    void finishStepping();

    Parameter parameter_;
    double defaultValue_;
    double value_ = 0.0;
    SliderRange range_;
    SliderRange scrubRange_; ///< as it was when the drag began, so that its speed does not change
    double scrubPosition_ = 0.0;
    double scrubStart_ = 0.0; ///< where Esc goes back to
    bool isScrubbing_ = false;
    bool isAsking_ = false; ///< what is presented meanwhile is the answer
    ValueSlider* slider_;
    NumberBox* box_;
    QTimer stepping_; ///< a held key or a turned wheel is one interaction until it rests
};

} // namespace patina
