// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/lamp_taking.h"

#include "document/scene_edits.h"
#include "session/message_log.h"
#include "viewport/compare_area.h"

namespace patina {

void takeLampsOut(Document& document, CompareArea& views, MessageLog& messages) {
    if (!takeLampsOut(document, views.active().viewport().frames().environmentLamps())) {
        messages.add({{},
                      0,
                      0,
                      "there are no lamps to take out of the environment",
                      "an environment with a sun, or with up to four lamps that are much brighter "
                      "than what is around them"});
    }
}

} // namespace patina
