// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <QStringList>

namespace patina {

/// One kind of failure in one place of evaluation, by its worst case.
struct StabilityFailure {
    QString what;     ///< "not a number on the graphics device"
    QString where;    ///< the directions in words
    QString amount;   ///< "gives (nan, 0, 0)"
    QString evalLine; ///< the case as JSON that `patina eval` reads
    std::size_t count = 0;

    friend bool operator==(const StabilityFailure&, const StabilityFailure&) = default;
};

/// Holds what a check has found, as texts: it outlives the blocks it is about.
struct StabilityOutcome {
    bool complete = false; ///< false: it was cancelled, or could not begin
    std::size_t cases = 0;
    std::vector<StabilityFailure> failures;
    QString limit;        ///< " on the graphics device only", or empty: what the verdict has to add
    QStringList problems; ///< why something could not be evaluated at all
    QStringList remarks;  ///< what was not looked at

    bool sound() const { return failures.empty() && problems.empty(); }

    friend bool operator==(const StabilityOutcome&, const StabilityOutcome&) = default;
};

} // namespace patina
