// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/block_chooser.h"

#include <QSignalBlocker>

namespace patina {

BlockChooser::BlockChooser(Document& document, std::string_view kind, Off off, QWidget* parent)
    : BlockChooser(document, kind, off == Off::Offered ? tr("Off") : QString(), parent) {}

BlockChooser::BlockChooser(Document& document, std::string_view kind, const QString& off,
                           QWidget* parent)
    : ChoiceBox(parent), document_(document), kind_(kind), off_(off) {
    connect(this, &QComboBox::activated, this,
            [this](int index) { Q_EMIT chosen(itemData(index).toString()); });
    onChange(document, DocumentChange::Catalog, this, [this] { fill(); });
    fill();
}

void BlockChooser::show(const QString& id) {
    shown_ = id;
    const QSignalBlocker quiet(this);
    int index = findData(id);
    if (index < 0 && !id.isEmpty()) {
        addItem(tr("%1 (not installed)").arg(id), id);
        index = count() - 1;
    }
    setCurrentIndex(index);
}

void BlockChooser::fill() {
    const QSignalBlocker quiet(this);
    clear();
    if (!off_.isEmpty()) {
        addItem(off_, QString());
    }
    for (const Block* block : document_.catalog().ofKind(kind_)) {
        addItem(QString::fromStdString(block->label), QString::fromStdString(block->id));
        setItemData(count() - 1, blockToolTip(*block), Qt::ToolTipRole);
    }
    show(shown_);
}

QString blockToolTip(const Block& block) {
    const QString summary = QString::fromStdString(block.summary).toHtmlEscaped();
    const QString uses = QString::fromStdString(block.applications).toHtmlEscaped();
    const QString source = QString::fromStdString(block.source).toHtmlEscaped();
    QString tip = QStringLiteral("<p><b>%1</b></p><p>%2</p>")
                      .arg(QString::fromStdString(block.label).toHtmlEscaped(), summary);
    if (!uses.isEmpty()) {
        tip +=
            QStringLiteral("<p>") + QObject::tr("Good for: %1").arg(uses) + QStringLiteral("</p>");
    }
    return source.isEmpty() ? tip : tip + QStringLiteral("<p><i>%1</i></p>").arg(source);
}

} // namespace patina
