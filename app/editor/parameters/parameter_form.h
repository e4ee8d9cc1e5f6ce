// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <QTimer>
#include <QWidget>

#include "catalog/block.h"
#include "catalog/expression.h"
#include "parameters/parameter_source.h"

class QLabel;
class QVBoxLayout;

namespace patina {

class FormMenu;
class FormTextures;
class ParameterRow;
class ParameterSection;

/// Says which rows a form shows.
enum class RowFilter {
    All,
    Active, ///< shows those that count at present
    Changed ///< shows those that are not at their default, and those with an image
};

/// Shows a block's parameters, one row each, lined up in sections and made from the descriptor
/// alone. It holds no values; it asks its source.
class ParameterForm : public QWidget {
    Q_OBJECT

  public:
    explicit ParameterForm(QWidget* parent = nullptr);
    ~ParameterForm() override;

    /// Shows the values of a source as the block describes them. Rows of parameters that stay the
    /// same are kept. Without a block `emptyText` is shown.
    void setBlock(const Block* block, std::unique_ptr<ParameterSource> source,
                  const QString& emptyText = {});

    /// Shows one value anew, or all of them.
    void refresh(std::string_view parameterId);
    void refresh();

    /// Returns the row of a parameter, or null.
    ParameterRow* row(std::string_view parameterId) const;
    std::vector<ParameterRow*> rows() const;
    /// Returns the rows of a group, in order.
    std::vector<ParameterRow*> rowsOf(std::string_view group) const;

    /// Sets which rows are shown; one that is in use stays until it is not.
    void setFilter(RowFilter filter);
    RowFilter filter() const { return filter_; }
    /// Returns what manages the images on the form's values.
    FormTextures& textures() const { return *textures_; }
    /// Returns what offers copying, resetting and the like in menus of the values.
    FormMenu& menu() const { return *menu_; }

    QSize minimumSizeHint() const override;

  protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

  private:
    using Rows = std::map<std::string, ParameterRow*, std::less<>>;

    /// Says when a row counts, and by which words: ids of parameters and of choices.
    struct Condition {
        Expression expression;
        std::vector<std::string> words;
    };

    ParameterRow* makeRow(const Parameter& parameter);
    void arrange(const std::vector<Parameter>& parameters);
    ParameterSection* section(const QString& title, bool isFolded);
    void clearSections();
    void readCondition(const ParameterRow& row);
    void updateDependents(const ParameterRow& changed);
    void updateCounting(ParameterRow& row);
    void present(ParameterRow& row);
    void followFilter();
    void applyFilter();
    bool passes(const ParameterRow& row) const;
    void alignLabels(bool mayWiden = true);
    int narrowestLabel() const;
    void orderTabs();

    FormTextures* textures_;
    FormMenu* menu_;
    std::unique_ptr<ParameterSource> source_;
    QTimer approach_; ///< runs out when the pointer or the keyboard rests on a row
    std::string approached_;
    RowFilter filter_ = RowFilter::All;
    const ParameterRow* interacting_ = nullptr;
    QString emptyText_; ///< is shown where there are no rows
    std::vector<Parameter> parameters_;
    Rows rows_;
    std::map<std::string, Condition, std::less<>> conditions_; ///< are keyed by their row's id
    std::vector<ParameterSection*> sections_;
    std::map<QString, bool> foldedSections_; ///< are remembered while models are swapped
    int labelWidth_ = 0;
    QLabel* empty_;
    QVBoxLayout* ungrouped_;
    QVBoxLayout* column_;
};

} // namespace patina
