// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "parameters/choice_box.h"

namespace patina {

/// Lists all blocks of one kind, with "Off" on top where there may be none. It shows what it is
/// told and emits the artist's choice; it does not change the document.
class BlockChooser : public ChoiceBox {
    Q_OBJECT

  public:
    enum class Off { Offered, Absent };

    BlockChooser(Document& document, std::string_view kind, Off off, QWidget* parent = nullptr);

    /// Lists `off` in place of "Off"; an empty text leaves that entry out.
    BlockChooser(Document& document, std::string_view kind, const QString& off,
                 QWidget* parent = nullptr);

    /// Shows the block in use by its id; empty for none. A block that is not installed is added to
    /// the list.
    void show(const QString& id);

  Q_SIGNALS:
    void chosen(QString id);

  protected:
    Document& document() { return document_; }

    /// Lists all blocks, and shows the one in use. Runs again when the catalogue changes.
    virtual void fill();

  private:
    Document& document_;
    std::string kind_;
    QString off_; ///< is the text of the entry without a block; empty if there is no such entry
    QString shown_;
};

/// Returns the tool tip of a block as rich text: label, summary, uses and source.
QString blockToolTip(const Block& block);

} // namespace patina
