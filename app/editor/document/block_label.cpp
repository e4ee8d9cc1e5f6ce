// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/block_label.h"

#include <QCoreApplication>

namespace patina {
namespace {

QString text(std::string_view words) {
    return QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size()));
}

QString translated(const char* words) {
    return QCoreApplication::translate("BlockLabel", words);
}

} // namespace

QString blockLabel(std::string_view kind, const Block* block) {
    const BlockKind& row = *findKind(kind);
    if (!block) {
        return row.absent.empty() ? translated("%1 off").arg(text(row.label)) : text(row.absent);
    }
    const QString name = QString::fromStdString(block->label);
    return row.isInBlockLabels ? name : translated("%1 %2").arg(text(row.label), name);
}

} // namespace patina
