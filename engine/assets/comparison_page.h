// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace patina {

/// Is one picture of a comparison page.
struct PagePicture {
    std::string letter; ///< names it in short
    std::string name;
    std::string colour; ///< that marks it, "#rrggbb"
    std::string png;    ///< the bytes of the file
};

/// Returns an HTML page that shows pictures of one size by their letters and names, two of them
/// with a line to wipe across or all side by side. It holds everything itself and loads nothing;
/// without scripts the pictures stand side by side. `notes`: a line of text each, below the
/// pictures.
std::string comparisonPage(const std::string& title, const std::vector<PagePicture>& pictures,
                           const std::vector<std::string>& notes);

} // namespace patina
