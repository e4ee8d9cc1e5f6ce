// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QListWidget>

namespace patina {

/// Is a short list of named things that can be switched on and off, renamed in place and removed.
/// It shows the rows it is given and emits what the artist does; it changes nothing else.
class CheckList : public QListWidget {
    Q_OBJECT

  public:
    explicit CheckList(QWidget* parent = nullptr);

    struct Row {
        QString name;
        QString detail; ///< is shown as the tool tip
        bool on = true;

        friend bool operator==(const Row&, const Row&) = default;
    };

    /// Shows rows and selects those in `selected`; where that is empty it selects the current one
    /// (-1: none).
    void setRows(const std::vector<Row>& rows, int current, std::vector<int> selected = {});

  Q_SIGNALS:
    void chosen(int row);
    /// Is emitted with all selected rows, the current one last.
    void selected(const std::vector<int>& rows);
    void switched(int row, bool on);
    void renamed(int row, QString name);
    void removeWished(int row);
    void duplicateWished();

  protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    QSize sizeHint() const override;

  private:
    void tellSelected();

    std::vector<Row> rows_;
};

} // namespace patina
