// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/ramp_editor.h"

#include <algorithm>

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/color.h"
#include "parameters/choice_box.h"
#include "parameters/color_editor.h"
#include "parameters/editor_factory.h"
#include "parameters/handle_area.h"
#include "parameters/number_box.h"
#include "parameters/popup_place.h"
#include "parameters/preview_button.h"

namespace patina {
namespace {

constexpr double stopHalf = 6.5;    // pixels; half the width of a stop
constexpr double stripMargin = 9.0; // keeps stops at the ends whole
constexpr double stopHeight = 19.0;
constexpr int stripWidth = 380;
constexpr int stripHeight = 66;

QColor shown(const glm::dvec3& linear) {
    const glm::dvec3 encoded = srgbEncoded(linear);
    return QColor::fromRgbF(static_cast<float>(encoded.x), static_cast<float>(encoded.y),
                            static_cast<float>(encoded.z));
}

/// Paints the colours as the screen shows them, two columns for each pixel.
void paintRamp(QPainter& painter, const QRectF& place, const Ramp& ramp) {
    QImage colors(std::max(1, static_cast<int>(2.0 * place.width())), 1, QImage::Format_RGB32);
    for (int i = 0; i < colors.width(); ++i) {
        colors.setPixelColor(i, 0, shown(ramp.at((i + 0.5) / colors.width())));
    }
    painter.drawImage(place, colors);
}

/// Shows a strip of the ramp's colours with the stops under it.
class RampStrip : public HandleArea {
  public:
    explicit RampStrip(QWidget* parent) : HandleArea({1, maxRampStops, minRampGap}, parent) {
        setMinimumSize(stripWidth, stripHeight);
        setMouseTracking(true);
        setCursor(Qt::CrossCursor);
    }

    void setRamp(const Ramp& ramp) {
        interpolation_ = ramp.interpolation;
        std::vector<Handle> handles;
        for (const RampStop& stop : ramp.stops) {
            handles.push_back({stop.at, 0.0, stop.color});
        }
        setHandles(handles);
    }

    Ramp ramp() const {
        Ramp ramp{interpolation_};
        for (const Handle& handle : handles()) {
            ramp.stops.push_back({handle.x, handle.color});
        }
        return ramp;
    }

    QPointF pixelOf(const Handle& handle) const override {
        const QRectF strip = colors();
        return {strip.left() + handle.x * strip.width(), strip.bottom() + 0.6 * stopHeight};
    }

