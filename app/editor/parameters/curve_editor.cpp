// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/curve_editor.h"

#include <algorithm>

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include "parameters/editor_factory.h"
#include "parameters/handle_area.h"
#include "parameters/number_box.h"
#include "parameters/popup_place.h"
#include "parameters/preview_button.h"

namespace patina {
namespace {

constexpr double pointRadius = 4.5;
constexpr double fieldMargin = 8.0; // keeps points at the edges whole
constexpr int fieldSide = 280;
constexpr int gridLines = 4;

QColor faint(const QPalette& palette, float share) {
    QColor color = palette.color(QPalette::WindowText);
    color.setAlphaF(share);
    return color;
}

/// Returns the line of the curve from the left edge of a rectangle to its right one, in half
/// pixels; empty where there are too few points.
QPolygonF curveLine(const CurvePoints& points, const Parameter& parameter, const QRectF& place) {
    QPolygonF line;
    if (points.size() < minCurvePoints) {
        return line;
    }
    const CurveShape shape(points);
    const double span = std::max(parameter.max - parameter.min, 1e-9);
    const int steps = std::max(2, static_cast<int>(2.0 * place.width()));
    for (int i = 0; i <= steps; ++i) {
        const double x = static_cast<double>(i) / steps;
        line << QPointF(place.left() + x * place.width(),
                        place.bottom() - (shape.at(x) - parameter.min) / span * place.height());
    }
    return line;
}

std::vector<Handle> handlesOf(const CurvePoints& points) {
    std::vector<Handle> handles;
    for (const glm::dvec2& point : points) {
        handles.push_back({point.x, point.y});
    }
    return handles;
}

CurvePoints pointsOf(const std::vector<Handle>& handles) {
    CurvePoints points;
    for (const Handle& handle : handles) {
        points.emplace_back(handle.x, handle.y);
    }
    return points;
}

/// Shows the square in which the points of a curve are dragged.
class CurveField : public HandleArea {
  public:
    CurveField(const Parameter& parameter, QWidget* parent)
        : HandleArea({minCurvePoints, maxCurvePoints, minCurveGap}, parent), parameter_(parameter) {
        setMinimumSize(fieldSide, fieldSide);
        setMouseTracking(true);
        setCursor(Qt::CrossCursor);
    }

    QPointF pixelOf(const Handle& handle) const override {
        const QRectF field = inner();
        return {field.left() + handle.x * field.width(),
                field.bottom() - (handle.y - parameter_.min) / span() * field.height()};
    }

  protected:
    Handle handleAt(const QPointF& pixel) const override {
        const QRectF field = inner();
        const double x = std::clamp((pixel.x() - field.left()) / field.width(), 0.0, 1.0);
        const double up = std::clamp((field.bottom() - pixel.y()) / field.height(), 0.0, 1.0);
        return {x, parameter_.min + up * span()};
    }
    Handle dragged(const Handle&, const QPointF& pixel) const override { return handleAt(pixel); }
    Handle stepped(const Handle& handle, double right, double up) const override {
        return {handle.x + right,
                std::clamp(handle.y + up * span(), parameter_.min, parameter_.max)};
    }

    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        const QRectF field = inner();
        painter.fillRect(field, palette().color(QPalette::Base));
        painter.setPen(faint(palette(), 0.12F));
        for (int i = 1; i < gridLines; ++i) {
            const double share = static_cast<double>(i) / gridLines;
            const double x = field.left() + share * field.width();
            const double y = field.top() + share * field.height();
            painter.drawLine(QPointF(x, field.top()), QPointF(x, field.bottom()));
            painter.drawLine(QPointF(field.left(), y), QPointF(field.right(), y));
        }
        painter.setRenderHint(QPainter::Antialiasing);
        painter.drawLine(field.bottomLeft(), field.topRight());
        painter.setPen(
            QPen(hasFocus() ? palette().color(QPalette::Highlight) : faint(palette(), 0.35F), 1.0));
        painter.drawRect(field);
        painter.setPen(QPen(palette().color(QPalette::WindowText), 1.8));
        painter.drawPolyline(curveLine(pointsOf(handles()), parameter_, field));
        paintPoints(painter);
    }

