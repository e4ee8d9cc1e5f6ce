// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/label.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace patina {
namespace {

constexpr int glyphWidth = 5;
constexpr int glyphHeight = 7;
constexpr int margin = 2; ///< is the space around the text, in squares

constexpr char degree = '\x01'; ///< stands for the degree sign, which is two bytes in UTF-8

struct Glyph {
    char character;
    std::array<const char*, glyphHeight> rows;
};

constexpr std::array glyphs{
    Glyph{' ', {"     ", "     ", "     ", "     ", "     ", "     ", "     "}},
    Glyph{'A', {" ### ", "#   #", "#   #", "#####", "#   #", "#   #", "#   #"}},
    Glyph{'B', {"#### ", "#   #", "#   #", "#### ", "#   #", "#   #", "#### "}},
    Glyph{'C', {" ### ", "#   #", "#    ", "#    ", "#    ", "#   #", " ### "}},
    Glyph{'D', {"#### ", "#   #", "#   #", "#   #", "#   #", "#   #", "#### "}},
    Glyph{'E', {"#####", "#    ", "#    ", "#### ", "#    ", "#    ", "#####"}},
    Glyph{'F', {"#####", "#    ", "#    ", "#### ", "#    ", "#    ", "#    "}},
    Glyph{'G', {" ### ", "#   #", "#    ", "# ###", "#   #", "#   #", " ####"}},
    Glyph{'H', {"#   #", "#   #", "#   #", "#####", "#   #", "#   #", "#   #"}},
    Glyph{'I', {" ### ", "  #  ", "  #  ", "  #  ", "  #  ", "  #  ", " ### "}},
    Glyph{'J', {"  ###", "   # ", "   # ", "   # ", "   # ", "#  # ", " ##  "}},
    Glyph{'K', {"#   #", "#  # ", "# #  ", "##   ", "# #  ", "#  # ", "#   #"}},
    Glyph{'L', {"#    ", "#    ", "#    ", "#    ", "#    ", "#    ", "#####"}},
    Glyph{'M', {"#   #", "## ##", "# # #", "# # #", "#   #", "#   #", "#   #"}},
    Glyph{'N', {"#   #", "##  #", "##  #", "# # #", "#  ##", "#  ##", "#   #"}},
    Glyph{'O', {" ### ", "#   #", "#   #", "#   #", "#   #", "#   #", " ### "}},
    Glyph{'P', {"#### ", "#   #", "#   #", "#### ", "#    ", "#    ", "#    "}},
    Glyph{'Q', {" ### ", "#   #", "#   #", "#   #", "# # #", "#  # ", " ## #"}},
    Glyph{'R', {"#### ", "#   #", "#   #", "#### ", "# #  ", "#  # ", "#   #"}},
    Glyph{'S', {" ####", "#    ", "#    ", " ### ", "    #", "    #", "#### "}},
    Glyph{'T', {"#####", "  #  ", "  #  ", "  #  ", "  #  ", "  #  ", "  #  "}},
    Glyph{'U', {"#   #", "#   #", "#   #", "#   #", "#   #", "#   #", " ### "}},
    Glyph{'V', {"#   #", "#   #", "#   #", "#   #", " # # ", " # # ", "  #  "}},
    Glyph{'W', {"#   #", "#   #", "#   #", "# # #", "# # #", "## ##", "#   #"}},
    Glyph{'X', {"#   #", "#   #", " # # ", "  #  ", " # # ", "#   #", "#   #"}},
    Glyph{'Y', {"#   #", "#   #", " # # ", "  #  ", "  #  ", "  #  ", "  #  "}},
    Glyph{'Z', {"#####", "    #", "   # ", "  #  ", " #   ", "#    ", "#####"}},
    Glyph{'0', {" ### ", "#   #", "#  ##", "# # #", "##  #", "#   #", " ### "}},
    Glyph{'1', {"  #  ", " ##  ", "  #  ", "  #  ", "  #  ", "  #  ", " ### "}},
    Glyph{'2', {" ### ", "#   #", "    #", "   # ", "  #  ", " #   ", "#####"}},
    Glyph{'3', {"#####", "   # ", "  #  ", "   # ", "    #", "#   #", " ### "}},
    Glyph{'4', {"   # ", "  ## ", " # # ", "#  # ", "#####", "   # ", "   # "}},
    Glyph{'5', {"#####", "#    ", "#### ", "    #", "    #", "#   #", " ### "}},
    Glyph{'6', {"  ## ", " #   ", "#    ", "#### ", "#   #", "#   #", " ### "}},
    Glyph{'7', {"#####", "    #", "   # ", "  #  ", "  #  ", " #   ", " #   "}},
    Glyph{'8', {" ### ", "#   #", "#   #", " ### ", "#   #", "#   #", " ### "}},
    Glyph{'9', {" ### ", "#   #", "#   #", " ####", "    #", "   # ", " ##  "}},
    Glyph{'-', {"     ", "     ", "     ", " ### ", "     ", "     ", "     "}},
    Glyph{'_', {"     ", "     ", "     ", "     ", "     ", "     ", "#####"}},
    Glyph{'.', {"     ", "     ", "     ", "     ", "     ", " ##  ", " ##  "}},
    Glyph{',', {"     ", "     ", "     ", "     ", " ##  ", "  #  ", " #   "}},
    Glyph{':', {"     ", " ##  ", " ##  ", "     ", " ##  ", " ##  ", "     "}},
    Glyph{'/', {"    #", "    #", "   # ", "  #  ", " #   ", "#    ", "#    "}},
    Glyph{'(', {"   # ", "  #  ", " #   ", " #   ", " #   ", "  #  ", "   # "}},
    Glyph{')', {" #   ", "  #  ", "   # ", "   # ", "   # ", "  #  ", " #   "}},
    Glyph{'+', {"     ", "  #  ", "  #  ", "#####", "  #  ", "  #  ", "     "}},
    Glyph{'=', {"     ", "     ", "#####", "     ", "#####", "     ", "     "}},
    Glyph{'%', {"##  #", "##  #", "   # ", "  #  ", " #   ", "#  ##", "#  ##"}},
    Glyph{'#', {" # # ", " # # ", "#####", " # # ", "#####", " # # ", " # # "}},
    Glyph{'\'', {"  #  ", "  #  ", "     ", "     ", "     ", "     ", "     "}},
    Glyph{degree, {" ##  ", "#  # ", " ##  ", "     ", "     ", "     ", "     "}},
    Glyph{'?', {" ### ", "#   #", "    #", "   # ", "  #  ", "     ", "  #  "}},
};

/// Returns the glyph of a character: lower case uses capitals, unknown characters the question
/// mark.
const Glyph& glyphOf(char character) {
    const auto capital = static_cast<char>(std::toupper(static_cast<unsigned char>(character)));
    const auto* found = std::find_if(glyphs.begin(), glyphs.end(), [capital](const Glyph& glyph) {
        return glyph.character == capital;
    });
    return found == glyphs.end() ? glyphs.back() : *found;
}

float* at(Image& image, int x, int y) {
    const std::size_t index = std::size_t(y) * std::size_t(image.width) + std::size_t(x);
    return image.pixels.data() + index * std::size_t(image.channels);
}

/// Mixes grey levels into rectangles, which are cut off at the image's edges and at `right`.
struct Brush {
    Image& image;
    int right;

