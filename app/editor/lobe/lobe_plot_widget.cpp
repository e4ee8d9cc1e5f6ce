// SPDX-License-Identifier: GPL-3.0-or-later
#include "lobe/lobe_plot_widget.h"

#include <cmath>

#include <QMouseEvent>
#include <QToolTip>
#include <QVBoxLayout>

#include "accuracy/plot_library.h"
#include "accuracy/plot_svg.h"
#include "core/color.h"
#include "lobe/lobe_subjects.h"
#include "text/as_text.h"
#include "text/display_number.h"
#include "text/png.h"

namespace patina {
namespace {

constexpr QSize plotFileSize{960, 600};
constexpr double plotFileScale = 2.0;
constexpr QSize minPlotSize{180, 120};
constexpr QSize usualLobeSize{480, 260};
constexpr QPointF legendPlace{0.02, 0.04}; ///< shares of the plot from its top left
constexpr double lineWidth = 1.6;

QPen penOf(const LobeLine& line, const QColor& color) {
    QColor own = color;
    if (line.isFromInside) {
        own.setAlphaF(0.6);
    }
    const bool isThin = line.stroke != LobeStroke::Main && line.stroke != LobeStroke::Extinction;
    QPen pen(own, isThin ? 1.0 : lineWidth);
    if (line.stroke != LobeStroke::Main) {
        pen.setStyle(line.stroke == LobeStroke::Along ? Qt::DotLine : Qt::DashLine);
    }
    return pen;
}

QString numberText(const LobeLine& line, double at) {
    const glm::dvec3 v = valueAt(line, at);
    if (isGrey(line)) {
        return line.digits > 0 ? numberLocale().toString(v.x, 'g', line.digits) : roundText(v.x);
    }
    return QStringLiteral("%1, %2, %3").arg(roundText(v.x), roundText(v.y), roundText(v.z));
}

} // namespace

LobePlotWidget::LobePlotWidget(QWidget* parent) : PlotWidget(parent), plot_(new QCustomPlot(this)) {
    plot_->setFocusPolicy(Qt::NoFocus);
    plot_->setMouseTracking(true);
    plot_->setMinimumSize(minPlotSize);
    plot_->installEventFilter(this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(1, 1, 1, 1); // leaves room for the focus frame
    layout->addWidget(plot_);
}

void LobePlotWidget::setSubjects(std::vector<LobeSubject> subjects) {
    subjects_ = std::move(subjects);
    draw();
}

void LobePlotWidget::setDetails(QStringList details) {
    details_ = std::move(details);
    draw();
}

std::vector<LobePlotWidget::Stroke> LobePlotWidget::strokes() const {
    std::vector<Stroke> all;
    const bool isAlone = subjects_.size() == 1;
    for (std::size_t i = 0; i < subjects_.size(); ++i) {
        for (const LobeLine& line : subjects_[i].lines.lines) {
            const bool hasChannels = isAlone && !isGrey(line);
            for (int channel = 0; channel < (hasChannels ? 3 : 1); ++channel) {
                const QColor color =
                    hasChannels ? channelColor(channel, palette()) : lobeColor(i, palette());
                Stroke stroke{line.at, {}, penOf(line, color), line.isShare, line.isSampled};
                stroke.values.reserve(line.values.size());
                for (const glm::dvec3& v : line.values) {
                    stroke.values.push_back(hasChannels ? v[channel] : luminance(v));
                }
                all.push_back(std::move(stroke));
            }
        }
    }
    return all;
}

QString LobePlotWidget::abscissaText(double at) const {
    return tr("%1° from the normal").arg(roundText(std::abs(at)));
}

QString LobePlotWidget::readingAt(const QPointF& place) const {
    const double at = abscissaAt(place);
    if (!std::isfinite(at)) {
        return {};
    }
    QStringList lines{abscissaText(at)};
    for (const LobeSubject& subject : subjects_) {
        for (const LobeLine& line : subject.lines.lines) {
            if (line.values.empty()) {
                continue;
            }
            QString reading = tr("%1, %2: %3 %4")
                                  .arg(asText(subject.name), asText(line.name),
                                       numberText(line, at), line.isShare ? QString() : unit())
                                  .trimmed();
            if (const auto passed = transmittedLine(line)) {
                const QString name = asText(passed->name).section(' ', -1);
                reading += tr(", %1: %2").arg(name, numberText(*passed, at));
            }
            lines << reading;
        }
    }
    return lines.size() > 1 ? lines.join('\n') : QString();
}

QSize LobePlotWidget::sizeHint() const {
    return usualLobeSize;
}

void LobePlotWidget::addLegend() {
    const bool isWanted = subjects_.size() > 1 || !details_.isEmpty();
    for (std::size_t i = 0; i < subjects_.size() && isWanted; ++i) {
        const QString detail = details_.value(static_cast<qsizetype>(i));
        auto* name = new QCPItemText(plot_);
        name->position->setType(QCPItemPosition::ptAxisRectRatio);
        name->position->setCoords(legendPlace);
        name->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
        // Names stand below each other: the lines above are empty.
        name->setText(QString(static_cast<qsizetype>(i), '\n') + asText(subjects_[i].name) +
                      (detail.isEmpty() ? QString() : QStringLiteral(", ") + detail));
        name->setTextAlignment(Qt::AlignLeft);
        name->setFont(plot_->font());
        name->setColor(lobeColor(i, palette()));
    }
}

bool LobePlotWidget::eventFilter(QObject* watched, QEvent* event) {
    if (watched == plot_ && event->type() == QEvent::MouseMove) {
        const auto* move = static_cast<QMouseEvent*>(event);
        const QPointF place = plot_->mapTo(this, move->position());
        QToolTip::showText(move->globalPosition().toPoint(), readingAt(place), this);
    }
    return false;
}

QByteArray LobePlotWidget::png() const {
    return asPng(
        plot_->toPixmap(plotFileSize.width(), plotFileSize.height(), plotFileScale).toImage());
}

QByteArray LobePlotWidget::svg() const {
    return plotSvg(*plot_, plotFileSize);
}

} // namespace patina
