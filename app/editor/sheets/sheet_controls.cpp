// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheets/sheet_controls.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QToolButton>
#include <QVBoxLayout>

#include "docks/panel.h"
#include "parameters/choice_box.h"
#include "sheet/sheet_file.h"
#include "sheets/check_menu.h"
#include "text/as_text.h"

namespace patina {
namespace {

constexpr std::array offeredSizes{48, 64, 96, 128, 192, 256, 384, 512};

QString labelOf(CellNumber number) {
    switch (number) {
    case CellNumber::Time:
        return SheetControls::tr("Time of a frame");
    case CellNumber::Error:
        return SheetControls::tr("Error");
    case CellNumber::Albedo:
        break;
    }
    return SheetControls::tr("Albedo");
}

QString explained(CellNumber number) {
    switch (number) {
    case CellNumber::Time:
        return SheetControls::tr("What a frame of one size takes, the median of seven");
    case CellNumber::Error:
        return SheetControls::tr("How far 99 of 100 pixels are from the exact picture at most");
    case CellNumber::Albedo:
        break;
    }
    return SheetControls::tr("Share of an even white sky's light that comes back");
}

} // namespace

SheetControls::SheetControls(QWidget* parent)
    : QWidget(parent), x_(new AxisRow(AxisRow::Direction::Right, this)),
      y_(new AxisRow(AxisRow::Direction::Down, this)), size_(new ChoiceBox(this)),
      numbers_(textButton(tr("Numbers"), tr("What is written below the cells"), this)),
      menu_(textButton(tr("Sheet"), tr("Open, save and export the sheet"), this)) {
    size_->setAccessibleName(tr("Size of a cell"));
    size_->setToolTip(tr("Pixels of a cell's side in the exported picture, and at most here"));
    numbers_->setMenu(makeNumbersMenu());
    menu_->setMenu(makeSheetMenu());
    for (QToolButton* button : {numbers_, menu_}) {
        button->setPopupMode(QToolButton::InstantPopup);
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(x_);
    layout->addWidget(y_);
    layout->addWidget(rowOf({size_, numbers_, menu_}));
    connectParts();
}

QMenu* SheetControls::makeNumbersMenu() {
    auto* menu = new CheckMenu(numbers_);
    menu->setToolTipsVisible(true);
    for (const CellNumber number : {CellNumber::Time, CellNumber::Error, CellNumber::Albedo}) {
        QAction* check = menu->addCheck(labelOf(number), false);
        check->setToolTip(explained(number));
        check->setData(static_cast<int>(number));
        connect(check, &QAction::triggered, this, [this, number](bool on) {
            wish([number, on](Sheet& sheet) {
                std::erase(sheet.numbers, number);
                if (on) {
                    sheet.numbers.push_back(number);
                }
                std::ranges::sort(sheet.numbers);
            });
        });
    }
    return menu;
}

QMenu* SheetControls::makeSheetMenu() {
    auto* menu = new QMenu(menu_);
    menu->setToolTipsVisible(true);
    menu->addAction(tr("Open…"), this, &SheetControls::openWished);
    QMenu* examples = menu->addMenu(tr("Examples"));
    examples->setObjectName("examples");
    connect(examples, &QMenu::aboutToShow, this, [this, examples] { fillExamples(*examples); });
    menu->addAction(tr("Save…"), this, &SheetControls::saveWished);
    menu->addSeparator();
    menu->addAction(tr("Export…"), this, &SheetControls::exportWished)
        ->setToolTip(tr("As a picture, or as a table of numbers"));
    menu->addSeparator();
    QAction* control = menu->addAction(tr("Row of the start"));
    control->setToolTip(tr("A last row that shows what the sheet starts from"));
    control->setCheckable(true);
    connect(control, &QAction::triggered, this,
            [this](bool on) { wish([on](Sheet& sheet) { sheet.hasControlRow = on; }); });
    QAction* swap = menu->addAction(tr("Swap the axes"), this, [this] {
        wish([](Sheet& sheet) { std::swap(sheet.x, *sheet.y); });
    });
    connect(menu, &QMenu::aboutToShow, this, [this, control, swap] {
        control->setChecked(sheet_.hasControlRow);
        swap->setEnabled(sheet_.y.has_value());
    });
    return menu;
}

void SheetControls::fillExamples(QMenu& menu) {
    menu.clear();
    for (const std::filesystem::path& file : shippedSheets()) {
        if (const auto read = readSheet(file)) {
            const QString path = asText(file.string());
            menu.addAction(asText(read->sheet.name), this,
                           [this, path] { Q_EMIT exampleWished(path); });
        }
    }
}

void SheetControls::connectParts() {
    connect(x_, &AxisRow::wished, this, &SheetControls::wishX);
    connect(y_, &AxisRow::wished, this, &SheetControls::wishY);
    connect(size_, &QComboBox::activated, this, [this] {
        wish([this](Sheet& sheet) { sheet.cellPixels = size_->currentData().toInt(); });
    });
}

/// Asks for the axis across. Where the one down goes through the same, they change places.
void SheetControls::wishX(const std::optional<SheetAxis>& axis) {
    wish([&](Sheet& sheet) {
        sheet.x = axis.value_or(sheet.x);
        if (sheet.y && isSameAxis(sheet.x, *sheet.y)) {
            sheet.y = sheet_.x;
        }
    });
}

void SheetControls::wishY(const std::optional<SheetAxis>& axis) {
    wish([&](Sheet& sheet) {
        if (axis && sheet.y && isSameAxis(*axis, sheet.x)) {
            sheet.x = *sheet.y;
        }
        const bool isTwice = axis && isSameAxis(*axis, sheet.x);
        sheet.y = isTwice ? std::nullopt : axis;
    });
}

/// Asks for a changed sheet, also where it stays as it was: the answer makes the widgets show it
/// again.
void SheetControls::wish(const std::function<void(Sheet&)>& change) {
    Sheet sheet = sheet_;
    change(sheet);
    Q_EMIT wished(sheet);
}

void SheetControls::show(const Sheet& sheet, const AxisRow::Subject* subject) {
    sheet_ = sheet;
    fillSizes();
    for (QAction* check : numbers_->menu()->actions()) {
        const auto number = static_cast<CellNumber>(check->data().toInt());
        check->setChecked(std::ranges::find(sheet_.numbers, number) != sheet_.numbers.end());
    }
    if (subject) {
        x_->show(sheet_.x, *subject);
        y_->show(sheet_.y, *subject);
    }
}

void SheetControls::fillSizes() {
    if (size_->findData(sheet_.cellPixels) < 0) {
        std::vector<int> sizes(offeredSizes.begin(), offeredSizes.end());
        if (std::ranges::find(sizes, sheet_.cellPixels) == sizes.end()) {
            sizes.push_back(sheet_.cellPixels); // of a file
            std::ranges::sort(sizes);
        }
        size_->clear();
        for (const int size : sizes) {
            size_->addItem(tr("%1 px").arg(size), size);
        }
    }
    size_->setCurrentIndex(size_->findData(sheet_.cellPixels));
}

bool isSameAxis(const SheetAxis& a, const SheetAxis& b) {
    return a.kind == b.kind && a.value == b.value;
}

} // namespace patina
