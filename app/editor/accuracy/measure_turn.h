// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

class QWidget;

namespace patina {

/// Lets one page measure at a time, since two measurements would spoil each other's times.
class MeasureTurn : public QObject {
    Q_OBJECT

  public:
    /// Gives the turn to a page; false while another page has it. whyNot() names the page by its
    /// window title.
    bool take(const QWidget& page);
    /// Ends a page's turn; does nothing if the page does not have it.
    void giveBack(const QWidget& page);

    /// Says why a page has to wait; empty if it need not.
    QString whyNot(const QWidget& page) const;

  Q_SIGNALS:
    void changed();

  private:
    const QWidget* holder_ = nullptr;
};

} // namespace patina
