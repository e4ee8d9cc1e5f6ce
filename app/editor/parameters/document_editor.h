// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document_state.h"

class QWidget;

namespace patina {

class Document;
class ParameterEditor;

/// Returns an editor of one value of the document that stands outside of a form. What is done to it
/// in one go is one undo step. Whoever has it presents the value.
ParameterEditor* makeDocumentEditor(Document& document, const ParameterTarget& target,
                                    QWidget* parent);

} // namespace patina
