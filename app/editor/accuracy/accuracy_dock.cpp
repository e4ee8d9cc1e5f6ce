// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/accuracy_dock.h"

#include <initializer_list>
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

std::vector<DockPage> AccuracyDock::pages() {
    return {
        {tr("This Material"), tr("Every way to compute the material: time against error")},
        {tr("This Picture"), tr("Every way to draw the picture: time against error")},
        {tr("All Models"), tr("Every model on this scene: time, instructions, lost light")},
        {tr("Scaling"), tr("Time against pixels, lights and objects")},
        {tr("Match"),
         tr("Values with which a model looks like another material or a measured surface")},
        {tr("Cheaper Ways"),
         tr("Find cheaper ways to compute a model or another block, by a search")},
    };
}

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
    auto* cheaper = new CheaperPage(context, turn);
    for (QWidget* page : std::initializer_list<QWidget*>{
             material, picture, new ModelsPage(context, turn), new ScalingPage(context, turn),
             new MatchPage(context, turn), cheaper}) {
        const DockPage words = pages().at(static_cast<std::size_t>(count()));
        page->setWindowTitle(words.title);
        setTabToolTip(addTab(page, words.title), words.what);
    }
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
