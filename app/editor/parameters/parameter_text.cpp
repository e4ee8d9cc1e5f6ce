// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/parameter_text.h"

#include <algorithm>
#include <map>

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include "core/color.h"
#include "parameters/number_format.h"

namespace patina {

namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("patina::ParameterText", text);
}

QString text(const std::string& text) {
    return QString::fromStdString(text);
}

QString number(double value, const Parameter& parameter) {
    return text(shownNumber(value, parameter.decimals));
}

QString withUnit(const QString& shown, const Parameter& parameter) {
    return parameter.unit.empty() ? shown
                                  : shown + QLatin1Char(' ') + text(shownUnit(parameter.unit));
}

QString labelOfChoice(const Parameter& parameter, const std::string& id) {
    for (const EnumValue& value : parameter.values) {
        if (value.id == id) {
            return text(value.label);
        }
    }
    return text(id);
}

struct Shower {
    const Parameter& parameter;

    QString operator()(bool on) const { return on ? tr("on") : tr("off"); }
    QString operator()(int whole) const { return withUnit(QString::number(whole), parameter); }
    QString operator()(double value) const { return withUnit(number(value, parameter), parameter); }
    QString operator()(const std::string& id) const { return labelOfChoice(parameter, id); }
    QString operator()(const NumberList& list) const {
        const ParameterTypeInfo* info = infoOf(list);
        return info == nullptr ? QString() : text(info->summary(list));
    }
    QString operator()(const glm::dvec2& v) const {
        return withUnit(number(v.x, parameter) + ", " + number(v.y, parameter), parameter);
    }
    QString operator()(const glm::dvec3& v) const {
        if (infoOf(parameter.type).isColor) {
            return text(hexOf(v));
        }
        const QStringList numbers{number(v.x, parameter), number(v.y, parameter),
                                  number(v.z, parameter)};
        return withUnit(numbers.join(", "), parameter);
    }
};

/// Tells whether the tooltip of a type has a range, which the editor itself does not show.
bool tellsRange(ParameterType type) {
    const ParameterTypeInfo& info = infoOf(type);
    return info.hasRange && info.function == nullptr && !info.isColor;
}

QString paragraph(const QString& text) {
    return "<p>" + text + "</p>";
}

QString escaped(const std::string& plain) {
    return text(plain).toHtmlEscaped();
}

QString rangeText(const Parameter& parameter) {
    const auto span = [&](double from, double to) {
        return withUnit(number(from, parameter) + QStringLiteral(" \u2026 ") +
                            number(to, parameter),
                        parameter);
    };
    QString range = tr("Usual range %1").arg(span(parameter.softMin, parameter.softMax));
    if (parameter.min != parameter.softMin || parameter.max != parameter.softMax) {
        range += tr("; typing reaches %1").arg(span(parameter.min, parameter.max));
    }
    return range.toHtmlEscaped();
}

QString choicesText(const Parameter& parameter) {
    QString list;
    for (const EnumValue& value : parameter.values) {
        const QString doc = value.doc.empty() ? QString() : ": " + escaped(value.doc);
        list += "<li><b>" + escaped(value.label) + "</b>" + doc + "</li>";
    }
    return "<ul style='margin-left:-20px'>" + list + "</ul>";
}

const std::map<std::string, const char*, std::less<>>& signsInWords() {
    static const std::map<std::string, const char*, std::less<>> words{
        {"==", "is"},          {"!=", "is not"},  {">", "is above"},
        {">=", "is at least"}, {"<", "is below"}, {"<=", "is at most"},
        {"&&", "and"},         {"||", "or"},      {"!", "not"}};
    return words;
}

/// Returns a word of an expression as a person would say it: the label of a parameter, of a choice
/// of the parameter named before, or a sign in words.
QString inWords(const std::string& word, const Parameter*& named,
                std::span<const Parameter> siblings) {
    if (const auto sign = signsInWords().find(word); sign != signsInWords().end()) {
        return tr(sign->second);
    }
    const auto found = std::find_if(siblings.begin(), siblings.end(),
                                    [&](const Parameter& p) { return p.id == word; });
    if (found != siblings.end()) {
        named = &*found;
        return text(found->label);
    }
    return named ? labelOfChoice(*named, word) : text(word);
}

} // namespace

QString shownValue(const Parameter& parameter, const Value& value) {
    return std::visit(Shower{parameter}, value);
}

QString tooltipOf(const Parameter& parameter) {
    QString tip = "<b>" + escaped(parameter.label) + "</b>";
    tip += paragraph(escaped(parameter.doc));
    if (infoOf(parameter.type).isChoice) {
        tip += choicesText(parameter);
    }
    QStringList facts;
    if (tellsRange(parameter.type)) {
        facts << rangeText(parameter);
    }
    if (!infoOf(parameter.type).isFile) {
        facts
            << tr("Default %1").arg(shownValue(parameter, parameter.defaultValue)).toHtmlEscaped();
    }
    facts << tr("Name in files: %1").arg(text(parameter.id)).toHtmlEscaped();
    return tip + paragraph(facts.join("<br>"));
}

QString enabledReason(const Parameter& parameter, std::span<const Parameter> siblings) {
    static const QRegularExpression tokens(QStringLiteral("[\\w.-]+|[=!<>]=|&&|\\|\\||[<>!()]"));
    QStringList words;
    const Parameter* named = nullptr;
    auto matches = tokens.globalMatch(text(parameter.enabledWhen));
    while (matches.hasNext()) {
        words << inWords(matches.next().captured().toStdString(), named, siblings);
    }
    return words.join(QLatin1Char(' '));
}

QString physicalWarning(const Parameter& parameter, const Value& value) {
    if (!parameter.physical) {
        return {};
    }
    const auto outside = [&](double x) {
        return x < parameter.physical->min || x > parameter.physical->max;
    };
    bool warns = false;
    if (const double* number = std::get_if<double>(&value)) {
        warns = outside(static_cast<double>(static_cast<float>(*number)));
    } else if (const int* whole = std::get_if<int>(&value)) {
        warns = outside(*whole);
    } else if (const auto* triple = std::get_if<glm::dvec3>(&value)) {
        warns = outside(triple->x) || outside(triple->y) || outside(triple->z);
    }
    return warns ? text(parameter.physical->message) : QString();
}

} // namespace patina
