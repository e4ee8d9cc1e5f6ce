// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/cells/sheet_maker.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "core/atomic_file.h"
#include "core/display_image.h"

namespace patina {
namespace {

Sheet measuredSheet(Sheet sheet, SheetForm form) {
    if (form == SheetForm::Table && sheet.numbers.empty()) {
        sheet.numbers = {CellNumber::Time, CellNumber::Error, CellNumber::Albedo};
    }
    return sheet;
}

SheetPicture::Look lookOf(const Sheet& sheet, SheetForm form) {
    const bool hasCaptions = form != SheetForm::Table;
    return {sheet.cellPixels, hasCaptions ? static_cast<int>(sheet.numbers.size()) : 0,
            form != SheetForm::Linear};
}

} // namespace

SheetForm sheetFormOf(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending == ".csv"                       ? SheetForm::Table
           : ending == ".exr" || ending == ".hdr" ? SheetForm::Linear
                                                  : SheetForm::Display;
}

SheetMaker::SheetMaker(const SheetPlan& plan, Sheet sheet, SheetForm form, CellMaker& cells)
    : plan_(plan), sheet_(measuredSheet(std::move(sheet), form)), form_(form), cells_(cells),
      picture_(plan, sheet_.name, lookOf(sheet_, form)) {}

Checked<bool> SheetMaker::run(const GoesOn& goesOn) {
    const int cells = plan_.columns() * plan_.rows();
    for (int i = 0; i < cells; ++i) {
        if (!goesOn(i, cells)) {
            return false;
        }
        const int column = i % plan_.columns();
        const int row = i / plan_.columns();
        if (plan_.isControl(row) && column > 0) {
            repeatStart(column, row);
        } else if (auto made = make(column, row, [&] { return !goesOn(i, cells); }); !made) {
            return tl::unexpected(oneError(made.error()));
        }
    }
    const bool isAny =
        std::ranges::any_of(rows_, [](const CellRow& row) { return row.problem.empty(); });
    return isAny ? Checked<bool>(true)
                 : tl::unexpected(oneError(failure(rows_.front().problem).value()));
}

/// Makes one cell. A cell without a picture is no error, but an environment that cannot be read is.
Result<void> SheetMaker::make(int column, int row, const CellMaker::Cancelled& isCancelled) {
    CellRow made{column, row};
    const Result<Scene> scene = plan_.scene(column, row);
    if (!scene) {
        refuse(std::move(made), scene.error().problem);
        return {};
    }
    if (auto surrounded = cells_.surround(*scene); !surrounded) {
        return surrounded;
    }
    if (form_ != SheetForm::Table) {
        auto image = cells_.draw(*scene);
        if (!image) {
            refuse(std::move(made), "it cannot be drawn");
            return {};
        }
        last_ = std::move(*image);
    }
    made.numbers =
        cells_.measure(*scene, plan_.object(), sheet_.numbers, sheet_.cellPixels, isCancelled);
    if (form_ != SheetForm::Table) {
        picture_.put(column, row, last_, captionOf(made.numbers, sheet_.numbers));
    }
    rows_.push_back(std::move(made));
    return {};
}

/// Copies the cell before it, since all cells of the control row show the same.
void SheetMaker::repeatStart(int column, int row) {
    CellRow again = rows_.back();
    again.column = column;
    if (!again.problem.empty()) {
        const std::string why = again.problem;
        refuse(std::move(again), why);
        return;
    }
    if (form_ != SheetForm::Table) {
        picture_.put(column, row, last_, captionOf(again.numbers, sheet_.numbers));
    }
    rows_.push_back(std::move(again));
}

void SheetMaker::refuse(CellRow cell, std::string why) {
    picture_.putProblem(cell.column, cell.row, why);
    cell.problem = std::move(why);
    rows_.push_back(std::move(cell));
}

Result<void> SheetMaker::write(const std::filesystem::path& file, AssetClient& client) const {
    if (form_ == SheetForm::Table) {
        return writeFileAtomically(file, csv());
    }
    return client.saveImage(file,
                            form_ == SheetForm::Linear ? image() : linearFromDisplay(image()));
}

} // namespace patina
