// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/dock_list.h"

#include <QCoreApplication>

#include "accuracy/accuracy_dock.h"
#include "docks/effects_dock.h"
#include "docks/environment_dock.h"
#include "docks/fog_dock.h"
#include "docks/fresnel_dock.h"
#include "docks/histogram_dock.h"
#include "docks/lights_dock.h"
#include "docks/messages_dock.h"
#include "docks/model_dock.h"
#include "docks/opacity_dock.h"
#include "docks/parameters_dock.h"
#include "docks/presets_dock.h"
#include "docks/scene_dock.h"
#include "docks/shader_dock.h"
#include "docks/snapshots_dock.h"
#include "docks/stability_dock.h"
#include "lobe/lobe_dock.h"
#include "lobe/lobe_plots.h"
#include "sheets/sheets_dock.h"

namespace patina {
namespace {

template <class Widget>
QWidget* make(const DockContext& context) {
    return new Widget(context);
}

QString tr(const char* text) {
    return QCoreApplication::translate("Docks", text);
}

} // namespace

std::vector<DockEntry> dockList() {
    return {
        {"models", tr("Model"), DockPlace::LeftTop, make<ModelDock>},
        {"presets", tr("Presets"), DockPlace::LeftBottom, make<PresetsDock>,
         tr("library, materials")},
        {"snapshots", tr("Snapshots"), DockPlace::LeftBottom, make<SnapshotsDock>},
        {"parameters", tr("Parameters"), DockPlace::RightTop, make<ParametersDock>},
        {"fresnel", tr("Fresnel"), DockPlace::RightTop, make<FresnelDock>},
        {"opacity", tr("Surface"), DockPlace::RightTop, make<OpacityDock>,
         tr("opacity, transparency, refraction, glass, outline, normal and height maps")},
        {"lights", tr("Lights"), DockPlace::RightBottom, make<LightsDock>,
         tr("key light, shadows, solo")},
        {"environment", tr("Environment"), DockPlace::RightBottom, make<EnvironmentDock>,
         tr("sky, studio, panorama, HDR")},
        {"fog", tr("Fog"), DockPlace::RightBottom, make<FogDock>},
        {"scene", tr("Scene"), DockPlace::RightBottom, make<SceneDock>,
         tr("objects, camera, ground, background, ambient, occlusion, exposure, tone curve, "
            "picture passes"),
         SceneDock::pages()},
        {"messages", tr("Messages"), DockPlace::Bottom, make<MessagesDock>},
        {"stability", tr("Stability"), DockPlace::Bottom, make<StabilityDock>},
        {"effects", tr("Effects"), DockPlace::Bottom, make<EffectsDock>, tr("cost")},
        {"shader", tr("Shader"), DockPlace::Bottom, make<ShaderDock>,
         tr("GLSL, program, source, registers")},
        {"accuracy", tr("Accuracy"), DockPlace::Bottom, make<AccuracyDock>,
         tr("cost, error, predicted times"), AccuracyDock::pages()},
        {"lobe", tr("Lobe"), DockPlace::Bottom, make<LobeDock>, tr("reflectance, plots"),
         LobePlots::pages()},
        {"histogram", tr("Histogram"), DockPlace::Bottom, make<HistogramDock>},
        {"sheets", tr("Contact Sheet"), DockPlace::Bottom, make<SheetsDock>},
    };
}

} // namespace patina
