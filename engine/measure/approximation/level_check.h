// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measure/approximation/approximated_block.h"

namespace patina {

/// Returns how long a search may take so that all takes so many seconds, with the check of what it
/// has found.
double secondsOfSearch(double seconds);

/// Returns what says that the time of that check is over, so many seconds from now and a little
/// longer: a way that was found is not lost for the few seconds that checking it takes.
std::function<bool()> isOverAfter(double seconds);

/// Tries the found ways of a written block on the graphics device, whose context must be current:
/// in the stability sweep and on common cases that are not those of the search. Ways that are not
/// finite or negative there are taken out, and errors become those of the device where these are
/// larger; what is then too far off is taken out, too, and what there is no time for
/// (CheaperSearchOptions::isDeviceLate), with a note. Returns how many cases were tried; an error
/// says why none was.
Checked<std::size_t> checkedOnDevice(const EvalCase& subject, CheaperWays& ways,
                                     const std::filesystem::path& shaders,
                                     const CheaperSearchOptions& options,
                                     const std::function<bool()>& isStopped);

} // namespace patina
