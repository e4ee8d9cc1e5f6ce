// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "session/session.h"

class QDBusVariant;

namespace patina {

/// Sets the palette and the style of the application, and follows the system's look where the user
/// chose that.
class Theme : public QObject {
    Q_OBJECT

  public:
    explicit Theme(QObject* parent = nullptr);

    Look look() const { return look_; }
    void setLook(Look look);
    bool isDark() const;

    /// Asks the desktop which look it prefers, now and whenever it changes, without blocking.
    void followDesktop();

  private Q_SLOTS:
    void settingChanged(const QString& group, const QString& key, const QDBusVariant& value);

  private:
    void setDesktopScheme(unsigned scheme);
    void apply() const;

    Look look_ = Look::System;
    bool systemIsDark_ = false;
};

} // namespace patina
