// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

#include "core/image.h"
#include "sheet/sheet_plan.h"

namespace patina {

/// Holds the picture of a whole sheet: its name, the titles and labels of its axes, and the cells,
/// whose pixels are as they were drawn.
class SheetPicture {
  public:
    struct Look {
        int cellPixels = 128;  ///< of a side of a cell
        int captionLines = 0;  ///< below each cell
        bool isDisplay = true; ///< values are those of a display / 255; else linear light
    };

    /// The plan outlives it.
    SheetPicture(const SheetPlan& plan, const std::string& name, const Look& look);

    /// Puts a cell in its place; `picture`: of the look's size, three or four channels. What stands
    /// below it has as many lines as the look has room for.
    void put(int column, int row, const Image& picture,
             const std::vector<std::string>& caption = {});

    /// Puts a text where a cell cannot be.
    void putProblem(int column, int row, const std::string& why);

    /// Returns the cell's top left.
    glm::ivec2 corner(int column, int row) const;

    const Image& image() const { return image_; } ///< three channels

  private:
    int step() const; ///< from one cell to the next
    int rowStep() const;
    int captionScale() const;
    void write(const std::string& text, glm::ivec2 corner, int right);
    void writeCentred(const std::string& text, glm::ivec2 corner, int width, int scale);
    void writeLabels(const std::string& name);

    const SheetPlan& plan_;
    Look look_;
    int scale_ = 1;
    int left_ = 0; ///< of the cells
    int top_ = 0;
    Image image_;
};

} // namespace patina
