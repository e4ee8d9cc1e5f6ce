// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QToolButton;
class QWidget;

namespace patina {

class CompareArea;
class Document;

/// Returns a button that sets the scene's exposure so that the picture of the active view becomes
/// middle grey, as one undo step.
QToolButton* autoExposureButton(Document& document, CompareArea& views, QWidget* parent);

} // namespace patina
