// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/parameter_form.h"

#include <algorithm>

#include <QApplication>
#include <QEvent>
#include <QLabel>
#include <QResizeEvent>
#include <QToolButton>
#include <QVBoxLayout>

#include "parameters/form_menu.h"
#include "parameters/form_textures.h"
#include "parameters/parameter_row.h"
#include "parameters/parameter_section.h"
#include "parameters/parameter_text.h"

namespace patina {
namespace {

/// The pointer must rest on a row for so many milliseconds: it passes many on its way to one.
constexpr int restMs = 80;

} // namespace

ParameterForm::ParameterForm(QWidget* parent)
    : QWidget(parent), textures_(new FormTextures(this)), menu_(new FormMenu(*this)),
      empty_(new QLabel(this)), ungrouped_(new QVBoxLayout), column_(new QVBoxLayout(this)) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum); // forms stack without gaps
    column_->setContentsMargins(6, 4, 6, 4);
    column_->setSpacing(4);
    column_->addWidget(empty_);
    column_->addLayout(ungrouped_);
    column_->addStretch(1);
    ungrouped_->setSpacing(4);
    empty_->setWordWrap(true);
    empty_->hide();
    approach_.setSingleShot(true);
    approach_.setInterval(restMs);
    connect(qApp, &QApplication::focusChanged, this, &ParameterForm::followFilter);
    connect(&approach_, &QTimer::timeout, this, [this] {
        if (row(approached_)) {
            source_->prewarm(approached_);
        }
    });
}

/// Stops following the focus, which leaves the form's widgets while they are destroyed.
ParameterForm::~ParameterForm() {
    disconnect(qApp, nullptr, this, nullptr);
}

void ParameterForm::setBlock(const Block* block, std::unique_ptr<ParameterSource> source,
                             const QString& emptyText) {
    textures_->setSource(source.get());
    menu_->setSource(source.get(), block);
    source_ = std::move(source);
    const std::vector<Parameter> wanted = block ? block->parameters : std::vector<Parameter>();
    if (wanted != parameters_) {
        setUpdatesEnabled(false); // one repaint when everything is in place
        arrange(wanted);
        setUpdatesEnabled(true);
    }
    emptyText_ = wanted.empty() ? emptyText : QString();
    refresh();
}

void ParameterForm::arrange(const std::vector<Parameter>& parameters) {
    parameters_ = parameters;
    Rows former;
    std::swap(former, rows_);
    for (const auto& [id, row] : former) {
        row->setParent(this); // out of the sections, which go
    }
    clearSections();
    conditions_.clear();
    for (const Parameter& parameter : parameters_) {
        const auto kept = former.find(parameter.id);
        const bool fits = kept != former.end() && kept->second->parameter() == parameter;
        ParameterRow* row = fits ? kept->second : makeRow(parameter);
        if (fits) {
            former.erase(kept);
        }
        rows_.insert_or_assign(parameter.id, row);
        const QString group = QString::fromStdString(parameter.group);
        QVBoxLayout* place = parameter.advanced ? section(tr("Advanced"), true)->rows()
                             : group.isEmpty()  ? ungrouped_
                                                : section(group, false)->rows();
        place->addWidget(row);
        row->show();
        readCondition(*row);
    }
    for (const auto& [id, row] : former) {
        row->hide();
        row->deleteLater(); // it may be the sender of what brought us here
    }
    alignLabels();
    orderTabs();
}

ParameterRow* ParameterForm::makeRow(const Parameter& parameter) {
    auto* row = new ParameterRow(parameter, this);
    const auto token = std::make_shared<int>(0);
    connect(row, &ParameterRow::approached, this, [this, row] {
        approached_ = row->parameter().id;
        approach_.start();
    });
    connect(row, &ParameterRow::left, &approach_, &QTimer::stop);
    connect(row, &ParameterRow::interactionBegan, this, [this, token, row] {
        interacting_ = row;
        *token = source_->beginInteraction(row->parameter().id);
    });
    connect(row, &ParameterRow::interactionEnded, this, [this, token] {
        interacting_ = nullptr;
        if (*token != 0) {
            source_->endInteraction(std::exchange(*token, 0));
        }
        followFilter();
    });
    connect(row, &ParameterRow::edited, this, [this, row](const Value& value) {
        const std::string id = row->parameter().id;
        source_->setValue(id, value);
        refresh(id); // shows the value as it was accepted, even when nothing changed
    });
    textures_->attach(*row);
    menu_->attach(*row);
    return row;
}

