// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/chart_export.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <QCoreApplication>
#include <QFileDialog>
#include <QOffscreenSurface>
#include <QOpenGLContext>

#include "accuracy/cost_text.h"
#include "accuracy/plot_library.h"
#include "accuracy/plot_svg.h"
#include "gl/driver.h"
#include "session/session.h"
#include "text/png.h"
#include "viewport/view_context.h"

namespace patina {
namespace {

constexpr QSize fileSize{960, 600};
constexpr double pngScale = 2.0;
constexpr double headingMargin = 12.0;
constexpr double markRadius = 8.0;    ///< pixels; covers a point and its ring
constexpr double longestName = 320.0; ///< pixels; a longer name has the names of its choices cut
/// Is the distance in pixels from a point to its name; a line leads to a name farther away.
constexpr double besideMark = 10.0;

/// Breaks a text into lines of at most `width` pixels.
QString wrapped(const QString& text, const QFontMetrics& metrics, int width) {
    QStringList lines{QString()};
    for (const QString& word : text.split(' ')) {
        const QString longer = lines.last().isEmpty() ? word : lines.last() + ' ' + word;
        if (metrics.horizontalAdvance(longer) <= width) {
            lines.last() = longer;
        } else {
            lines << word;
        }
    }
    return lines.join('\n');
}

void addLine(QCustomPlot& plot, int row, const QString& text, const QFont& font,
             const QColor& color) {
    const int width = fileSize.width() - static_cast<int>(2.0 * headingMargin);
    plot.plotLayout()->insertRow(row);
    auto* line = new QCPTextElement(&plot, wrapped(text, QFontMetrics(font), width), font);
    line->setTextColor(color);
    line->setTextFlags(Qt::AlignLeft | Qt::AlignVCenter);
    line->setMargins({static_cast<int>(headingMargin), 0, 0, 0});
    plot.plotLayout()->addElement(row, 0, line);
}

void addHeading(QCustomPlot& plot, const ChartHeading& heading, const QPalette& palette) {
    int row = 0;
    if (!heading.title.isEmpty()) {
        QFont bold = plot.font();
        bold.setBold(true);
        addLine(plot, row++, heading.title, bold, palette.color(QPalette::Text));
    }
    for (const QString& line : heading.lines) {
        addLine(plot, row++, line, plot.font(), palette.color(QPalette::PlaceholderText));
    }
}

/// Places names beside points so that they cover neither each other nor a point. A name without
/// room is left out.
class Names {
  public:
    Names(QCustomPlot& plot, const QPalette& palette)
        : plot_(plot), color_(palette.color(QPalette::Text)),
          lead_(palette.color(QPalette::PlaceholderText)), room_(plot.axisRect()->rect()) {}

    void addPoint(const QPointF& place) {
        const QPointF corner(markRadius, markRadius);
        taken_.emplace_back(place - corner, place + corner);
    }

    void addName(const QPointF& place, const std::vector<SettingPart>& parts,
                 const QString& whole) {
        const QFontMetricsF metrics(plot_.font());
        const QString text =
            parts.empty() ? whole : fittingSetting(parts, [&metrics](const QString& name) {
                return metrics.horizontalAdvance(name) <= longestName;
            });
        const QSizeF size(metrics.horizontalAdvance(text) + 2.0, metrics.height());
        for (const double distance : {besideMark, 18.0, 30.0, 46.0, 66.0, 90.0, 120.0}) {
            if (const std::optional<QRectF> free = freeAt(place, size, distance)) {
                draw(text, *free, place, distance);
                taken_.push_back(*free);
                return;
            }
        }
    }

  private:
    /// Returns a place for a name of that size at a distance (pixels) from its point; empty if each
    /// is taken.
    std::optional<QRectF> freeAt(const QPointF& place, const QSizeF& size, double distance) const {
        constexpr double diagonal = 0.7;
        const double along = diagonal * distance;
        const QPointF half(0.5 * size.width(), 0.5 * size.height());
        const QPointF corners[] = {
            {along, -along - size.height()},
            {along, along},
            {-half.x(), -distance - size.height()},
            {-half.x(), distance},
            {-along - size.width(), -along - size.height()},
            {-along - size.width(), along},
            {distance, -half.y()}, // crosses the point's interval, as does the next
            {-distance - size.width(), -half.y()},
        };
        for (const QPointF& corner : corners) {
            const QRectF name(place + corner, size);
            const bool isFree =
                room_.contains(name) && std::ranges::none_of(taken_, [&name](const QRectF& other) {
                    return other.intersects(name);
                });
            if (isFree) {
                return name;
            }
        }
        return std::nullopt;
    }

