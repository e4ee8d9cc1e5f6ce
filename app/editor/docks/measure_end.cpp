// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/measure_end.h"

#include "text/as_text.h"

namespace patina {

MeasureEnd endOf(bool finished, const Errors& problems) {
    return problems.empty() ? MeasureEnd(finished) : tl::unexpected(problems);
}

QString problemText(const MeasureEnd& end) {
    return end ? QString() : asText(text(end.error())).trimmed();
}

} // namespace patina