  protected:
    Handle handleAt(const QPointF& pixel) const override {
        const double x = placeAt(pixel);
        return {x, 0.0, ramp().at(x)};
    }
    Handle dragged(const Handle& handle, const QPointF& pixel) const override {
        return {placeAt(pixel), 0.0, handle.color};
    }
    Handle stepped(const Handle& handle, double right, double) const override {
        return {handle.x + right, 0.0, handle.color};
    }

    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        paintRamp(painter, colors(), ramp());
        QColor edge = palette().color(hasFocus() ? QPalette::Highlight : QPalette::WindowText);
        edge.setAlphaF(hasFocus() ? 1.0F : 0.35F);
        painter.setPen(QPen(edge, 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(colors());
        for (std::size_t i = 0; i < handles().size(); ++i) {
            if (chosen() != i) {
                paintStop(painter, handles()[i], false);
            }
        }
        if (const auto top = chosen()) { // over those that it overlaps
            paintStop(painter, handles()[*top], true);
        }
    }

  private:
    QRectF colors() const {
        return QRectF(rect()).adjusted(stripMargin, 1.0, -stripMargin, -stopHeight - 3.0);
    }
    double placeAt(const QPointF& pixel) const {
        return std::clamp((pixel.x() - colors().left()) / colors().width(), 0.0, 1.0);
    }

    /// Paints a stop as a house whose roof points at its place.
    void paintStop(QPainter& painter, const Handle& handle, bool isChosen) const {
        const double x = pixelOf(handle).x();
        const double top = colors().bottom() + 1.0;
        const double bottom = top + stopHeight;
        const double eaves = top + stopHalf;
        const QPolygonF house{{QPointF(x, top), QPointF(x + stopHalf, eaves),
                               QPointF(x + stopHalf, bottom), QPointF(x - stopHalf, bottom),
                               QPointF(x - stopHalf, eaves)}};
        const QColor outline = palette().color(QPalette::Active, isChosen ? QPalette::Highlight
                                                                          : QPalette::WindowText);
        painter.setPen(QPen(outline, isChosen ? 2.5 : 1.2));
        painter.setBrush(shown(handle.color));
        painter.drawPolygon(house);
    }

    RampInterpolation interpolation_ = RampInterpolation::Linear;
};

/// Returns a parameter that describes the colour of one stop.
Parameter stopColor(const Parameter& ramp) {
    Parameter color = ramp;
    color.type = ParameterType::Color;
    color.label = RampEditor::tr("Colour of the stop").toStdString();
    color.defaultValue = glm::dvec3(0.0);
    color.compiled = Compiled::No;
    return color;
}

} // namespace

/// Edits a ramp live: stops under its colours, the chosen one's place and colour.
class RampPopup : public QFrame {
  public:
    explicit RampPopup(RampEditor* editor)
        : QFrame(editor, Qt::Popup), editor_(editor), strip_(new RampStrip(this)),
          place_(new NumberBox(3, {}, this)),
          color_(new ColorEditor(stopColor(editor->parameter()), this)),
          interpolation_(new ChoiceBox(this)),
          remove_(new QPushButton(RampEditor::tr("&Remove stop"), this)) {
        setObjectName("rampPopup");
        setFrameShape(QFrame::StyledPanel);
        setAccessibleName(RampEditor::tr("Ramp of %1").arg(editor->name()));
        auto* column = new QVBoxLayout(this);
        column->addLayout(header());
        column->addWidget(strip_);
        column->addLayout(stopLine());
        nameParts();
        connectParts();
    }

    void present(const Ramp& ramp) {
        strip_->setRamp(ramp);
        interpolation_->setCurrentIndex(static_cast<int>(ramp.interpolation));
        showChosen();
    }

    void open(const QWidget& anchor) {
        if (!strip_->chosen()) {
            strip_->choose(0);
        }
        openBeside(*this, anchor);
        strip_->setFocus();
    }

  private:
    QHBoxLayout* header() {
        auto* line = new QHBoxLayout;
        auto* label = new QLabel(editor_->name(), this);
        QFont bold = label->font();
        bold.setBold(true);
        label->setFont(bold);
        line->addWidget(label, 1);
        line->addWidget(new QLabel(RampEditor::tr("Between stops"), this));
        interpolation_->addItems(
            {RampEditor::tr("Linear"), RampEditor::tr("Smooth"), RampEditor::tr("Constant")});
        line->addWidget(interpolation_);
        return line;
    }

    QHBoxLayout* stopLine() {
        auto* line = new QHBoxLayout;
        line->addWidget(new QLabel(RampEditor::tr("Stop at"), this));
        line->addWidget(place_);
        line->addWidget(color_, 1);
        line->addWidget(remove_);
        return line;
    }

    void nameParts() {
        strip_->setAccessibleName(RampEditor::tr("Stops of %1").arg(editor_->name()));
        strip_->setToolTip(RampEditor::tr(
            "Click to add a stop, drag to move it, drag it out or press Delete to remove it; "
            "double "
            "click opens its colour. Arrows move the chosen stop (with Shift finely), Page Up and "
            "Page Down choose another."));
        place_->setAccessibleName(RampEditor::tr("Place of the chosen stop"));
        place_->setObjectName("stopPlace");
        interpolation_->setAccessibleName(RampEditor::tr("Colours between stops"));
        interpolation_->setObjectName("interpolation");
        remove_->setAutoDefault(false);
    }