ParameterSection* ParameterForm::section(const QString& title, bool isFolded) {
    for (ParameterSection* known : sections_) {
        if (known->title() == title) {
            return known;
        }
    }
    const bool folded = foldedSections_.try_emplace(title, isFolded).first->second;
    auto* made = new ParameterSection(title, folded, this);
    connect(made, &ParameterSection::folded, this,
            [this, title](bool isNowFolded) { foldedSections_[title] = isNowFolded; });
    menu_->attach(*made);
    const bool isLast = title == tr("Advanced");
    const bool endsInAdvanced = !sections_.empty() && sections_.back()->title() == tr("Advanced");
    const int end = column_->count() - 1; // before the stretch
    const bool goesBefore = endsInAdvanced && !isLast;
    column_->insertWidget(goesBefore ? end - 1 : end, made);
    made->show(); // at once, or it would come one frame late
    sections_.insert(goesBefore ? sections_.end() - 1 : sections_.end(), made);
    return made;
}

void ParameterForm::clearSections() {
    for (ParameterSection* old : sections_) {
        column_->removeWidget(old);
        old->hide();
        old->deleteLater();
    }
    sections_.clear();
}

void ParameterForm::present(ParameterRow& row) {
    row.present(source_->value(row.parameter()));
    textures_->present(row);
}

void ParameterForm::refresh(std::string_view parameterId) {
    if (ParameterRow* changed = row(parameterId)) {
        present(*changed);
        updateDependents(*changed);
        followFilter();
    }
}

void ParameterForm::refresh() {
    for (const auto& [id, row] : rows_) {
        present(*row);
        row->setLocked(source_->isLocked(id));
    }
    for (const auto& [id, row] : rows_) {
        updateCounting(*row);
    }
    applyFilter();
}

void ParameterForm::setFilter(RowFilter filter) {
    filter_ = filter;
    applyFilter();
}

/// Tells whether the filter shows a row. One that is dragged or has the focus stays, so that it
/// does not vanish in use.
bool ParameterForm::passes(const ParameterRow& row) const {
    const bool isInUse = &row == interacting_ || row.isAncestorOf(QApplication::focusWidget());
    return filter_ == RowFilter::All || (isInUse && !row.isHidden()) ||
           (filter_ == RowFilter::Active ? row.isCounting() : row.isChanged() || row.hasTexture());
}

/// Applies the filter again after a change, unless it shows all rows.
void ParameterForm::followFilter() {
    if (filter_ != RowFilter::All) {
        applyFilter();
    }
}

void ParameterForm::applyFilter() {
    bool isAnyShown = false;
    for (const auto& [id, row] : rows_) {
        row->setVisible(passes(*row));
        isAnyShown |= !row->isHidden();
    }
    for (ParameterSection* part : sections_) {
        part->setVisible(!std::ranges::all_of(part->parameterRows(), &QWidget::isHidden));
    }
    const QString filtered =
        filter_ == RowFilter::Changed ? tr("No value is changed.") : tr("No value is in use.");
    const QString text = rows_.empty() ? emptyText_ : isAnyShown ? QString() : filtered;
    empty_->setText(text);
    empty_->setVisible(!text.isEmpty());
}

/// A condition that does not parse is the descriptor's mistake, reported where it is read: the row
/// counts, because hiding by mistake is worse than showing.
void ParameterForm::readCondition(const ParameterRow& row) {
    const Parameter& parameter = row.parameter();
    Result<Expression> expression = Expression::parse(parameter.enabledWhen);
    if (parameter.enabledWhen.empty() || !expression) {
        return;
    }
    Condition condition{*expression, {}};
    for (const Expression::Comparison& comparison : expression->comparisons()) {
        condition.words.push_back(comparison.left);
        condition.words.push_back(comparison.right);
    }
    conditions_.insert_or_assign(parameter.id, std::move(condition));
}

