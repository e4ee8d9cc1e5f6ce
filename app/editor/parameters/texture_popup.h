// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include "catalog/block.h"
#include "parameters/parameter_source.h"

namespace patina {

class ParameterForm;

/// Edits how the image of a value is read and laid on, in a small window that goes with a click
/// beside it.
class TexturePopup : public QFrame {
    Q_OBJECT

  public:
    /// `owner` has the value and outlives this.
    TexturePopup(ParameterSource& owner, const Parameter& parameter, QWidget* parent);

    /// Shows the settings as they are now.
    void refresh();
    ParameterForm* form() const { return form_; }

  private:
    Block settings_;
    ParameterForm* form_;
};

} // namespace patina
