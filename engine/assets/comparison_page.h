// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace patina {

/// Is one picture of a comparison page.
struct PagePicture {
    std::string letter; ///< names it in short
    std::string name;
    std::string colour; ///< marks it, as "#rrggbb"
    std::string png;    ///< holds the bytes of a PNG file
};

/// Returns an HTML page that shows pictures of one size with their letters and names: two of them
/// with a line to wipe across, or all side by side. The page holds everything itself and loads
/// nothing; without scripts the pictures stand side by side. Each of `notes` is a paragraph below
/// the pictures. All texts are escaped.
std::string comparisonPage(const std::string& title, const std::vector<PagePicture>& pictures,
                           const std::vector<std::string>& notes);

} // namespace patina
