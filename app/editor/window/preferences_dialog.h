// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

namespace patina {

class CompareArea;
class Session;
class Theme;

/// Shows what an artist sets once: the look, and how the mouse moves the views. Each choice applies
/// at once.
class PreferencesDialog : public QDialog {
    Q_OBJECT

  public:
    PreferencesDialog(Session& session, Theme& theme, CompareArea& views, QWidget* parent);
};

} // namespace patina