  private:
    double span() const { return std::max(parameter_.max - parameter_.min, 1e-9); }
    QRectF inner() const {
        return QRectF(rect()).adjusted(fieldMargin, fieldMargin, -fieldMargin, -fieldMargin);
    }

    void paintPoints(QPainter& painter) const {
        for (std::size_t i = 0; i < handles().size(); ++i) {
            const bool isChosen = chosen() == i;
            painter.setPen(QPen(palette().color(QPalette::WindowText), 1.5));
            painter.setBrush(
                palette().color(QPalette::Active, isChosen ? QPalette::Highlight : QPalette::Base));
            const double radius = isChosen ? pointRadius + 1.0 : pointRadius;
            painter.drawEllipse(pixelOf(handles()[i]), radius, radius);
        }
    }

    Parameter parameter_;
};

} // namespace

/// Edits a curve live: its points in a field, the chosen one as numbers, and preset curves.
class CurvePopup : public QFrame {
  public:
    CurvePopup(const Parameter& parameter, CurveEditor* editor)
        : QFrame(editor, Qt::Popup), editor_(editor), field_(new CurveField(parameter, this)),
          x_(new NumberBox(3, {}, this)), y_(new NumberBox(3, {}, this)),
          remove_(new QPushButton(CurveEditor::tr("&Remove point"), this)) {
        setObjectName("curvePopup");
        setFrameShape(QFrame::StyledPanel);
        setAccessibleName(CurveEditor::tr("Curve of %1").arg(editor->name()));
        auto* column = new QVBoxLayout(this);
        column->addWidget(heading());
        column->addWidget(field_);
        column->addLayout(numbers());
        column->addLayout(presets());
        nameParts();
        connectField();
    }

    void present(const CurvePoints& points) {
        field_->setHandles(handlesOf(points));
        showChosen();
    }

    void open(const QWidget& anchor) {
        openBeside(*this, anchor);
        field_->setFocus();
    }

  private:
    QLabel* heading() {
        auto* label = new QLabel(editor_->name(), this);
        QFont bold = label->font();
        bold.setBold(true);
        label->setFont(bold);
        return label;
    }

    QHBoxLayout* numbers() {
        auto* line = new QHBoxLayout;
        line->addWidget(new QLabel(CurveEditor::tr("Point"), this));
        line->addWidget(new QLabel("x", this));
        line->addWidget(x_, 1);
        line->addWidget(new QLabel("y", this));
        line->addWidget(y_, 1);
        line->addWidget(remove_);
        return line;
    }

    QHBoxLayout* presets() {
        auto* line = new QHBoxLayout;
        for (const CurvePreset& preset : curvePresets()) {
            auto* button = new QPushButton(
                QString::fromUtf8(preset.label.data(), qsizetype(preset.label.size())), this);
            button->setAutoDefault(false);
            button->setObjectName(QString::fromUtf8(preset.id.data(), qsizetype(preset.id.size())));
            QObject::connect(button, &QPushButton::clicked, this,
                             [this, points = preset.points] { ask(points); });
            line->addWidget(button);
        }
        return line;
    }

    void nameParts() {
        field_->setAccessibleName(CurveEditor::tr("Points of %1").arg(editor_->name()));
        field_->setToolTip(CurveEditor::tr(
            "Click to add a point, drag to move it, drag it out or press Delete to remove it. "
            "Arrows move the chosen point (with Shift finely), Page Up and Page Down choose "
            "another."));
        x_->setAccessibleName(CurveEditor::tr("x of the chosen point"));
        y_->setAccessibleName(CurveEditor::tr("y of the chosen point"));
        x_->setObjectName("pointX");
        y_->setObjectName("pointY");
        remove_->setAutoDefault(false);
    }

