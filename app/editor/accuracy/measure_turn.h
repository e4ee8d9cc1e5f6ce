// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

class QWidget;

namespace patina {

/// Whose turn it is to measure: one page at a time, since two would spoil each other's times.
class MeasureTurn : public QObject {
    Q_OBJECT

  public:
    /// False while it is another page's; that page's window title is its name.
    bool take(const QWidget& page);
    /// Nothing happens where it is not this page's.
    void giveBack(const QWidget& page);

    /// Why a page has to wait; empty: it has not.
    QString whyNot(const QWidget& page) const;

  Q_SIGNALS:
    void changed();

  private:
    const QWidget* holder_ = nullptr;
};

} // namespace patina
