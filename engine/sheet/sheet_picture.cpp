// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet/sheet_picture.h"

#include <algorithm>
#include <cmath>

#include "core/label.h"

namespace patina {
namespace {

constexpr float background = 0.13f;  ///< sRGB, 0 .. 1
constexpr double displayGamma = 2.2; ///< converts that grey alone, never a cell
constexpr int maxScale = 4;

/// Returns how much labels are magnified, so that they are legible and those of the columns fit.
int scaleFor(const SheetPlan& plan, int cellPixels) {
    int scale = std::clamp(cellPixels / 64, 1, maxScale);
    const auto isTooWide = [&](const SheetStep& step) {
        return !step.label.empty() && labelWidth(step.label, scale) > cellPixels;
    };
    while (scale > 1 && std::ranges::any_of(plan.x().steps, isTooWide)) {
        --scale;
    }
    return scale;
}

int widestRowLabel(const SheetPlan& plan, int scale) {
    int widest = plan.y() ? labelWidth(plan.y()->title, scale) : 0;
    for (int row = 0; row < plan.rows(); ++row) {
        const std::string label = plan.rowLabel(row);
        widest = std::max(widest, label.empty() ? 0 : labelWidth(label, scale));
    }
    return widest;
}

} // namespace

SheetPicture::SheetPicture(const SheetPlan& plan, const std::string& name, const Look& look)
    : plan_(plan), look_(look), scale_(scaleFor(plan, look.cellPixels)) {
    const int gap = 2 * scale_;
    const int line = labelHeight(scale_);
    left_ = widestRowLabel(plan, scale_) + gap;
    top_ = (name.empty() ? 2 : 3) * line + gap;
    const float grey =
        look.isDisplay ? background : static_cast<float>(std::pow(background, displayGamma));
    const glm::ivec2 end = corner(plan.columns(), plan.rows());
    image_ = {end.x, end.y, 3, {}};
    image_.pixels.assign(std::size_t(end.x) * std::size_t(end.y) * 3, grey);
    writeLabels(name);
}

int SheetPicture::step() const {
    return look_.cellPixels + 2 * scale_;
}

int SheetPicture::rowStep() const {
    return step() + look_.captionLines * labelHeight(captionScale());
}

/// Returns half of the labels' scale, since captions are longer.
int SheetPicture::captionScale() const {
    return std::max(1, scale_ / 2);
}

/// Sets the control row off by a gap.
glm::ivec2 SheetPicture::corner(int column, int row) const {
    const int apart = plan_.isControl(row) && plan_.isControl(plan_.rows() - 1) ? 6 * scale_ : 0;
    return {left_ + column * step(), top_ + row * rowStep() + apart};
}

void SheetPicture::write(const std::string& text, glm::ivec2 corner, int right) {
    if (!text.empty()) {
        drawLabel(image_, text, corner, scale_, right);
    }
}

void SheetPicture::writeCentred(const std::string& text, glm::ivec2 corner, int width, int scale) {
    const int spare = std::max(0, width - labelWidth(text, scale));
    if (!text.empty()) {
        drawLabel(image_, text, {corner.x + spare / 2, corner.y}, scale, corner.x + width);
    }
}

void SheetPicture::writeLabels(const std::string& name) {
    const int line = labelHeight(scale_);
    const int width = plan_.columns() * step();
    int y = 0;
    if (!name.empty()) {
        write(name, {0, 0}, image_.width);
        y += line;
    }
    writeCentred(plan_.x().title, {left_, y}, width, scale_);
    y += line;
    if (plan_.y()) {
        write(plan_.y()->title, {0, y}, left_);
    }
    for (int column = 0; column < plan_.columns(); ++column) {
        const SheetStep& step = plan_.x().steps[static_cast<std::size_t>(column)];
        writeCentred(step.label, {corner(column, 0).x, y}, look_.cellPixels, scale_);
    }
    for (int row = 0; row < plan_.rows(); ++row) {
        const int middle = corner(0, row).y + (look_.cellPixels - line) / 2;
        write(plan_.rowLabel(row), {0, middle}, left_);
    }
}

void SheetPicture::put(int column, int row, const Image& picture,
                       const std::vector<std::string>& caption) {
    const glm::ivec2 at = corner(column, row);
    const int width = std::min(picture.width, look_.cellPixels);
    for (int y = 0; y < std::min(picture.height, look_.cellPixels); ++y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t from =
                (std::size_t(y) * std::size_t(picture.width) + std::size_t(x)) *
                std::size_t(picture.channels);
            const std::size_t to =
                (std::size_t(at.y + y) * std::size_t(image_.width) + std::size_t(at.x + x)) * 3;
            std::copy_n(picture.pixels.begin() + static_cast<std::ptrdiff_t>(from), 3,
                        image_.pixels.begin() + static_cast<std::ptrdiff_t>(to));
        }
    }
    int y = at.y + look_.cellPixels;
    for (const std::string& line : caption) {
        writeCentred(line, {at.x, y}, look_.cellPixels, captionScale());
        y += labelHeight(captionScale());
    }
}

/// Breaks the text into lines and cuts off what does not fit into the cell.
void SheetPicture::putProblem(int column, int row, const std::string& why) {
    const glm::ivec2 at = corner(column, row);
    const int line = labelHeight(1);
    const auto letters = static_cast<std::size_t>(std::max(1, (look_.cellPixels - 4) / 6));
    int y = at.y;
    for (std::size_t i = 0; i < why.size() && y + line <= at.y + look_.cellPixels; i += letters) {
        drawLabel(image_, why.substr(i, letters), {at.x, y}, 1, at.x + look_.cellPixels);
        y += line;
    }
}

} // namespace patina
