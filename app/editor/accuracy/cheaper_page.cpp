// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/cheaper_page.h"

#include <algorithm>
#include <utility>

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPlainTextEdit>
#include <QSignalBlocker>
#include <QSplitter>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "accuracy/bound_box.h"
#include "accuracy/measure_bar.h"
#include "accuracy/number_row.h"
#include "catalog/json_text.h"
#include "core/text.h"
#include "docks/family_chooser.h"
#include "docks/panel.h"
#include "document/document.h"
#include "material/blocks_in_use.h"
#include "material/model_swap.h"
#include "measure/approximation/approximation_subject.h"
#include "session/message_log.h"
#include "text/as_text.h"
#include "text/display_number.h"

namespace patina {
namespace {

enum WayColumn { WayWords, WayCost, WayShare, WayTime, WayOff, WayMean, WayFrame, WayColumns };
constexpr int wayRole = Qt::UserRole;
constexpr double usualGreatestError = 0.25;
constexpr std::pair<const char*, int> searchTimes[] = {
    {QT_TRANSLATE_NOOP("CheaperPage", "30 s"), 30},
    {QT_TRANSLATE_NOOP("CheaperPage", "2 min"), 120},
    {QT_TRANSLATE_NOOP("CheaperPage", "10 min"), 600}};
constexpr int usualSearchTime = 1;

QPlainTextEdit* readOnlyText(const QString& name, QWidget* parent) {
    auto* view = new QPlainTextEdit(parent);
    view->setReadOnly(true);
    view->setLineWrapMode(QPlainTextEdit::NoWrap);
    view->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    view->setFrameShape(QFrame::NoFrame);
    view->setAccessibleName(name);
    view->setTabChangesFocus(true);
    return view;
}

void nameWayColumns(QTreeWidget& list) {
    list.setHeaderLabels({CheaperPage::tr("What is done"), CheaperPage::tr("Cost"),
                          CheaperPage::tr("Of exact"), CheaperPage::tr("Time here"),
                          CheaperPage::tr("At most off"), CheaperPage::tr("Mean"),
                          CheaperPage::tr("On screen")});
    QTreeWidgetItem& head = *list.headerItem();
    head.setToolTip(WayCost, CheaperPage::tr("Predicted for the chosen graphics cards"));
    head.setToolTip(WayShare, CheaperPage::tr("Cost beside that of the exact way"));
    head.setToolTip(WayTime, CheaperPage::tr("Measured time of what is on screen, beside that of "
                                             "the material as it is"));
    head.setToolTip(WayFrame, CheaperPage::tr("Error that 99 of 100 pixels of what is on screen "
                                              "keep, over the light there"));
    head.setToolTip(WayOff, CheaperPage::tr("Largest error in any channel, as a share of white"));
    head.setToolTip(WayMean, CheaperPage::tr("Mean of the errors, as a share of white"));
}

/// Returns an error as a share of white; what is far below what a screen shows has no digits.
QString errorText(double error) {
    constexpr double minTold = 1e-5;
    return error > 0.0 && error < minTold ? CheaperPage::tr("< %1").arg(shareText(minTold))
                                          : shareText(error);
}

/// Gives a row the height that its words need in as many lines as the column's width makes of them.
class WrappedWordsDelegate : public QStyledItemDelegate {
  public:
    explicit WrappedWordsDelegate(QTreeWidget& list) : QStyledItemDelegate(&list), list_(list) {}

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        QStyleOptionViewItem wrapped = option;
        wrapped.rect = QRect(0, 0, list_.columnWidth(index.column()), 1);
        return QStyledItemDelegate::sizeHint(wrapped, index);
    }

