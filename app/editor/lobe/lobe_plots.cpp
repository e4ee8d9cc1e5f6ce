// SPDX-License-Identifier: GPL-3.0-or-later
#include "lobe/lobe_plots.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <numbers>

#include <QFileInfo>
#include <QVBoxLayout>

#include "core/atomic_file.h"
#include "document/document.h"
#include "lobe/energy_bar.h"
#include "lobe/polar_plot.h"
#include "lobe/share_plot.h"
#include "lobe/slice_plot.h"
#include "lobe/solid_plot.h"
#include "text/as_text.h"

namespace patina {
namespace {

/// Returns a plot for each material, so that all keep their colours; one without an answer has its
/// name alone.
template <class Plot>
std::vector<Plot> plotsOf(const std::vector<SharedAnswer>& answers) {
    std::vector<Plot> plots;
    for (const SharedAnswer& each : answers) {
        const Plot* plot = each->plot ? std::get_if<Plot>(&*each->plot) : nullptr;
        plots.push_back(plot != nullptr ? *plot : Plot{each->material.name, {}});
    }
    return plots;
}

} // namespace

std::vector<DockPage> LobePlots::pages() {
    return {
        {tr("Lobe"), tr("Reflectance in the plane of incidence; drag to turn the light")},
        {tr("3D"), tr("Reflectance over all viewers; drag to turn it")},
        {tr("Albedo"), tr("What is reflected in all, over the angle of the light")},
        {tr("Fresnel"), tr("What the surface mirrors, by polarisation and side")},
        {tr("Spectrum"), tr("The index of refraction over the wavelength")},
        {tr("Half angle"), tr("A slice over half and difference angle")},
        {tr("Float32"), tr("How far the device is from double precision")},
        {tr("Float16"), tr("How far floats of 16 bits are from double precision")},
    };
}

LobePlots::LobePlots(const Document& document, QWidget* parent)
    : QTabWidget(parent), document_(document), polar_(new PolarPlot(this)),
      solid_(new SolidPlot(this)), albedo_(new SharePlot(LobePlot::Albedo, this)),
      fresnel_(new SharePlot(LobePlot::Fresnel, this)),
      spectrum_(new SharePlot(LobePlot::Spectrum, this)), slice_(new SlicePlot(this)),
      float32_(new SharePlot(LobePlot::Float32, this)),
      float16_(new SharePlot(LobePlot::Float16, this)), energy_(new EnergyBar(this)) {
    addPages();
    connect(polar_, &PolarPlot::lightTurned, this, &LobePlots::lightTurned);
}

void LobePlots::addPages() {
    auto* energy = new QWidget(this);
    auto* rows = new QVBoxLayout(energy);
    rows->setContentsMargins(0, 4, 0, 0);
    rows->addWidget(energy_);
    rows->addWidget(albedo_, 1);
    setDocumentMode(true);
    for (QWidget* page : std::initializer_list<QWidget*>{polar_, solid_, energy, fresnel_,
                                                         spectrum_, slice_, float32_, float16_}) {
        const DockPage words = pages().at(static_cast<std::size_t>(count()));
        setTabToolTip(addTab(page, words.title), words.what);
    }
}

LobePage LobePlots::page() const {
    return static_cast<LobePage>(std::max(currentIndex(), 0));
}

double LobePlots::light() const {
    return polar_->light();
}

void LobePlots::setPicked(const std::optional<PickedIncidence>& picked) {
    if (!picked) {
        polar_->setViewer(std::nullopt);
        solid_->setViewer(std::nullopt);
        return;
    }
    polar_->setLight(picked->incoming().angle * 180.0 / std::numbers::pi);
    polar_->setViewer(picked->viewerDegrees());
    solid_->setViewer(picked->viewer);
}

void LobePlots::setScale(LobeScale scale) {
    polar_->setScale(scale);
    solid_->setScale(scale);
    slice_->setScale(scale);
}

void LobePlots::setDetails(const QStringList& details) {
    for (LobePlotWidget* plot : findChildren<LobePlotWidget*>()) {
        plot->setDetails(details);
    }
    solid_->setDetails(details);
}

void LobePlots::showAnswers(const LobeQuestion& question,
                            const std::vector<SharedAnswer>& answers) {
    if (LobePlotWidget* plot = linePlot()) {
        if (question.page == LobePage::Albedo) {
            showEnergy(*answers.front(), answers.size() > 1);
        }
        plot->setSubjects(plotsOf<LobeSubject>(answers));
    } else if (question.page == LobePage::Solid) {
        solid_->setSolids(plotsOf<NamedSolid>(answers), question.lines.incoming);
    } else {
        slice_->setSlices(plotsOf<NamedSlice>(answers));
    }
}

void LobePlots::showEnergy(const LobeAnswer& answer, bool isOneOfSeveral) {
    energy_->setName(isOneOfSeveral ? asText(answer.material.name) : QString());
    if (!answer.plot) {
        energy_->setNothing(asText(answer.plot.error().problem));
        return;
    }
    const Block* model = document_.catalog().find(kinds::models, answer.material.material.model.id);
    const bool isIsotropic = model != nullptr && model->hasClaim("isotropic");
    std::vector<LobeLine> albedos{std::get<LobeSubject>(*answer.plot).lines.lines.front()};
    constexpr std::size_t enoughAngles = 8;
    if (answer.question.lines.isSketch &&
        (!isIsotropic || albedos.front().values.size() < enoughAngles)) {
        return; // it knows too few angles, or nothing of light from other azimuths
    }
    std::ranges::copy(answer.turned, std::back_inserter(albedos));
    std::erase_if(albedos, [](const LobeLine& line) { return line.values.size() < 2; });
    if (!albedos.empty()) {
        const bool areLuminances = isOneOfSeveral && !isGrey(albedos.front());
        energy_->setRange(energyRange(albedos),
                          areLuminances ? std::optional(luminanceRange(albedos)) : std::nullopt);
    } else {
        energy_->setNothing({});
    }
}

LobePlotWidget* LobePlots::linePlot() const {
    switch (page()) {
    case LobePage::Polar:
        return polar_;
    case LobePage::Albedo:
        return albedo_;
    case LobePage::Fresnel:
        return fresnel_;
    case LobePage::Spectrum:
        return spectrum_;
    case LobePage::Float32:
        return float32_;
    case LobePage::Float16:
        return float16_;
    default:
        return nullptr;
    }
}

PaintedPlot* LobePlots::paintedPlot() const {
    return page() == LobePage::Solid   ? static_cast<PaintedPlot*>(solid_)
           : page() == LobePage::Slice ? static_cast<PaintedPlot*>(slice_)
                                       : nullptr;
}

std::string LobePlots::csv() const {
    const LobePlotWidget* plot = linePlot();
    return plot != nullptr             ? linesCsv(plot->subjects(), linesOf(page()))
           : page() == LobePage::Solid ? solidsCsv(solid_->solids())
                                       : slicesCsv(slice_->slices());
}

Result<void> LobePlots::exportTo(const QString& file) const {
    const QString ending = QFileInfo(file).suffix().toLower();
    const auto bytesOf = [&ending](const auto& plot) {
        return (ending == "svg" ? plot.svg() : plot.png()).toStdString();
    };
    const LobePlotWidget* plot = linePlot();
    const std::string bytes = ending == "csv"   ? csv()
                              : plot != nullptr ? bytesOf(*plot)
                                                : bytesOf(*paintedPlot());
    return writeFileAtomically(file.toStdString(), bytes);
}

} // namespace patina
