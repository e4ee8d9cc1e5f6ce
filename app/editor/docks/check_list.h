// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QListWidget>

namespace patina {

/// A short list of named things that can be switched on and off, renamed in place and removed.
/// It shows what it is given and tells what the user did; it changes nothing itself.
class CheckList : public QListWidget {
    Q_OBJECT

  public:
    explicit CheckList(QWidget* parent = nullptr);

    struct Row {
        QString name;
        QString detail; ///< shown after the name, faintly; not part of it
        bool on = true;

        friend bool operator==(const Row&, const Row&) = default;
    };

    /// Shows rows, of which these are selected; where none is it is the current one.
    void setRows(const std::vector<Row>& rows, int current, std::vector<int> selected = {});

  Q_SIGNALS:
    void chosen(int row);
    /// Several may be selected: these, the last of which is the current one.
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
