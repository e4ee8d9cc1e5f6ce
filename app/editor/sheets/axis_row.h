// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <QWidget>

#include "sheet/sheet_offers.h"
#include "sheet/sheet_plan.h"

class QBoxLayout;
class QComboBox;
class QToolButton;

namespace patina {

class CheckMenu;
class NumberBox;

/// Chooses what one axis of a sheet goes through: a value from one number to another, or some of
/// what there is of a kind. In a narrow panel it takes two lines. It shows what it is given and
/// asks for changes; it changes nothing itself.
class AxisRow : public QWidget {
    Q_OBJECT

  public:
    enum class Direction { Right, Down };

    explicit AxisRow(Direction direction, QWidget* parent = nullptr);

    /// Says what an axis may be of, in which scene.
    struct Subject {
        const Scene& scene;
        std::size_t object = 0;
        const Catalog& catalog;
        const std::vector<AxisOffer>& offers;
    };

    /// Shows an axis, or that there is none (nothing), as only the one down allows.
    void show(const std::optional<SheetAxis>& axis, const Subject& subject);

  Q_SIGNALS:
    void wished(const std::optional<patina::SheetAxis>& axis);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void layOut();
    void connectParts();
    void fillChoices(const Subject& subject);
    void fillEntries(const Subject& subject);
    void fillMenu();
    void showEntries();
    void showRange();
    bool isChosen(const std::string& entry) const;
    void choose(int index);
    void wishRange(SheetRange range);
    void wishEntry(const std::string& entry, bool isOn);
    void wish(SheetAxis axis);

    Direction direction_;
    QComboBox* what_;
    QWidget* steps_; ///< holds the widgets below
    NumberBox* from_;
    NumberBox* to_;
    NumberBox* count_;
    QToolButton* entries_;
    CheckMenu* menu_;
    QBoxLayout* layout_;
    std::optional<SheetAxis> axis_;
    std::vector<AxisOffer> offers_;
    std::optional<Parameter> number_; ///< is the one that the axis is of
    std::vector<SheetStep> listed_;   ///< are the entries to choose from, where there is no range
};

} // namespace patina