void ParameterForm::updateDependents(const ParameterRow& changed) {
    const std::string& id = changed.parameter().id;
    for (const auto& [dependent, condition] : conditions_) {
        const std::vector<std::string>& words = condition.words;
        if (std::find(words.begin(), words.end(), id) != words.end()) {
            updateCounting(*rows_.at(dependent));
        }
    }
}

void ParameterForm::updateCounting(ParameterRow& row) {
    const auto found = conditions_.find(row.parameter().id);
    if (found == conditions_.end()) {
        return;
    }
    Values named;
    for (const std::string& word : found->second.words) {
        if (const ParameterRow* sibling = this->row(word)) {
            named.insert_or_assign(word, source_->value(sibling->parameter()));
        }
    }
    row.setCounting(found->second.expression.evaluate(named),
                    enabledReason(row.parameter(), parameters_));
}

ParameterRow* ParameterForm::row(std::string_view parameterId) const {
    const auto found = rows_.find(parameterId);
    return found == rows_.end() ? nullptr : found->second;
}

std::vector<ParameterRow*> ParameterForm::rows() const {
    std::vector<ParameterRow*> inOrder;
    for (const Parameter& parameter : parameters_) {
        inOrder.push_back(row(parameter.id));
    }
    return inOrder;
}

std::vector<ParameterRow*> ParameterForm::rowsOf(std::string_view group) const {
    std::vector<ParameterRow*> all = rows();
    std::erase_if(all,
                  [group](const ParameterRow* row) { return row->parameter().group != group; });
    return all;
}

int ParameterForm::narrowestLabel() const {
    return 12 * fontMetrics().averageCharWidth();
}

/// Gives all labels of the form one width: that of the longest, within limits, and less where the
/// rows would not fit beside it. Longer labels wrap. Unless it `mayWiden`, the width is at most
/// what it was.
void ParameterForm::alignLabels(bool mayWiden) {
    const int letter = fontMetrics().averageCharWidth();
    int wished = 14 * letter;
    int beside = 0;
    for (const auto& [id, row] : rows_) {
        wished = std::max(wished, row->labelWidthHint());
        beside = std::max(beside, row->widthBesideLabel());
    }
    const QMargins margins = column_->contentsMargins();
    const int room = width() - margins.left() - margins.right() - beside - 6 * letter;
    const int limit = mayWiden ? 26 * letter : labelWidth_;
    labelWidth_ = std::max(std::min({wished, limit, room}), narrowestLabel());
    for (const auto& [id, row] : rows_) {
        row->setLabelWidth(labelWidth_);
    }
}

/// Counts the labels at their narrowest, because they give way to the rows.
QSize ParameterForm::minimumSizeHint() const {
    const QSize least = QWidget::minimumSizeHint();
    return rows_.empty() ? least : least - QSize(labelWidth_ - narrowestLabel(), 0);
}

bool ParameterForm::event(QEvent* event) {
    if (event->type() == QEvent::LayoutRequest) {
        alignLabels(false); // a row may need more room now; one that needs less moves no other
    }
    return QWidget::event(event);
}

void ParameterForm::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (event->size().width() != event->oldSize().width()) {
        alignLabels();
    }
}

/// Tab goes down the form as it is seen, whatever the order in which rows were made.
void ParameterForm::orderTabs() {
    std::vector<QWidget*> chain;
    const auto append = [&chain](const ParameterRow& row) {
        const std::vector<QWidget*> inside = row.focusChain();
        chain.insert(chain.end(), inside.begin(), inside.end());
    };
    for (int i = 0; i < ungrouped_->count(); ++i) {
        append(*qobject_cast<ParameterRow*>(ungrouped_->itemAt(i)->widget()));
    }
    for (const ParameterSection* part : sections_) {
        chain.push_back(part->header());
        for (int i = 0; i < part->rows()->count(); ++i) {
            append(*qobject_cast<ParameterRow*>(part->rows()->itemAt(i)->widget()));
        }
    }
    for (std::size_t i = 1; i < chain.size(); ++i) {
        setTabOrder(chain[i - 1], chain[i]);
    }
}

void ParameterForm::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) {
        alignLabels();
    }
}

} // namespace patina