    void connectField() {
        QObject::connect(field_, &HandleArea::interactionBegan, editor_,
                         &ParameterEditor::interactionBegan);
        QObject::connect(field_, &HandleArea::interactionEnded, editor_,
                         &ParameterEditor::interactionEnded);
        QObject::connect(field_, &HandleArea::changed, this,
                         [this] { ask(pointsOf(field_->handles())); });
        QObject::connect(field_, &HandleArea::chosenChanged, this, [this] { showChosen(); });
        QObject::connect(field_, &HandleArea::activated, x_, [this] { x_->setFocus(); });
        QObject::connect(remove_, &QPushButton::clicked, field_, &HandleArea::removeChosen);
        QObject::connect(x_, &NumberBox::typed, this, [this](double x) { typed(x, std::nullopt); });
        QObject::connect(y_, &NumberBox::typed, this, [this](double y) { typed(std::nullopt, y); });
        QObject::connect(x_, &NumberBox::stepped, this, [this](double s) { step(s, 0.0); });
        QObject::connect(y_, &NumberBox::stepped, this, [this](double s) { step(0.0, s); });
    }

    void typed(std::optional<double> x, std::optional<double> y) {
        if (const auto chosen = field_->chosen()) {
            Handle wanted = field_->handles()[*chosen];
            wanted.x = x.value_or(wanted.x);
            const Parameter& parameter = editor_->parameter();
            wanted.y = std::clamp(y.value_or(wanted.y), parameter.min, parameter.max);
            field_->replaceChosen(wanted);
        }
    }

    void step(double right, double up) {
        if (const auto chosen = field_->chosen()) {
            const Handle& now = field_->handles()[*chosen];
            constexpr double size = 0.01;
            typed(now.x + size * right, now.y + size * up);
        }
    }

    void ask(const CurvePoints& points) { Q_EMIT editor_->edited(curveValue(points)); }

    void showChosen() {
        const auto chosen = field_->chosen();
        for (QWidget* part : {static_cast<QWidget*>(x_), static_cast<QWidget*>(y_)}) {
            part->setEnabled(chosen.has_value());
        }
        remove_->setEnabled(chosen.has_value() && field_->handles().size() > minCurvePoints);
        if (chosen) {
            x_->setValue(field_->handles()[*chosen].x);
            y_->setValue(field_->handles()[*chosen].y);
        }
    }

    CurveEditor* editor_;
    CurveField* field_;
    NumberBox* x_;
    NumberBox* y_;
    QPushButton* remove_;
};

CurveEditor::CurveEditor(const Parameter& parameter, QWidget* parent)
    : ParameterEditor(parameter, parent),
      preview_(new PreviewButton(
          [this](QPainter& painter, const QRectF& place) {
              painter.fillRect(place, palette().color(QPalette::Base));
              painter.setPen(QPen(palette().color(QPalette::WindowText), 1.5));
              painter.drawPolyline(
                  curveLine(points_, this->parameter(), place.adjusted(3.0, 3.0, -3.0, -3.0)));
          },
          this)) {
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(preview_, 1);
    preview_->setAccessibleName(name());
    connect(preview_, &QAbstractButton::clicked, this, &CurveEditor::openPopup);
}

void CurveEditor::present(const Value& value) {
    points_ = curvePoints(value);
    preview_->update();
    if (popup_) {
        popup_->present(points_);
    }
}

void CurveEditor::openPopup() {
    if (!popup_) {
        popup_ = new CurvePopup(parameter(), this);
    }
    popup_->present(points_);
    popup_->open(*preview_);
}

QWidget* CurveEditor::focusTarget() {
    return preview_;
}

ParameterEditor* makeCurveEditor(const Parameter& parameter, QWidget* parent) {
    return new CurveEditor(parameter, parent);
}

} // namespace patina
