// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include <QMetaObject>
#include <QObject>

namespace patina {

/// Calls a function when the event loop has its next turn. What views ask for while they draw is
/// told of in this way: who hears of it may paint a widget at once, which makes another context
/// current than that of the view.
template <class News>
void tellAfterwards(QObject& teller, News news) {
    QMetaObject::invokeMethod(&teller, std::move(news), Qt::QueuedConnection);
}

} // namespace patina