    void connectParts() {
        QObject::connect(strip_, &HandleArea::interactionBegan, editor_,
                         &ParameterEditor::interactionBegan);
        QObject::connect(strip_, &HandleArea::interactionEnded, editor_,
                         &ParameterEditor::interactionEnded);
        QObject::connect(color_, &ParameterEditor::interactionBegan, editor_,
                         &ParameterEditor::interactionBegan);
        QObject::connect(color_, &ParameterEditor::interactionEnded, editor_,
                         &ParameterEditor::interactionEnded);
        QObject::connect(strip_, &HandleArea::changed, this, [this] { ask(strip_->ramp()); });
        QObject::connect(strip_, &HandleArea::chosenChanged, this, [this] { showChosen(); });
        QObject::connect(strip_, &HandleArea::activated, this, [this] { pickColor(); });
        QObject::connect(remove_, &QPushButton::clicked, strip_, &HandleArea::removeChosen);
        QObject::connect(place_, &NumberBox::typed, this, [this](double at) { movedTo(at); });
        QObject::connect(place_, &NumberBox::stepped, this, [this](double steps) {
            constexpr double size = 0.01;
            movedTo(place_->value() + size * steps);
        });
        QObject::connect(color_, &ParameterEditor::edited, this, [this](const Value& value) {
            const auto* color = std::get_if<glm::dvec3>(&value);
            if (const auto chosen = strip_->chosen(); chosen && color != nullptr) {
                strip_->replaceChosen({strip_->handles()[*chosen].x, 0.0, *color});
            }
        });
        QObject::connect(interpolation_, &QComboBox::activated, this, [this](int index) {
            Ramp ramp = strip_->ramp();
            ramp.interpolation = static_cast<RampInterpolation>(index);
            ask(ramp);
        });
    }

    void movedTo(double at) {
        if (const auto chosen = strip_->chosen()) {
            strip_->replaceChosen({at, 0.0, strip_->handles()[*chosen].color});
        }
    }

    void pickColor() {
        if (auto* swatch = qobject_cast<QAbstractButton*>(color_->focusTarget())) {
            swatch->click();
        }
    }

    void ask(const Ramp& ramp) { Q_EMIT editor_->edited(rampValue(ramp)); }

    void showChosen() {
        const auto chosen = strip_->chosen();
        place_->setEnabled(chosen.has_value());
        color_->setEnabled(chosen.has_value());
        remove_->setEnabled(chosen.has_value() && strip_->handles().size() > 1);
        if (chosen) {
            place_->setValue(strip_->handles()[*chosen].x);
            color_->present(strip_->handles()[*chosen].color);
        }
    }

    RampEditor* editor_;
    RampStrip* strip_;
    NumberBox* place_;
    ColorEditor* color_;
    ChoiceBox* interpolation_;
    QPushButton* remove_;
};

RampEditor::RampEditor(const Parameter& parameter, QWidget* parent)
    : ParameterEditor(parameter, parent),
      preview_(new PreviewButton(
          [this](QPainter& painter, const QRectF& place) { paintRamp(painter, place, ramp_); },
          this)) {
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(preview_, 1);
    preview_->setAccessibleName(name());
    connect(preview_, &QAbstractButton::clicked, this, &RampEditor::openPopup);
}

void RampEditor::present(const Value& value) {
    ramp_ = rampOf(value);
    preview_->update();
    if (popup_) {
        popup_->present(ramp_);
    }
}

void RampEditor::openPopup() {
    if (!popup_) {
        popup_ = new RampPopup(this);
    }
    popup_->present(ramp_);
    popup_->open(*preview_);
}

QWidget* RampEditor::focusTarget() {
    return preview_;
}

ParameterEditor* makeRampEditor(const Parameter& parameter, QWidget* parent) {
    return new RampEditor(parameter, parent);
}

} // namespace patina
