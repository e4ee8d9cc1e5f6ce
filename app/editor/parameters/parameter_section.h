// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QWidget>

class QToolButton;
class QVBoxLayout;

namespace patina {

class ParameterRow;

/// Shows a heading that folds the rows below it.
class ParameterSection : public QWidget {
    Q_OBJECT

  public:
    ParameterSection(const QString& title, bool isFolded, QWidget* parent);

    const QString& title() const { return title_; }
    bool isFolded() const { return isFolded_; }
    void setFolded(bool isFolded);
    QToolButton* header() const { return header_; }
    QVBoxLayout* rows() const { return rows_; }
    std::vector<ParameterRow*> parameterRows() const;

  Q_SIGNALS:
    void folded(bool isFolded);
    void menuWished(const QPoint& place); ///< `place` is on the screen

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void showTitle();

    QString title_;
    bool isFolded_ = false;
    QToolButton* header_;
    QWidget* body_;
    QVBoxLayout* rows_;
};

} // namespace patina
