// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include <QMetaObject>
#include <QObject>

namespace patina {

/// Calls a function in the next turn of the event loop. Views need this for signals while they
/// draw: a slot may paint a widget at once, which makes another context current than the view's.
template <class News>
void tellAfterwards(QObject& teller, News news) {
    QMetaObject::invokeMethod(&teller, std::move(news), Qt::QueuedConnection);
}

} // namespace patina
