// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "parameters/choice_box.h"

namespace patina {

/// A list of all blocks of one kind, with "Off" on top where there may be none. It shows what the
/// document has and asks for another one; it changes nothing itself.
class BlockChooser : public ChoiceBox {
    Q_OBJECT

  public:
    enum class Off { Offered, Absent };

    BlockChooser(Document& document, std::string_view kind, Off off, QWidget* parent = nullptr);

    /// Has words of its own for what there is without a block.
    BlockChooser(Document& document, std::string_view kind, const QString& off,
                 QWidget* parent = nullptr);

    /// The id of the block in use; empty for none.
    void show(const QString& id);

  Q_SIGNALS:
    void chosen(QString id);

  protected:
    Document& document() { return document_; }

    /// Lists all blocks, and shows the one in use.
    virtual void fill();

  private:
    Document& document_;
    std::string kind_;
    QString off_; ///< empty: there is no such choice
    QString shown_;
};

/// Returns what hovering over a block says: its summary and what it is good for.
QString blockToolTip(const Block& block);

} // namespace patina
