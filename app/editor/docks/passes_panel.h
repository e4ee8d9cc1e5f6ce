// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <QWidget>

class QMenu;
class QVBoxLayout;

namespace patina {

class Document;
class TextureLibrary;

/// Lists the passes over the picture in their order, each with its values, and adds, moves and
/// removes them.
class PassesPanel : public QWidget {
    Q_OBJECT

  public:
    PassesPanel(Document& document, TextureLibrary& textures, QWidget* parent = nullptr);

  private:
    void fillMenu();
    void update();
    QWidget* entry(int index, int count);

    Document& document_;
    TextureLibrary& textures_;
    QMenu* blocks_;
    QVBoxLayout* entries_;
    std::vector<std::string> shown_; ///< has the ids of the entries' blocks
};

} // namespace patina