  private:
    QTreeWidget& list_;
};

void wrapWords(QTreeWidget& list) {
    list.setWordWrap(true);
    list.setItemDelegateForColumn(WayWords, new WrappedWordsDelegate(list));
    QObject::connect(list.header(), &QHeaderView::sectionResized, &list, [&list](int column) {
        if (column == WayWords) {
            list.doItemsLayout();
        }
    });
}

/// Returns the measured time as a share of that of the material as it is, where it can be told from
/// that.
QString measuredTimeText(const ChoiceCost& cost) {
    const bool isTold = cost.isSure() && (cost.ratio.upper < 1.0 || cost.ratio.lower > 1.0);
    return cost.belowNoise || !isTold ? CheaperPage::tr("in the noise")
                                      : CheaperPage::tr("%1 %").arg(numberLocale().toString(
                                            100.0 * cost.ratio.median, 'f', 0));
}

QString framePairsText(const ChoiceCost& cost) {
    const auto number = [](double share) { return numberLocale().toString(100.0 * share, 'f', 0); };
    return CheaperPage::tr("%1 % (%2 to %3 %) by %4 pairs of frames")
        .arg(number(cost.ratio.median), number(cost.ratio.lower), number(cost.ratio.upper),
             wholeText(static_cast<std::size_t>(cost.runs)));
}

/// Leaves only what decides which program a block is: choices that are compiled.
void keepCompiled(Values& values, const Block* block) {
    std::erase_if(values, [block](const auto& value) {
        const Parameter* parameter = block != nullptr ? block->parameter(value.first) : nullptr;
        return parameter == nullptr || parameter->compiled == Compiled::No;
    });
}

} // namespace

CheaperPage::CheaperPage(const DockContext& context, std::shared_ptr<MeasureTurn> turn)
    : MeasurePage(context, std::move(turn),
                  tr("Search for cheaper ways to compute the chosen block, for its values or for "
                     "all that sliders reach"),
                  {"glsl", "json"}),
      blocks_(new QComboBox(this)), forValues_(new QCheckBox(tr("For these values only"), this)),
      maxError_(new BoundBox(BoundBox::Of::Share, usualGreatestError, this)),
      time_(new QComboBox(this)), family_(new FamilyChooser(this)), list_(new QTreeWidget(this)),
      texts_(new QTabWidget(this)), glsl_(readOnlyText(tr("GLSL of the found ways"), this)),
      entry_(readOnlyText(tr("Entry of the descriptor"), this)), notes_(hintLabel(this)),
      copy_(textButton(tr("Copy"), tr("Copy the text that is shown"), this)),
      save_(textButton(tr("Save as my block"),
                       tr("Write the block with these ways into your folder of blocks, under a "
                          "new name"),
                       this)),
      use_(textButton(tr("Use it"), tr("Give the material the selected way; saves the block first"),
                      this)),
      messages_(context.messages) {
    bar().setStartText(tr("Find cheaper ways"));
    bar().giveTwoLines();
    nameWayColumns(*list_);
    list_->setAccessibleName(tr("Cheaper ways"));
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(false); // a line for each thing that a way does
    list_->setFrameShape(QFrame::NoFrame);
    list_->setAlternatingRowColors(true);
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(WayWords, QHeaderView::Stretch);
    wrapWords(*list_);
    fitColumns(*list_, WayCost);
    notes_->setObjectName("notes");
    notes_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* parts = new QSplitter(this);
    parts->setChildrenCollapsible(false);
    parts->addWidget(list_);
    parts->addWidget(makeTexts());
    parts->setStretchFactor(0, 1);
    parts->setStretchFactor(1, 0);
    rows().addWidget(makeControls());
    rows().addWidget(parts, 1);
    rows().addWidget(notes_);
    connect(list_, &QTreeWidget::currentItemChanged, this, [this] {
        showTexts();
        showButtons();
    });
    connect(list_, &QTreeWidget::itemActivated, this, &CheaperPage::use);
    connect(copy_, &QToolButton::clicked, this, &CheaperPage::copy);
    connect(save_, &QToolButton::clicked, this, &CheaperPage::save);
    connect(use_, &QToolButton::clicked, this, &CheaperPage::use);
    onChange(document(),
             DocumentChange::Material | DocumentChange::Current | DocumentChange::Catalog |
                 DocumentChange::Comparing,
             this, [this] {
                 listBlocks();
                 if (wanted_) { // an edit has to wait until all have heard of the change
                     QTimer::singleShot(0, this, [this] { takeWanted(); });
                 }
             });
    listBlocks();
    refresh();
}

