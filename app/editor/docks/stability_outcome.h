// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <QStringList>

namespace patina {

/// Holds one kind of failure at one place of the evaluation, with its worst case.
struct StabilityFailure {
    QString what;     ///< names the defect: "not a number on the graphics device"
    QString where;    ///< says the directions in words
    QString amount;   ///< says by how much: "gives (nan, 0, 0)"
    QString evalLine; ///< is the case as JSON that `patina eval` reads
    std::size_t count = 0;

    friend bool operator==(const StabilityFailure&, const StabilityFailure&) = default;
};

/// Holds what a check found, as texts, since it outlives the blocks that it is about.
struct StabilityOutcome {
    bool complete = false; ///< is false if it was cancelled or could not begin
    std::size_t cases = 0;
    std::vector<StabilityFailure> failures;
    QString limit;        ///< is what the verdict adds: " on the graphics device only", or empty
    QStringList problems; ///< say why something could not be evaluated at all
    QStringList remarks;  ///< say what was not checked

    friend bool operator==(const StabilityOutcome&, const StabilityOutcome&) = default;
};

} // namespace patina
