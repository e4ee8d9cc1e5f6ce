// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/texture_editor.h"

#include <QHBoxLayout>
#include <QLabel>

namespace patina {

TextureEditor::TextureEditor(const Parameter& parameter, QWidget* parent)
    : ParameterEditor(parameter, parent) {
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 2, 0, 2);
    auto* explanation = new QLabel(tr("Images are kept in the file but not shown yet."), this);
    explanation->setWordWrap(true);
    explanation->setEnabled(false);
    line->addWidget(explanation);
    setAccessibleName(name());
}

void TextureEditor::present(const Value&) {}

} // namespace patina