QWidget* CheaperPage::makeControls() {
    blocks_->setObjectName("block");
    blocks_->setAccessibleName(tr("Block to search"));
    blocks_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    forValues_->setObjectName("for values");
    forValues_->setToolTip(tr("Find ways that hold for the values that the material has now, as "
                              "numbers in the text; else for all that sliders reach"));
    maxError_->setAccessibleName(tr("Greatest error"));
    maxError_->setToolTip(tr("Ways that are farther off are left out: 1/255, 0.25, 10 %"));
    time_->setAccessibleName(tr("How long to search"));
    time_->setToolTip(tr("About how long to search"));
    for (const auto& [text, seconds] : searchTimes) {
        time_->addItem(tr(text), seconds);
    }
    time_->setCurrentIndex(usualSearchTime);
    const auto again = [this] { refresh(); };
    connect(blocks_, &QComboBox::currentIndexChanged, this, again);
    connect(forValues_, &QCheckBox::toggled, this, again);
    auto* row = new QWidget(this);
    auto* widgets = new QHBoxLayout(row);
    widgets->setContentsMargins(0, 0, 0, 0);
    widgets->setSpacing(6);
    widgets->addWidget(new QLabel(tr("Of"), row));
    widgets->addWidget(blocks_);
    widgets->addWidget(forValues_);
    widgets->addWidget(new QLabel(tr("at most"), row));
    widgets->addWidget(maxError_);
    widgets->addWidget(new QLabel(tr("off, in"), row));
    widgets->addWidget(time_);
    widgets->addStretch(1);
    widgets->addWidget(family_);
    return row;
}

QWidget* CheaperPage::makeTexts() {
    texts_->setDocumentMode(true);
    texts_->addTab(glsl_, tr("GLSL"));
    texts_->addTab(entry_, tr("Descriptor"));
    auto* side = new QWidget(this);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addWidget(texts_, 1);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    for (QToolButton* button : {copy_, save_, use_}) {
        buttons->addWidget(button);
    }
    column->addLayout(buttons);
    return side;
}

/// Lists the blocks of the material that can be searched, its model first.
void CheaperPage::listBlocks() {
    const QVariant kept = blocks_->currentData();
    const QSignalBlocker blocker(blocks_);
    blocks_->clear();
    const Material* material = document().material(document().selection().side());
    if (material != nullptr) {
        for (const Block* block : blocksInUse(*material, document().catalog())) {
            if (!evaluatedFunctions(*block).empty()) {
                blocks_->addItem(asText(block->label), asText(block->kind));
            }
        }
    }
    blocks_->setCurrentIndex(std::max(blocks_->findData(kept), blocks_->count() > 0 ? 0 : -1));
    blocks_->setEnabled(blocks_->count() > 0);
    // An image drives a value in place of the number that would stand in the text.
    forValues_->setEnabled(material != nullptr && material->textures.empty());
}

bool CheaperPage::isForValues() const {
    return forValues_->isEnabled() && forValues_->isChecked();
}

const Block* CheaperPage::chosenBlock() const {
    const Material* material = document().material(document().selection().side());
    const std::string kind = blocks_->currentData().toString().toStdString();
    if (material == nullptr || kind.empty()) {
        return nullptr;
    }
    for (const Block* block : blocksInUse(*material, document().catalog())) {
        if (block->kind == kind) {
            return block;
        }
    }
    return nullptr;
}

/// Returns the current material with what the search depends on.
Material CheaperPage::searchedMaterial() const {
    const Material* material = document().material(document().selection().side());
    Material searched;
    if (material == nullptr) {
        return searched;
    }
    searched.model = material->model;
    searched.parts = material->parts;
    if (!isForValues()) {
        const Catalog& catalog = document().catalog();
        keepCompiled(searched.model.parameters, catalog.find(kinds::models, searched.model.id));
        for (auto& [kind, part] : searched.parts) {
            keepCompiled(part.parameters, catalog.find(kind, part.id));
        }
    }
    return searched;
}

Checked<EvalCase> CheaperPage::subjectCase() const {
    return caseInMaterial(document().catalog(), searchedMaterial(), *chosenBlock());
}

void CheaperPage::search() {
    CheaperSearchOptions options;
    options.seconds = time_->currentData().toDouble();
    options.maxError = maxError_->value();
    search(std::move(options));
}

