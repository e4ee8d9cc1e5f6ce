// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/document_editor.h"

#include <memory>

#include "document/document.h"
#include "parameters/editor_factory.h"
#include "parameters/parameter_editor.h"

namespace patina {

ParameterEditor* makeDocumentEditor(Document& document, const ParameterTarget& target,
                                    QWidget* parent) {
    ParameterEditor* editor = makeEditor(*document.parameter(target), parent);
    const auto interaction = std::make_shared<int>(0);
    QObject::connect(
        editor, &ParameterEditor::interactionBegan, editor,
        [&document, target, interaction] { *interaction = document.interaction().begin(target); });
    QObject::connect(editor, &ParameterEditor::interactionEnded, editor,
                     [&document, interaction] { document.interaction().end(*interaction); });
    QObject::connect(editor, &ParameterEditor::edited, editor,
                     [&document, target](const Value& value) {
                         document.setValue(target.path, target.parameterId, value);
                     });
    return editor;
}

} // namespace patina
