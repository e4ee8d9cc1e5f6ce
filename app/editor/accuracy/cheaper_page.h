// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include "accuracy/found_ways.h"
#include "accuracy/measure_page.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPlainTextEdit;
class QTabWidget;
class QToolButton;
class QTreeWidget;

namespace patina {

class BoundBox;
class FamilyChooser;

/// Searches for cheaper ways to compute a block of the current material, shows them with their
/// errors, their predicted costs and the text that they are, and saves them as a block of the
/// user's. Enter gives the material the selected one.
class CheaperPage : public MeasurePage {
    Q_OBJECT

  public:
    CheaperPage(const DockContext& context, std::shared_ptr<MeasureTurn> turn);

    /// Starts a search of the chosen block. Does nothing while this or another page works, or where
    /// there is nothing to search.
    void search();
    /// Starts one with other limits than those of the fields.
    void search(CheaperSearchOptions options);

    /// Returns what is shown; it has no ways where nothing was found.
    const FoundWays& found() const { return numbers<FoundWays>(); }

    /// Saves what is shown, unless it is saved already; adds a message where that fails.
    void save();

    /// Gives the material the selected way, as one undo step: saves it first, and waits until the
    /// saved block is read.
    void use();

  protected:
    void startMeasuring() override { search(); }
    void stopMeasuring() override;
    MeasuredSubject subject() const override;
    void showNumbers(bool stale) override;
    QByteArray bytesFor(const QString& ending) const override;
    QString nothingText() const override;
    QString notYetText() const override;
    QString runningText() const override;
    QString outOfDateText() const override;
    QString measuredText() const override;

  private:
    /// Is a way of a saved block that the material is to get.
    struct Wanted {
        std::string kind;
        std::string id;
        std::string choice;
        std::string level;
    };

    QWidget* makeControls();
    QWidget* makeTexts();
    void listBlocks();
    const Block* chosenBlock() const; ///< is null where the material has none to search
    bool isForValues() const;
    Material searchedMaterial() const;
    Checked<EvalCase> subjectCase() const;
    void showTexts();
    void showButtons();
    void fillList(bool stale);
    int selectedWay() const; ///< is -1 where none is
    bool isSaved() const;
    QString savedText() const;
    void takeWanted();
    void copy();

    QComboBox* blocks_;
    QCheckBox* forValues_;
    BoundBox* maxError_;
    QComboBox* time_;
    FamilyChooser* family_;
    QTreeWidget* list_;
    QTabWidget* texts_;
    QPlainTextEdit* glsl_;
    QPlainTextEdit* entry_;
    QLabel* notes_;
    QToolButton* copy_;
    QToolButton* save_;
    QToolButton* use_;
    std::shared_ptr<const MeasuredText> savedText_; ///< is that of the ways that were saved last
    std::string savedId_;
    std::optional<Wanted> wanted_;
    MessageLog& messages_;
    std::shared_ptr<std::atomic<bool>> isEnough_; ///< is that of the search that runs
};

} // namespace patina
