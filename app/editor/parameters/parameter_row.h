// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <QWidget>

#include "catalog/parameter.h"
#include "material/texture_use.h"

class QAbstractButton;
class QBoxLayout;
class QToolButton;

namespace patina {

class ParameterEditor;
class RowMark;
class ScrubLabel;
class TextureLine;
class WarningMark;
struct TexturePreview;

/// Represents one line of a form: label, editor, and the marks of an unusual and of a changed
/// value. While the parameter does not count it is grey and folded; it can be opened and set all
/// the same.
class ParameterRow : public QWidget {
    Q_OBJECT

  public:
    ParameterRow(const Parameter& parameter, QWidget* parent);

    const Parameter& parameter() const;
    ParameterEditor* editor() const { return editor_; }
    ScrubLabel* label() const { return label_; }
    /// Returns the line of the value's image; null while the row was not told that it takes one.
    TextureLine* textureLine() const { return textureLine_; }
    TextureLine* makeTextureLine();
    /// Puts a button behind the editor, which the row takes.
    void addButton(QToolButton* button);
    bool isFolded() const;
    bool isChanged() const { return isChanged_; }
    bool isCounting() const { return isCounting_; }
    /// Tells whether an image lies on the value.
    bool hasTexture() const;
    bool isLocked() const;
    void reset();

    void present(const Value& value);
    /// Shows the image of the value; none may be put there while nothing `takes` them.
    void presentTexture(bool takes, const std::optional<TextureUse>& use,
                        const TexturePreview& preview);
    /// Sets whether the parameter counts at present; `reason` says when it would.
    void setCounting(bool counts, const QString& reason);
    /// Shows whether what sets a whole group leaves the value alone.
    void setLocked(bool isLocked);
    int labelWidthHint() const;
    /// Returns the least that the row needs beside its label, its marks included.
    int widthBesideLabel() const;
    void setLabelWidth(int width);
    /// Returns what Tab goes through, in order.
    std::vector<QWidget*> focusChain() const;

  Q_SIGNALS:
    void approached(); ///< by the pointer or the keyboard
    void left();       ///< by the pointer
    void interactionBegan();
    void edited(const patina::Value& value);
    void interactionEnded();
    void imageDropped(const QString& file);
    void menuWished(const QPoint& place); ///< on the screen
    void copyWished();
    void pasteWished();
    void unlockWished();

  protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void makeLayout();
    void alignFirstLine();
    void makeAccessible();
    std::vector<QWidget*> tabStopsIn(const QWidget* part) const;
    bool takeKey(QKeyEvent& key);
    void updateFolding();
    void updateSummary();

    ParameterEditor* editor_;
    ScrubLabel* label_;
    QToolButton* foldButton_;
    QWidget* both_;    ///< the editor and the image of its value
    QBoxLayout* pair_; ///< how they stand in it
    std::vector<QToolButton*> buttons_;
    TextureLine* textureLine_ = nullptr;
    bool takesTextures_ = false;
    WarningMark* warning_;
    RowMark* lockMark_;
    RowMark* resetMark_;
    Value value_;
    QString reason_;
    bool isCounting_ = true;
    bool isOpened_ = false; ///< by hand, while it does not count
    bool isChanged_ = false;
};

} // namespace patina