void CheaperPage::search(CheaperSearchOptions options) {
    const Block* block = chosenBlock();
    if (!canStart() || block == nullptr) {
        return;
    }
    auto made = subjectCase();
    if (!made) {
        for (const Error& error : made.error()) {
            messages_.add(error);
        }
        return;
    }
    options.family = &family_->family();
    options.ofValues = isForValues();
    WaysWish wish{
        document().sharedCatalog(), std::move(*made), std::move(options), {}, costSubject()};
    for (const BlockRoot& root : wish.catalog->roots) {
        if (!root.shipped) {
            wish.folder = root.folder;
        }
    }
    isEnough_ = std::make_shared<std::atomic<bool>>(false);
    const auto taken = [this](const FoundWays& found) { take(found, methodText(found)); };
    start([wish = std::move(wish), enough = isEnough_, taken](Worker::Control& control) {
        return findWays(wish, *enough, control, taken);
    });
}

/// Lets the search check what it has found. A second time it ends at once.
void CheaperPage::stopMeasuring() {
    if (isEnough_ == nullptr || isEnough_->exchange(true)) {
        MeasurePage::stopMeasuring();
    }
}

/// The scene's name says which block of the material is searched.
MeasuredSubject CheaperPage::subject() const {
    Scene scene;
    scene.objects.emplace_back().material = searchedMaterial();
    MeasuredSubject subject =
        subjectOf(std::move(scene), document().selection().object(), document().catalog());
    subject.scene.name =
        blocks_->currentData().toString().toStdString() + (isForValues() ? " of values" : "");
    return subject;
}

void CheaperPage::fillList(bool stale) {
    const QSignalBlocker blocker(list_);
    const int kept = selectedWay();
    list_->clear();
    const CheaperWays& ways = found().ways;
    for (std::size_t i = 0; i < ways.ways.size(); ++i) {
        const CheaperWay& way = ways.ways[i];
        auto* row = new NumberRow;
        const QString words =
            asText(capitalised(wordsOf(way))).split(QStringLiteral("; ")).join('\n');
        row->setText(WayWords, words);
        row->setData(WayWords, wayRole, static_cast<int>(i));
        row->setToolTip(WayWords, words);
        row->setNumber(WayCost, numberLocale().toString(way.cost, 'f', 0), way.cost);
        const double share = 100.0 * way.cost / ways.exact.cost;
        row->setNumber(WayShare, tr("%1 %").arg(numberLocale().toString(share, 'f', 0)), share);
        row->setNumber(WayOff, errorText(statedError(way)), statedError(way));
        row->setNumber(WayMean, errorText(way.meanError), way.meanError);
        if (found().inFrame) {
            const WayInFrame& drawn = found().inFrame->ways[i];
            row->setNumber(WayTime, measuredTimeText(drawn.cost), drawn.cost.ratio.median);
            row->setToolTip(WayTime, framePairsText(drawn.cost));
            row->setNumber(WayFrame, errorText(drawn.error.p99), drawn.error.p99);
        }
        for (int column = 0; stale && column < WayColumns; ++column) {
            row->setForeground(column, palette().placeholderText());
        }
        list_->addTopLevelItem(row);
        if (static_cast<int>(i) == kept) {
            list_->setCurrentItem(row);
        }
    }
    if (list_->currentItem() == nullptr && list_->topLevelItemCount() > 0) {
        list_->setCurrentItem(list_->topLevelItem(0));
    }
    list_->headerItem()->setToolTip(
        WayCost, ways.unit.empty()
                     ? tr("Predicted for the chosen graphics cards")
                     : tr("%1; exact: %2").arg(asText(ways.unit)).arg(ways.exact.cost));
    widenColumns(*list_, WayCost);
}

int CheaperPage::selectedWay() const {
    const QTreeWidgetItem* row = list_->currentItem();
    return row != nullptr ? row->data(WayWords, wayRole).toInt() : -1;
}

void CheaperPage::showNumbers(bool stale) {
    fillList(stale);
    QStringList notes;
    for (const Error& note : found().ways.notes) {
        notes << asText(note.text());
    }
    notes_->setText(notes.join('\n'));
    notes_->setVisible(!notes.isEmpty());
    showTexts();
    showButtons();
}