    void draw(const QString& text, const QRectF& name, const QPointF& place, double distance) {
        if (distance > besideMark) {
            auto* line = new QCPItemLine(&plot_);
            line->start->setType(QCPItemPosition::ptAbsolute);
            line->end->setType(QCPItemPosition::ptAbsolute);
            line->start->setCoords(place);
            line->end->setCoords({std::clamp(place.x(), name.left(), name.right()),
                                  std::clamp(place.y(), name.top(), name.bottom())});
            line->setPen(QPen(lead_, 0.7));
        }
        auto* item = new QCPItemText(&plot_);
        item->position->setType(QCPItemPosition::ptAbsolute);
        item->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
        item->position->setCoords(name.topLeft());
        item->setText(text);
        item->setFont(plot_.font());
        item->setColor(color_);
    }

    QCustomPlot& plot_;
    QColor color_;
    QColor lead_;
    QRectF room_;
    std::vector<QRectF> taken_;
};

/// Names the points on the front first, so that these names are nearest to their points.
void addNames(QCustomPlot& plot, const PlotMarks& marks, const PlotMarks::Content& content,
              const QPalette& palette) {
    const CostChart& chart = content.chart;
    Names names(plot, palette);
    for (const CostPoint& point : chart.points) {
        names.addPoint(marks.placeOf(point, chart));
    }
    std::vector<std::size_t> named = frontAndTies(chart.points);
    const auto current = static_cast<std::size_t>(content.current);
    if (content.current >= 0 && std::ranges::find(named, current) == named.end()) {
        named.push_back(current);
    }
    for (const std::size_t i : named) {
        const CostPoint& point = chart.points[i];
        names.addName(marks.placeOf(point, chart), settingParts(point, chart),
                      settingName(point, chart));
    }
}

/// Lays out a chart and its heading as they are drawn into files.
class ChartPicture {
  public:
    ChartPicture(const PlotMarks::Content& content, const ChartHeading& heading,
                 const QPalette& palette)
        : marks_(plot_) {
        plot_.setViewport({QPoint(), fileSize});
        addHeading(plot_, heading, palette);
        marks_.draw(content, palette);
        plot_.replot(QCustomPlot::rpImmediateRefresh); // places are known only after this
        addNames(plot_, marks_, content, palette);
    }

    QCustomPlot& plot() { return plot_; }

  private:
    QCustomPlot plot_;
    PlotMarks marks_;
};

} // namespace

QString askForChartFile(QWidget* parent, const QString& ending, const QString& name) {
    Session session;
    QFileDialog dialog(parent, QCoreApplication::translate("ChartExport", "Export the plot"),
                       session.folder("chart"),
                       QStringLiteral("%1 (*.%2)").arg(ending.toUpper(), ending));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(ending);
    dialog.selectFile(name + '.' + ending);
    if (dialog.exec() != QDialog::Accepted) {
        return {};
    }
    const QString file = dialog.selectedFiles().value(0);
    session.setFolderOf("chart", file);
    return file;
}

QByteArray chartPng(const PlotMarks::Content& content, const ChartHeading& heading,
                    const QPalette& palette) {
    ChartPicture picture(content, heading, palette);
    return asPng(picture.plot().toPixmap(fileSize.width(), fileSize.height(), pngScale).toImage());
}

QByteArray chartSvg(const PlotMarks::Content& content, const ChartHeading& heading,
                    const QPalette& palette) {
    ChartPicture picture(content, heading, palette);
    return plotSvg(picture.plot(), fileSize, heading.title, heading.lines.join(' '));
}

QString driverLine() {
    QOpenGLContext context;
    context.setFormat(ViewContext::format());
    QOffscreenSurface surface;
    surface.create();
    return context.create() && context.makeCurrent(&surface)
               ? QCoreApplication::translate("ChartExport", "OpenGL %1")
                     .arg(QString::fromStdString(gl::driverText()))
               : QString();
}

} // namespace patina
