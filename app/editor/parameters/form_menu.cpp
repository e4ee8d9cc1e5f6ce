// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/form_menu.h"

#include <algorithm>
#include <random>

#include <QClipboard>
#include <QGuiApplication>
#include <QMenu>

#include "catalog/block_kind.h"
#include "catalog/random_value.h"
#include "parameters/clipboard_value.h"
#include "parameters/parameter_editor.h"
#include "parameters/parameter_form.h"
#include "parameters/parameter_row.h"
#include "parameters/parameter_section.h"
#include "parameters/parameter_text.h"

namespace patina {
namespace {

std::vector<const Parameter*> parametersOf(const std::vector<ParameterRow*>& rows) {
    std::vector<const Parameter*> parameters;
    for (const ParameterRow* row : rows) {
        parameters.push_back(&row->parameter());
    }
    return parameters;
}

std::vector<std::string> idsOf(const std::vector<ParameterRow*>& rows) {
    std::vector<std::string> ids;
    for (const ParameterRow* row : rows) {
        ids.push_back(row->parameter().id);
    }
    return ids;
}

QClipboard& clipboard() {
    return *QGuiApplication::clipboard();
}

} // namespace

FormMenu::FormMenu(ParameterForm& form) : QObject(&form), form_(form) {}

void FormMenu::setSource(ParameterSource* source, const Block* block) {
    source_ = source;
    isOfKind_ = block && findKind(block->kind);
    block_ = block ? NamedBlock{isOfKind_ ? block->kind : block->id, block->id, block->label}
                   : NamedBlock();
}

void FormMenu::attach(ParameterRow& row) {
    connect(&row, &ParameterRow::menuWished, this,
            [this, &row](const QPoint& place) { showMenuOf(row, place); });
    connect(&row, &ParameterRow::copyWished, this, [this, &row] { copy({&row}); });
    connect(&row, &ParameterRow::pasteWished, this, [this, &row] { paste(row); });
    connect(&row, &ParameterRow::unlockWished, this, [this, &row] { setLocked({&row}, false); });
}

void FormMenu::attach(ParameterSection& section) {
    connect(&section, &ParameterSection::menuWished, this,
            [this, &section](const QPoint& place) { showMenuOf(section, place); });
}

void FormMenu::showMenuOf(ParameterRow& row, const QPoint& place) {
    QMenu menu(&row);
    menu.setToolTipsVisible(true);
    const Parameter& parameter = row.parameter();
    menu.addAction(tr("Reset to %1").arg(shownValue(parameter, parameter.defaultValue)), &row,
                   &ParameterRow::reset)
        ->setEnabled(row.isChanged());
    if (source_->takesLocks()) {
        QAction* lock = menu.addAction(tr("Lock"));
        lock->setCheckable(true);
        lock->setChecked(row.isLocked());
        lock->setToolTip(tr("Random values, and a reset or a paste of the whole group, leave it "
                            "alone"));
        connect(lock, &QAction::triggered, this,
                [this, &row](bool isLocked) { setLocked({&row}, isLocked); });
    }
    menu.addSeparator();
    menu.addAction(tr("Copy"), this, [this, &row] { copy({&row}); })
        ->setToolTip(tr("As JSON, with its image"));
    menu.addAction(tr("Copy value alone"), this, [this, &row] {
        const Value value = source_->value(row.parameter());
        clipboard().setText(QString::fromStdString(copiedText(value)));
    });
    menu.addAction(tr("Copy name"), this,
                   [&row] { clipboard().setText(QString::fromStdString(row.parameter().id)); });
    const std::string text = clipboard().text().toStdString();
    menu.addAction(tr("Paste"), this, [this, &row] { paste(row); })
        ->setEnabled(hasCopiedJson() || pastedValue(parameter, text).has_value());
    menu.addSeparator();
    if (!parameter.group.empty() && form_.rowsOf(parameter.group).size() > 1) {
        const QString group = QString::fromStdString(parameter.group);
        addGroupActions(*menu.addMenu(tr("Group %1").arg(group)), form_.rowsOf(parameter.group));
    }
    addGroupActions(*menu.addMenu(tr("All of %1").arg(QString::fromStdString(block_.label))),
                    form_.rows());
    menu.exec(place);
}

void FormMenu::showMenuOf(const ParameterSection& section, const QPoint& place) {
    QMenu menu(form_.window());
    menu.setToolTipsVisible(true);
    addGroupActions(menu, section.parameterRows());
    menu.exec(place);
}

void FormMenu::addGroupActions(QMenu& menu, const Rows& rows) {
    menu.setToolTipsVisible(true);
    menu.addAction(tr("Copy"), this, [this, rows] { copy(rows); })
        ->setToolTip(tr("As JSON, with the images"));
    QAction* pasting = menu.addAction(tr("Paste"), this, [this, rows] { paste(rows); });
    pasting->setEnabled(hasCopiedJson());
    pasting->setToolTip(tr("Values of the same names; locked ones stay"));
    menu.addSeparator();
    QAction* resetting = menu.addAction(tr("Reset"), this, [this, rows] { reset(rows); });
    resetting->setEnabled(std::ranges::any_of(rows, &ParameterRow::isChanged));
    resetting->setToolTip(tr("To the defaults; locked ones stay"));
    if (isOfKind_) { // what every scene or camera has is not made by chance
        menu.addAction(tr("Randomise"), this, [this, rows] { randomise(rows); })
            ->setToolTip(tr("Values that the sliders reach. Locked ones, choices, images and what "
                            "glows stay."));
    }
    if (source_->takesLocks()) {
        menu.addSeparator();
        menu.addAction(tr("Lock"), this, [this, rows] { setLocked(rows, true); })
            ->setEnabled(!std::ranges::all_of(rows, &ParameterRow::isLocked));
        menu.addAction(tr("Unlock"), this, [this, rows] { setLocked(rows, false); })
            ->setEnabled(std::ranges::any_of(rows, &ParameterRow::isLocked));
    }
}

void FormMenu::copy(const Rows& rows) const {
    const std::vector<const Parameter*> parameters = parametersOf(rows);
    copyJson(copiedValues(block_, parameters, *source_), mayReadAll(parameters, *source_));
}

void FormMenu::paste(ParameterRow& row) const {
    const Parameter parameter = row.parameter();
    if (const auto value = pastedValue(parameter, clipboard().text().toStdString())) {
        Q_EMIT row.edited(*value);
        return;
    }
    const Result<CopiedJson> copied = copiedJson();
    if (copied && areCopiedValues(*copied)) {
        take(pastedOnto(parameter, *copied, *source_), tr("Paste %1").arg(row.editor()->name()));
    } else if (!copied && hasCopiedJson()) {
        source_->report(copied.error());
    } else {
        source_->report(inClipboard({{},
                                     1,
                                     1,
                                     "this is no value of " + parameter.label,
                                     infoOf(parameter.type).expected(parameter)}));
    }
}

void FormMenu::paste(const Rows& rows) const {
    const Result<CopiedJson> copied = copiedJson();
    if (!copied) {
        source_->report(copied.error());
        return;
    }
    take(pastedOnto(block_, parametersOf(unlocked(rows)), *copied, *source_), tr("Paste values"));
}

void FormMenu::take(const PastedValues& pasted, const QString& label) const {
    if (!pasted.edits.isEmpty()) {
        source_->edit(pasted.edits, label);
        form_.refresh();
    }
    for (const Error& problem : pasted.problems) {
        source_->report(problem);
    }
}

void FormMenu::reset(const Rows& rows) const {
    ValueEdits edits;
    for (const ParameterRow* row : unlocked(rows)) {
        edits.values[row->parameter().id] = row->parameter().defaultValue;
    }
    source_->edit(edits, tr("Reset values"));
    form_.refresh();
}

void FormMenu::randomise(const Rows& rows) const {
    std::mt19937 random{std::random_device{}()};
    std::uniform_real_distribution<double> share(0.0, 1.0);
    ValueEdits edits;
    for (const ParameterRow* row : unlocked(rows)) {
        if (const auto value = randomValue(row->parameter(), [&] { return share(random); })) {
            edits.values[row->parameter().id] = *value;
        }
    }
    source_->edit(edits, tr("Randomise"));
    form_.refresh();
}

void FormMenu::setLocked(const Rows& rows, bool isLocked) const {
    source_->setLocked(idsOf(rows), isLocked);
}

FormMenu::Rows FormMenu::unlocked(const Rows& rows) const {
    Rows free = rows;
    std::erase_if(free, [](const ParameterRow* row) { return row->isLocked(); });
    return free;
}

} // namespace patina