/// Shows the text that would be saved, at the function of the selected way.
void CheaperPage::showTexts() {
    const QString glsl = found().ways.ways.empty() ? QString() : asText(found().block.glsl);
    if (glsl_->toPlainText() != glsl) {
        glsl_->setPlainText(glsl);
        entry_->setPlainText(found().ways.ways.empty() ? QString() : entryText(found()));
    }
    QTextCursor at = glsl_->document()->find(QStringLiteral("Found%1(").arg(selectedWay() + 1));
    if (!at.isNull()) {
        at.movePosition(QTextCursor::StartOfLine);
        glsl_->setTextCursor(at);
        glsl_->centerCursor();
    }
}

void CheaperPage::showButtons() {
    const bool isThere = !found().ways.ways.empty();
    const bool canSave = isThere && found().isChecked && !found().wish.folder.empty();
    copy_->setEnabled(isThere);
    save_->setEnabled(canSave && !isSaved());
    use_->setEnabled(canSave && selectedWay() >= 0);
}

bool CheaperPage::isSaved() const {
    return found().ways.text != nullptr && found().ways.text == savedText_;
}

void CheaperPage::copy() {
    QApplication::clipboard()->setText(
        (texts_->currentWidget() == entry_ ? entry_ : glsl_)->toPlainText());
}

void CheaperPage::save() {
    if (isSaved()) {
        return;
    }
    const auto id = savedWays(found(), document().catalog());
    if (!id) {
        messages_.add(id.error());
        return;
    }
    savedText_ = found().ways.text;
    savedId_ = *id;
    refresh();
}

void CheaperPage::use() {
    const int way = selectedWay();
    if (way < 0 || !use_->isEnabled()) {
        return;
    }
    save();
    if (isSaved()) {
        const Block& block = *found().wish.subject.block.block;
        wanted_ = Wanted{block.kind, savedId_, foundChoiceId(block),
                         foundLevelId(static_cast<std::size_t>(way))};
        takeWanted();
    }
}

/// Gives the material the way that is waited for, once its block is read.
void CheaperPage::takeWanted() {
    const Side side = document().selection().side();
    const Material* material = document().material(side);
    if (!wanted_ || material == nullptr) {
        return;
    }
    const Catalog& catalog = document().catalog();
    const Block* block = catalog.find(wanted_->kind, wanted_->id);
    if (block == nullptr) {
        return;
    }
    const Wanted wanted = *std::exchange(wanted_, std::nullopt);
    const BlockValues* part = material->part(wanted.kind);
    Material next =
        wanted.kind == kinds::models
            ? swappedModel(*material, *block, catalog)
            : withPart(*material, wanted.kind,
                       part != nullptr ? catalog.find(wanted.kind, part->id) : nullptr, block);
    next.accuracy[wanted.choice] = wanted.level;
    document().replaceMaterial(side, next, tr("Cheaper way of %1").arg(asText(block->label)));
}

QByteArray CheaperPage::bytesFor(const QString& ending) const {
    return ending == "glsl" ? QByteArray::fromStdString(found().block.glsl)
                            : QByteArray::fromStdString(writeJson(found().block.descriptor));
}

QString CheaperPage::nothingText() const {
    const QString nothing = MeasurePage::nothingText();
    if (!nothing.isEmpty()) {
        return nothing;
    }
    const Block* block = chosenBlock();
    if (block == nullptr) {
        return tr("Nothing of this material can be searched.");
    }
    if (whyNotSearched(*block).empty()) {
        return {};
    }
    const QString why = tr("%1 has found ways already.").arg(asText(block->label));
    return isSaved() ? savedText() + ' ' + why : why;
}

QString CheaperPage::notYetText() const {
    return tr("No search was made yet.");
}

QString CheaperPage::runningText() const {
    return tr("Searching …");
}

QString CheaperPage::savedText() const {
    return tr("Saved as “%1” in %2.").arg(asText(savedId_), asText(found().wish.folder.string()));
}

QString CheaperPage::outOfDateText() const {
    if (isSaved()) { // the material may have what was saved, which is another block
        return savedText();
    }
    return tr("Found for %1, with other values or choices.")
        .arg(asText(found().wish.subject.block.block->label));
}

QString CheaperPage::measuredText() const {
    if (isSaved()) {
        return savedText();
    }
    if (!found().isChecked) {
        return tr("Not checked: errors are those of the search alone.");
    }
    return found().ways.ways.empty() ? tr("Nothing cheaper was found.")
                                     : MeasurePage::measuredText();
}

} // namespace patina
