// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <QString>

namespace patina {

/// Tells how the pictures of A and B are shown together.
enum class CompareMode { SideBySide, Wipe, Flip, Onion, Blink, Difference };

/// Tells where views stand that are side by side.
enum class ViewArrangement { Grid, Row, Column };

/// Holds how A and B are compared, as it is chosen and remembered.
struct CompareLook {
    CompareMode mode = CompareMode::SideBySide;
    double wipe = 0.5;      ///< 0 .. 1, the share of the picture that A has
    double wipeAngle = 0.0; ///< degrees, clockwise; 0: the line is upright and A left of it
    double onion = 0.5;     ///< 0 .. 1, the opacity of B over A
    double blink = 0.7;     ///< seconds that each picture is shown
    ViewArrangement arrangement = ViewArrangement::Grid;

    friend bool operator==(const CompareLook&, const CompareLook&) = default;
};

/// Describes a mode, and the one number that it has beside the angle of the wipe.
struct CompareModeRow {
    CompareMode mode;
    const char* id; ///< is the name under which the mode is remembered
    const char* label;
    const char* doc;
    double CompareLook::*amount = nullptr; ///< is null where the mode has no number
    const char* amountLabel = "";
    double min = 0.0;
    double max = 1.0;

    QString shownLabel() const;
    QString shownDoc() const;
    QString shownAmountLabel() const;

    /// Tells whether both pictures are drawn at one place, as one.
    bool isComposed() const;
};

/// Returns all modes, in the order in which they are offered.
std::span<const CompareModeRow> compareModes();
const CompareModeRow& rowOf(CompareMode mode);

/// Returns the mode with this id; side by side where there is none.
CompareMode compareModeCalled(const QString& id);

/// Returns the look with its mode's number at this share of its range, 0 .. 1.
CompareLook withAmount(CompareLook look, double share);
/// Returns where in its range the mode's number is, 0 .. 1; 0 where the mode has none.
double amountOf(const CompareLook& look);

/// Returns the same angle within -180 .. 180 degrees; 0 where it is not finite.
double wrappedAngle(double degrees);

} // namespace patina
