// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include <QPlainTextEdit>

namespace patina {

/// Shows the text of a shader, which can be read and copied, with a margin on the left of the lines
/// that have one.
class ShaderTextView : public QPlainTextEdit {
    Q_OBJECT

  public:
    explicit ShaderTextView(QWidget* parent = nullptr);

    /// Maps lines, 1-based, to what stands before them.
    using Margins = std::map<int, QString>;

    /// Shows margins, of which the one of line `marked` is marked; 0: none is. No margins: there is
    /// no room for any.
    void setMargins(Margins margins, int marked);

    const Margins& margins() const { return margins_; }

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void placeMargin();
    void paintMargin();

    QWidget* margin_;
    Margins margins_;
    int marked_ = 0;
};

} // namespace patina
