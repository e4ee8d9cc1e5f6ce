// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

#include "core/image.h"
#include "sheet/sheet_plan.h"

namespace patina {

/// Lays out the picture of a whole sheet: its name, the titles and labels of its axes, and the
/// cells, whose pixels are copied unchanged.
class SheetPicture {
  public:
    struct Look {
        int cellPixels = 128;  ///< pixels along a cell's side
        int captionLines = 0;  ///< are kept free below each cell
        bool isDisplay = true; ///< makes values sRGB in 0 .. 1; else linear light
    };

    /// Draws the labels and leaves the cells empty; `plan` must outlive it.
    SheetPicture(const SheetPlan& plan, const std::string& name, const Look& look);

    /// Puts a cell in its place. `picture` has the look's size and three or four channels;
    /// `caption` has at most as many lines as the look keeps free.
    void put(int column, int row, const Image& picture,
             const std::vector<std::string>& caption = {});

    /// Writes into a cell's place why there is no picture.
    void putProblem(int column, int row, const std::string& why);

    /// Returns the top left pixel of a cell, counted from the top left of the image.
    glm::ivec2 corner(int column, int row) const;

    const Image& image() const { return image_; } ///< has three channels

  private:
    int step() const; ///< pixels from one cell to the next in a row
    int rowStep() const;
    int captionScale() const;
    void write(const std::string& text, glm::ivec2 corner, int right);
    void writeCentred(const std::string& text, glm::ivec2 corner, int width, int scale);
    void writeLabels(const std::string& name);

    const SheetPlan& plan_;
    Look look_;
    int scale_ = 1;
    int left_ = 0; ///< pixels from the image's left to the cells
    int top_ = 0;  ///< pixels from the image's top to the cells
    Image image_;
};

} // namespace patina