    void fill(glm::ivec2 corner, glm::ivec2 size, float level, float share) const {
        for (int y = std::max(0, corner.y); y < std::min(image.height, corner.y + size.y); ++y) {
            const int end = std::min({image.width, right, corner.x + size.x});
            for (int x = std::max(0, corner.x); x < end; ++x) {
                float* pixel = at(image, x, y);
                std::transform(pixel, pixel + 3, pixel, [level, share](float channel) {
                    return channel + share * (level - channel);
                });
            }
        }
    }

    void glyph(const Glyph& drawn, glm::ivec2 corner, int scale) const {
        for (int row = 0; row < glyphHeight; ++row) {
            for (int column = 0; column < glyphWidth; ++column) {
                if (drawn.rows[std::size_t(row)][column] == '#') {
                    fill(corner + scale * glm::ivec2(column, row), glm::ivec2(scale), 1.0f, 1.0f);
                }
            }
        }
    }
};

/// Returns one byte per character: a character beyond ASCII keeps its first byte, which has no
/// glyph; the degree sign becomes `degree`.
std::string singleBytes(std::string_view text) {
    std::string bytes;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool isContinued = (static_cast<unsigned char>(text[i]) & 0xC0u) == 0x80u;
        if (text.substr(i).starts_with("\u00b0")) {
            bytes += degree;
        } else if (!isContinued) {
            bytes += text[i];
        }
    }
    return bytes;
}

} // namespace

int labelHeight(int scale) {
    return (glyphHeight + 2 * margin) * scale;
}

int labelWidth(std::string_view text, int scale) {
    const int advance = (glyphWidth + 1) * scale;
    return static_cast<int>(singleBytes(text).size()) * advance + (2 * margin - 1) * scale;
}

void drawLabel(Image& image, std::string_view text, glm::ivec2 corner, int scale, int right) {
    const Brush brush{image, right};
    const int advance = (glyphWidth + 1) * scale;
    brush.fill(corner, {labelWidth(text, scale), labelHeight(scale)}, 0.0f, 0.65f);
    glm::ivec2 place = corner + margin * scale;
    for (const char character : singleBytes(text)) {
        brush.glyph(glyphOf(character), place, scale);
        place.x += advance;
    }
}

} // namespace patina
