// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/accuracy_dock.h"

#include <memory>

#include <QToolButton>

#include "accuracy/accuracy_page.h"
#include "accuracy/cheaper_page.h"
#include "accuracy/match_page.h"
#include "accuracy/material_target.h"
#include "accuracy/measure_turn.h"
#include "accuracy/models_page.h"
#include "accuracy/picture_target.h"
#include "accuracy/scaling_page.h"
#include "docks/panel.h"

namespace patina {

AccuracyDock::AccuracyDock(const DockContext& context) {
    setDocumentMode(true);
    const auto turn = std::make_shared<MeasureTurn>();
    auto* material = new AccuracyPage(
        context,
        std::make_unique<MaterialTarget>(context.document, context.comparison, context.views),
        turn);
    auto* picture = new AccuracyPage(
        context,
        std::make_unique<PictureTarget>(context.document, context.comparison, context.views), turn);
    material->setObjectName("material");
    picture->setObjectName("picture");
    const auto add = [this](QWidget* page, const QString& title, const QString& what) {
        page->setWindowTitle(title);
        setTabToolTip(addTab(page, title), what);
    };
    add(material, tr("This Material"), tr("Every way to compute the material: time against error"));
    add(picture, tr("This Picture"), tr("Every way to draw the picture: time against error"));
    add(new ModelsPage(context, turn), tr("All Models"),
        tr("Every model on this scene: time, instructions, lost light"));
    add(new ScalingPage(context, turn), tr("Scaling"),
        tr("Time against pixels, lights and objects"));
    add(new MatchPage(context, turn), tr("Match"),
        tr("Values with which a model looks like another material or a measured surface"));
    auto* cheaper = new CheaperPage(context, turn);
    add(cheaper, tr("Cheaper Ways"),
        tr("Search for cheaper ways to compute a model or another block"));
    auto* find = textButton(tr("Find cheaper ways"),
                            tr("Search for cheaper ways to compute the model, also such as nobody "
                               "has declared"),
                            material);
    find->setObjectName("find");
    material->addButton(find);
    connect(find, &QToolButton::clicked, this, [this, cheaper] {
        setCurrentWidget(cheaper);
        cheaper->search();
    });
}

} // namespace patina
