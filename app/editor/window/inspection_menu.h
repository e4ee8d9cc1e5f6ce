// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QMenu>

#include "render/surfaces/inspected_view.h"

class QActionGroup;

namespace patina {

class CompareArea;
class Document;

/// Offers what views show in place of the picture, one thing at a time, each lamp alone among them.
class InspectionMenu : public QMenu {
    Q_OBJECT

  public:
    /// `numbers` is the action of the numerical check, which stands elsewhere.
    InspectionMenu(QAction& numbers, Document& document, CompareArea& views,
                   QWidget* parent = nullptr);

  private:
    void addViews();
    void offer(QAction& action, const Inspected& shown);
    /// Lists the scene's lights as they are now.
    void fillLights();
    void followLights();
    std::optional<Inspected> chosen() const;

    Document& document_;
    CompareArea& views_;
    QActionGroup* one_;
    QMenu* lights_;
};

} // namespace patina
