// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/inspection_panel.h"

#include <algorithm>

#include <QLabel>
#include <QVBoxLayout>

namespace patina {
namespace {

constexpr QSize swatchSize{34, 16};

/// The panel counts further lights instead of listing them, so that it stays in the view.
constexpr std::size_t maxLights = 8;

struct Shades {
    QColor light;
    QColor dark;
};

/// Returns the colours of shaders/passes/inspection.frag.
Shades shadesOf(PixelDefect defect) {
    switch (defect) {
    case PixelDefect::NotANumber:
        return {QColor::fromRgbF(1.0f, 0.2f, 0.85f), QColor::fromRgbF(0.25f, 0.0f, 0.2f)};
    case PixelDefect::Infinite:
        return {QColor::fromRgbF(1.0f, 0.85f, 0.1f), QColor::fromRgbF(0.35f, 0.2f, 0.0f)};
    case PixelDefect::Negative:
        return {QColor::fromRgbF(0.25f, 0.6f, 1.0f), QColor::fromRgbF(0.0f, 0.05f, 0.35f)};
    default:
        return {QColor::fromRgbF(1.0f, 0.5f, 0.2f), QColor::fromRgbF(0.3f, 0.13f, 0.1f)};
    }
}

bool isLight(PixelDefect defect, int x, int y) {
    switch (defect) {
    case PixelDefect::NotANumber:
        return (x / 4 + y / 4) % 2 == 0;
    case PixelDefect::Infinite:
        return (x + y) % 8 < 4;
    case PixelDefect::Negative:
        return y % 6 < 3;
    default:
        return (x % 6 - 2.5) * (x % 6 - 2.5) + (y % 6 - 2.5) * (y % 6 - 2.5) < 3.6;
    }
}

QPixmap swatch(PixelDefect defect) {
    QImage image(swatchSize, QImage::Format_RGB32);
    const Shades shades = shadesOf(defect);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            image.setPixelColor(x, y, isLight(defect, x, y) ? shades.light : shades.dark);
        }
    }
    return QPixmap::fromImage(image);
}

QString number(float x) {
    return QString::number(static_cast<double>(x), 'g', 6);
}

QString titleOf(const Inspected& shown, const Scene& scene) {
    switch (shown.view) {
    case InspectedView::Energy:
        return InspectionPanel::tr(
            "Energy: the share of a white sky, red above 1.\n"
            "What is dark is absorbed by the colours, or lost by a rough highlight: most formulas\n"
            "follow light to the first facet that it meets and not to a second one.");
    case InspectedView::Normals:
        return InspectionPanel::tr("Normals: x, y, z as red, green, blue");
    case InspectedView::Tangents:
        return InspectionPanel::tr("Tangents: x, y, z as red, green, blue");
    case InspectedView::Diffuse:
        return InspectionPanel::tr("Diffuse light of the lamps; stripes: not told apart");
    case InspectedView::Highlight:
        return InspectionPanel::tr("Highlights of the lamps; stripes: not told apart");
    case InspectedView::Coordinates:
        return InspectionPanel::tr(
            "Texture coordinates: u, v as red, green, 8 × 8 squares; stripes: none");
    case InspectedView::Fresnel:
        return InspectionPanel::tr("Fresnel term at the viewer's angle; stripes: there is none");
    case InspectedView::Light:
        return InspectionPanel::tr("Light of %1 alone").arg(shownLightName(scene, shown.light));
    case InspectedView::Occlusion:
        return InspectionPanel::tr(
            "Occlusion: white sees all of its surroundings; stripes: not in this scene");
    case InspectedView::Glow:
        return InspectionPanel::tr("Glow: the surface's own light");
    case InspectedView::Opacity:
        return InspectionPanel::tr("Opacity: white hides all that is behind it");
    default:
        return {};
    }
}

QString row(const QString& name, const glm::vec3& value, const QString& detail = {}) {
    const auto cell = [](const QString& text) {
        return QStringLiteral("<td align='right'>&nbsp;&nbsp;%1</td>").arg(text);
    };
    return QStringLiteral("<tr><td>%1</td>%2%3%4<td>&nbsp;&nbsp;&nbsp;%5</td></tr>")
        .arg(name.toHtmlEscaped(), cell(number(value.x)), cell(number(value.y)),
             cell(number(value.z)), detail.toHtmlEscaped());
}

