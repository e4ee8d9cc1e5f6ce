// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/view_links.h"

#include <QActionGroup>
#include <QHBoxLayout>
#include <QMenu>
#include <QWidgetAction>

#include "document/compare_edits.h"
#include "parameters/document_editor.h"
#include "parameters/parameter_editor.h"
#include "text/as_text.h"
#include "text/display_number.h"
#include "viewport/effect_switches.h"
#include "viewport/side_view.h"

namespace patina {
namespace {

constexpr int stopsWidth = 240; ///< pixels; the width of the slider and its box
constexpr int indent = 28;      ///< pixels that the slider stands to the right of its action's text

BlockPath ownPath(std::string_view kind, Side side) {
    BlockPath path = pathOf(kind, 0, side);
    path.isOfView = true;
    return path;
}

/// Returns stops with their sign, as in "+1" or "-0.5".
QString stopsText(double stops) {
    return (stops > 0.0 ? QStringLiteral("+") : QString()) + roundText(stops);
}

QAction* checkable(QMenu& menu, const QString& text, const QString& tip, const char* name) {
    QAction* action = menu.addAction(text);
    action->setCheckable(true);
    action->setToolTip(tip);
    action->setObjectName(name);
    return action;
}

} // namespace

ViewLinks::ViewLinks(Document& document, EffectSwitches& switches, Side side, QWidget* parent)
    : QToolButton(parent), document_(document), switches_(switches), side_(side),
      scenePath_(ownPath(settings::scene, side)),
      environmentPath_(ownPath(kinds::environment, side)) {
    auto* menu = new QMenu(this);
    menu->setToolTipsVisible(true);
    setObjectName("links");
    setMenu(menu);
    setPopupMode(InstantPopup);
    setAutoRaise(true);
    setAccessibleName(tr("Links of view %1").arg(letterOf(side)));
    makeExposure(*menu);
    makeEnvironment(*menu);
    makeEffects(*menu);
    menu->addSeparator();
    relink_ = menu->addAction(tr("&Link Again"));
    relink_->setToolTip(tr("Take exposure, environment and effects from the scene, as all views "
                           "that are linked"));
    relink_->setObjectName("relink");
    connect(relink_, &QAction::triggered, this,
            [this] { setOwnView(document_, side_, {}, tr("Link view %1").arg(letterOf(side_))); });
    // What panels show of the scene is what this view has.
    connect(menu, &QMenu::aboutToShow, this, [this] { document_.selection().setSide(side_); });
    onChange(document_, DocumentChange::Catalog, this, &ViewLinks::fillEnvironments);
    onChange(document_,
             DocumentChange::OwnView | DocumentChange::Comparing | DocumentChange::Scene |
                 DocumentChange::Value,
             this, &ViewLinks::follow);
    fillEnvironments();
    follow();
}

void ViewLinks::makeExposure(QMenu& menu) {
    exposure_ = checkable(menu, tr("E&xposure of Its Own"),
                          tr("Expose this view by other stops than the scene"), "ownExposure");
    connect(exposure_, &QAction::triggered, this, &ViewLinks::cutExposure);
    auto* row = new QWidget(&menu);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(indent, 0, 8, 4);
    stops_ = makeDocumentEditor(document_, {scenePath_, exposureSetting}, row);
    stops_->setMinimumWidth(stopsWidth);
    stops_->setToolTip(tr("Stops; each doubles the light"));
    stops_->setObjectName("ownStops");
    layout->addWidget(stops_);
    auto* action = new QWidgetAction(&menu);
    action->setDefaultWidget(row);
    menu.addAction(action);
}

void ViewLinks::makeEnvironment(QMenu& menu) {
    environment_ =
        checkable(menu, tr("En&vironment of Its Own"),
                  tr("Light this view by another environment than the scene. The Environment panel "
                     "then shows the values of the view that is being edited."),
                  "ownEnvironment");
    connect(environment_, &QAction::triggered, this, &ViewLinks::cutEnvironment);
    environments_ = menu.addMenu(tr("Its Environment"));
    kinds_ = new QActionGroup(this);
    connect(kinds_, &QActionGroup::triggered, this, [this](QAction* chosen) {
        document_.setBlock(environmentPath_, chosen->data().toString().toStdString());
    });
}

void ViewLinks::makeEffects(QMenu& menu) {
    effects_ =
        checkable(menu, tr("E&ffects of Its Own"),
                  tr("Switch effects off in this view alone. The Effects panel has the switches of "
                     "the view that is being edited."),
                  "ownEffects");
    connect(effects_, &QAction::triggered, this, &ViewLinks::cutEffects);
}

void ViewLinks::fillEnvironments() {
    environments_->clear();
    qDeleteAll(kinds_->actions());
    const auto add = [this](const QString& text, const std::string& id) {
        QAction* kind = environments_->addAction(text);
        kind->setCheckable(true);
        kind->setData(asText(id));
        kinds_->addAction(kind);
    };
    add(tr("Off"), {});
    for (const Block* block : document_.catalog().ofKind(kinds::environment)) {
        add(asText(block->label), block->id);
    }
    follow();
}

void ViewLinks::cutExposure(bool isOwn) {
    OwnView own = ownView(document_.state(), side_);
    own.exposure = isOwn ? std::optional(document_.scene().exposure) : std::nullopt;
    setOwnView(document_, side_, own, tr("Exposure of view %1").arg(letterOf(side_)));
}

void ViewLinks::cutEnvironment(bool isOwn) {
    OwnView own = ownView(document_.state(), side_);
    const BlockValues* ofScene = document_.scene().part(kinds::environment);
    own.hasEnvironment = isOwn;
    own.environment = isOwn && ofScene != nullptr ? std::optional(*ofScene) : std::nullopt;
    setOwnView(document_, side_, own, tr("Environment of view %1").arg(letterOf(side_)));
}

void ViewLinks::cutEffects(bool isOwn) {
    OwnView own = ownView(document_.state(), side_);
    own.switchedOff = isOwn ? std::optional(switches_.offOn(side_)) : std::nullopt;
    setOwnView(document_, side_, own, tr("Effects of view %1").arg(letterOf(side_)));
}

void ViewLinks::follow() {
    const OwnView& own = ownView(document_.state(), side_);
    exposure_->setChecked(own.exposure.has_value());
    environment_->setChecked(own.hasEnvironment);
    effects_->setChecked(own.switchedOff.has_value());
    relink_->setEnabled(!own.isLinked());
    stops_->setEnabled(own.exposure.has_value());
    stops_->present(document_.value(scenePath_, stops_->parameter()));
    environments_->setEnabled(own.hasEnvironment);
    for (QAction* kind : kinds_->actions()) {
        kind->setChecked(own.hasEnvironment &&
                         kind->data().toString() ==
                             asText(own.environment ? own.environment->id : std::string()));
    }
    const QStringList parts = ownParts(own);
    setText(parts.isEmpty()    ? tr("Linked")
            : parts.size() > 1 ? tr("%1 of its own").arg(parts.size())
                               : tr("Own %1").arg(parts.front()));
    setToolTip(parts.isEmpty()
                   ? tr("Exposure, environment and effects are the scene's. Cut a link here.")
                   : tr("Of its own: %1. All else is the scene's.").arg(parts.join(", ")));
}

QStringList ViewLinks::ownParts(const OwnView& own) const {
    QStringList parts;
    if (own.exposure) {
        parts << tr("exposure %1").arg(stopsText(*own.exposure));
    }
    if (own.hasEnvironment) {
        parts << tr("environment");
    }
    if (own.switchedOff) {
        parts << tr("effects");
    }
    return parts;
}

} // namespace patina
