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

/// Edits one number with a slider and a number box. Every change goes through here: it is dropped
/// if it is not finite, rounded where the type is whole, and kept inside the hard range.
class SliderWithBox : public QWidget {
    Q_OBJECT

  public:
    /// `defaultValue` is this number's own (one component of a vector, for instance).
    SliderWithBox(const Parameter& parameter, double defaultValue, const QString& name,
                  QWidget* parent = nullptr);

    /// Shows a number. One that comes from elsewhere (an undo, another material) resets the
    /// slider's range; while the number is edited here the range only widens.
    void present(double value);
    double value() const { return value_; }
    ValueSlider* slider() const { return slider_; }
    NumberBox* box() const { return box_; }

    /// Lets a drag of the label change the number, as far as the hard range.
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
    SliderRange scrubRange_; ///< is that at the drag's start, so that its speed stays
    double scrubPosition_ = 0.0;
    double scrubStart_ = 0.0; ///< is the number that Esc goes back to
    bool isScrubbing_ = false;
    bool isAsking_ = false; ///< says that what is presented is the answer to edited()
    ValueSlider* slider_;
    NumberBox* box_;
    QTimer stepping_; ///< a held key or a turned wheel is one interaction until it rests
};

} // namespace patina
