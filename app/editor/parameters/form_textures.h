// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>

#include "parameters/parameter_source.h"

class QWidget;

namespace patina {

class ParameterRow;
class TexturePopup;

/// Manages the images on a form's values: asks for files, takes dropped ones, shows how an image
/// lies.
class FormTextures : public QObject {
    Q_OBJECT

  public:
    explicit FormTextures(QWidget* form);

    /// Sets whose values the form shows, and closes the popup that is open for another's.
    void setSource(ParameterSource* source);

    /// Connects what a row asks for, where its value takes an image.
    void attach(ParameterRow& row);

    /// Shows the image of the row's value.
    void present(ParameterRow& row);

    /// Puts a file on a value, in place of one that is there.
    void lay(const Parameter& parameter, const QString& file);

    TexturePopup* popup() const;

  private:
    void drive(const Parameter& parameter, const std::string& file);
    void ask(const ParameterRow& row);
    void allow(const Parameter& parameter);
    void setEnabled(const Parameter& parameter, bool enabled);
    void showSettings(const ParameterRow& row);
    QString startFolder(const Parameter& parameter) const;

    QWidget* form_;
    ParameterSource* source_ = nullptr;
    QPointer<TexturePopup> popup_;
    std::string popupId_;
    QString folder_; ///< is where the last image was found
};

} // namespace patina
