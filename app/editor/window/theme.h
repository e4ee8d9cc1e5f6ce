// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "session/session.h"

class QDBusVariant;

namespace patina {

/// Gives the application its palette and style, and follows the system while it is asked to.
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
