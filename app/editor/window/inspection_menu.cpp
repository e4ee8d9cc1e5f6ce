// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/inspection_menu.h"

#include <QActionGroup>

#include "document/document.h"
#include "viewport/compare_area.h"
#include "viewport/inspection_panel.h"

namespace patina {

InspectionMenu::InspectionMenu(QAction& numbers, Document& document, CompareArea& views,
                               QWidget* parent)
    : QMenu(tr("Show &in Place of the Picture"), parent), document_(document), views_(views),
      one_(new QActionGroup(this)), lights_(nullptr) {
    setToolTipsVisible(true);
    one_->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    offer(numbers, InspectedView::Numbers);
    addViews();
    lights_ = addMenu(tr("One &Light Alone"));
    lights_->setObjectName("show light");
    connect(lights_, &QMenu::aboutToShow, this, &InspectionMenu::fillLights);
    onChange(document, DocumentChange::Lights | DocumentChange::Scene, this,
             &InspectionMenu::followLights);
}

void InspectionMenu::addViews() {
    const struct {
        const char* name;
        QString text;
        QString key;
        QString toolTip;
        InspectedView shown;
    } rows[] = {
        {"show energy", tr("&Energy"), "Shift+E",
         tr("What each place sends back of a white sky, red where that is more than arrives"),
         InspectedView::Energy},
        {"show normals",
         tr("&Normals"),
         {},
         tr("The normals that are shaded with"),
         InspectedView::Normals},
        {"show tangents",
         tr("&Tangents"),
         {},
         tr("The direction of a grain"),
         InspectedView::Tangents},
        {"show coordinates",
         tr("Texture &Coordinates"),
         {},
         tr("Where images lie: u as red and v as green, over a checker that shows how they "
            "stretch"),
         InspectedView::Coordinates},
        {"show fresnel",
         tr("&Fresnel Term"),
         {},
         tr("The share that the Fresnel term reflects at the viewer's angle"),
         InspectedView::Fresnel},
        {"show diffuse",
         tr("&Diffuse Term"),
         {},
         tr("The lamps' light without the highlight"),
         InspectedView::Diffuse},
        {"show highlight",
         tr("&Highlight"),
         {},
         tr("The lamps' light in the highlight alone"),
         InspectedView::Highlight},
        {"show occlusion",
         tr("&Occlusion"),
         {},
         tr("How much of its surroundings each place sees past its own object: dark in grooves"),
         InspectedView::Occlusion},
        {"show glow",
         tr("&Glow"),
         {},
         tr("The light that the surface sends out by itself"),
         InspectedView::Glow},
        {"show opacity",
         tr("O&pacity"),
         {},
         tr("How much of what is behind it the surface hides: white hides everything"),
         InspectedView::Opacity},
    };
    for (const auto& row : rows) {
        auto* action = new QAction(row.text, this);
        action->setObjectName(row.name);
        action->setToolTip(row.toolTip);
        action->setShortcut(QKeySequence(row.key));
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        views_.addAction(action); // first, or the whole window would have its key
        addAction(action);
        offer(*action, row.shown);
    }
}

void InspectionMenu::offer(QAction& action, const Inspected& shown) {
    action.setCheckable(true);
    action.setData(
        QVariantList{static_cast<int>(shown.view), static_cast<qulonglong>(shown.light)});
    action.setChecked(views_.inspected() == shown);
    one_->addAction(&action);
    connect(&action, &QAction::toggled, this, [this] { views_.setInspected(chosen()); });
}

std::optional<Inspected> InspectionMenu::chosen() const {
    const QAction* checked = one_->checkedAction();
    if (checked == nullptr) {
        return std::nullopt;
    }
    const QVariantList shown = checked->data().toList();
    return Inspected(static_cast<InspectedView>(shown[0].toInt()), shown[1].toULongLong());
}

void InspectionMenu::fillLights() {
    lights_->clear();
    const Scene& scene = document_.scene(document_.selection().side());
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        QString name = shownLightName(scene, i);
        // A single & would underline the letter after it.
        auto* action = new QAction(name.replace('&', QLatin1String("&&")), lights_);
        action->setEnabled(scene.lights[i].enabled);
        lights_->addAction(action);
        offer(*action, {InspectedView::Light, i});
    }
    if (lights_->isEmpty()) {
        lights_->addAction(tr("No lights"))->setEnabled(false);
    }
}

/// The shown light has another name now, or is gone.
void InspectionMenu::followLights() {
    const std::optional<Inspected> shown = views_.inspected();
    if (!shown || shown->view != InspectedView::Light) {
        return;
    }
    const bool isThere = shown->light < document_.scene(Side::A).lights.size();
    views_.setInspected(isThere ? shown : std::nullopt);
    fillLights();
}

} // namespace patina