QString lightRows(const PixelProbe& probe, const Scene& scene) {
    QString text;
    const std::size_t shown = std::min(probe.lights.size(), maxLights);
    for (std::size_t i = 0; i < shown; ++i) {
        const LightShare& share = probe.lights[i];
        text += row(shownLightName(scene, share.light), share.value,
                    InspectionPanel::tr("n·l %1").arg(number(share.nl)));
    }
    if (shown < probe.lights.size()) {
        text += InspectionPanel::tr("<tr><td>and %1 more lights</td></tr>")
                    .arg(probe.lights.size() - shown);
    }
    return text;
}

} // namespace

QString shownLightName(const Scene& scene, std::size_t index) {
    const QString name =
        index < scene.lights.size() ? QString::fromStdString(scene.lights[index].name) : QString();
    return name.isEmpty() ? InspectionPanel::tr("Light %1").arg(index + 1) : name;
}

QString probeText(const PixelProbe& probe, const Scene& scene) {
    const auto tr = [](const char* text) { return InspectionPanel::tr(text); };
    QString text = row(tr("Normal"), probe.normal, tr("n·v %1").arg(number(probe.nv)));
    if (probe.albedo) {
        text += row(tr("Under a white sky"), *probe.albedo);
    }
    text += lightRows(probe, scene);
    if (probe.ambient) {
        text += row(tr("Ambient"), *probe.ambient);
    }
    if (probe.blended) {
        text += row(tr("After Fresnel"), probe.blended->value,
                    tr("reflects %1").arg(number(probe.blended->share)));
    }
    if (probe.emission) {
        text += row(tr("Glow"), *probe.emission);
    }
    if (probe.fogged) {
        text += row(tr("After fog"), probe.fogged->value,
                    tr("surface %1").arg(number(probe.fogged->share)));
    }
    text += row(tr("Colour"), probe.color, tr("opacity %1").arg(number(probe.opacity)));
    return QStringLiteral("<table cellspacing='0'>%1</table>").arg(text);
}

InspectionPanel::InspectionPanel(QWidget* parent)
    : QFrame(parent), legend_(new QWidget(this)), title_(new QLabel(this)),
      numbers_(new QLabel(this)) {
    setObjectName("inspection");
    setStyleSheet("#inspection { background: rgba(20, 20, 20, 215); border-radius: 5px; }"
                  "#inspection QLabel { color: #f0f0f0; background: transparent; }");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(10, 8, 10, 8);
    layout->setSpacing(3);
    auto* rows = new QVBoxLayout(legend_);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(3);
    title_->setObjectName("inspected");
    layout->addWidget(title_);
    layout->addWidget(legend_);
    rows->addWidget(legendRow(
        PixelDefect::NotANumber, tr("Not a number"),
        tr("The model, a light or a later term gives NaN here, before anything hides it.")));
    rows->addWidget(legendRow(PixelDefect::Infinite, tr("Infinite"),
                              tr("A value is beyond what a float can hold.")));
    rows->addWidget(legendRow(PixelDefect::Negative, tr("Negative"),
                              tr("Less than no light, before the picture cuts it at 0.")));
    rows->addWidget(legendRow(
        PixelDefect::AboveOne, tr("More light out than in"),
        tr("Under a uniform white sky this place would be brighter than the sky: its albedo "
           "towards the viewer is above 1. It is estimated from 1300 to 2700 directions of light "
           "and counts from 1.02 on. Light of its own is left out. Stylised models are so by "
           "design.")));
    numbers_->setObjectName("probe");
    numbers_->setTextFormat(Qt::RichText);
    numbers_->setToolTip(tr("Linear floats before exposure, as they were computed: each light's "
                            "share as the model returned it"));
    layout->addSpacing(4);
    layout->addWidget(numbers_);
    showNumbers(std::nullopt, Scene());
    explain(Inspected(), Scene());
}

void InspectionPanel::explain(const Inspected& shown, const Scene& scene) {
    legend_->setVisible(shown.view == InspectedView::Numbers);
    title_->setVisible(shown.view != InspectedView::Numbers);
    title_->setText(titleOf(shown, scene));
}

QWidget* InspectionPanel::legendRow(PixelDefect defect, const QString& text,
                                    const QString& toolTip) {
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* picture = new QLabel(row);
    picture->setPixmap(swatch(defect));
    layout->addWidget(picture);
    layout->addWidget(new QLabel(text, row), 1);
    row->setToolTip(toolTip);
    return row;
}

void InspectionPanel::showNumbers(const std::optional<PixelProbe>& probe, const Scene& scene) {
    numbers_->setText(probe ? probeText(*probe, scene)
                            : tr("Point at a surface to read its numbers."));
}

} // namespace patina
