// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QObject>

#include "parameters/copied_values.h"

class QMenu;
class QPoint;

namespace patina {

class ParameterForm;
class ParameterRow;
class ParameterSection;

/// Offers what can be done to a value of a form, to a group of them or to all, by menus and keys:
/// copy, paste, reset, random values, locks.
class FormMenu : public QObject {
    Q_OBJECT

  public:
    explicit FormMenu(ParameterForm& form);

    /// Sets whose values the form shows, and the block that they belong to.
    void setSource(ParameterSource* source, const Block* block);

    void attach(ParameterRow& row);
    void attach(ParameterSection& section);

    void copy(const std::vector<ParameterRow*>& rows) const;
    /// Paste what was copied: onto one value any value of its type, or a text that is one; onto
    /// several those of the same names that are not locked.
    void paste(ParameterRow& row) const;
    void paste(const std::vector<ParameterRow*>& rows) const;
    void reset(const std::vector<ParameterRow*>& rows) const;
    void randomise(const std::vector<ParameterRow*>& rows) const;
    void setLocked(const std::vector<ParameterRow*>& rows, bool isLocked) const;

  private:
    using Rows = std::vector<ParameterRow*>;

    void showMenuOf(ParameterRow& row, const QPoint& place);
    void showMenuOf(const ParameterSection& section, const QPoint& place);
    void addGroupActions(QMenu& menu, const Rows& rows);
    void take(const PastedValues& pasted, const QString& label) const;
    Rows unlocked(const Rows& rows) const;

    ParameterForm& form_;
    ParameterSource* source_ = nullptr;
    NamedBlock block_;
    bool isOfKind_ = false; ///< says that it is a block, not settings that every scene has
};

} // namespace patina
