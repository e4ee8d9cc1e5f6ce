// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolButton>

#include "document/document.h"

class QActionGroup;
class QMenu;

namespace patina {

class EffectSwitches;
class ParameterEditor;

/// Says which parts of the scene a view has of its own. Its menu cuts a link with the scene and
/// restores it, and changes what is the view's own.
class ViewLinks : public QToolButton {
    Q_OBJECT

  public:
    ViewLinks(Document& document, EffectSwitches& switches, Side side, QWidget* parent = nullptr);

  private:
    void makeExposure(QMenu& menu);
    void makeEnvironment(QMenu& menu);
    void makeEffects(QMenu& menu);
    void fillEnvironments();
    void cutExposure(bool isOwn);
    void cutEnvironment(bool isOwn);
    void cutEffects(bool isOwn);
    void follow();
    QStringList ownParts(const OwnView& own) const;

    Document& document_;
    EffectSwitches& switches_;
    Side side_;
    BlockPath scenePath_;       ///< leads to the scene settings that are the view's own
    BlockPath environmentPath_; ///< leads to the environment that is the view's own
    QAction* exposure_;
    QAction* environment_;
    QAction* effects_;
    QAction* relink_;
    ParameterEditor* stops_;
    QMenu* environments_;
    QActionGroup* kinds_; ///< holds the actions of the environments' menu
};

} // namespace patina
