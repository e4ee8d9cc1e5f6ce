// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <QTimer>
#include <QWidget>
#include <glm/vec3.hpp>

namespace patina {

/// Holds a point of a curve or a stop of a ramp.
struct Handle {
    double x = 0.0;        ///< 0 .. 1
    double y = 0.0;        ///< is used by curves only
    glm::dvec3 color{0.0}; ///< is used by ramps only; linear

    friend bool operator==(const Handle&, const Handle&) = default;
};

/// Lets handles be chosen, dragged, added with a click and removed by dragging them out of the
/// field. One that is dragged past another takes a place behind it and stays the chosen one. Arrows
/// move the chosen one between its neighbours, page keys choose another, Delete removes it, Esc
/// takes a drag back. Handles stand by rising x and keep a distance. What it asks for it shows at
/// once; the document's answer comes through setHandles().
class HandleArea : public QWidget {
    Q_OBJECT

  public:
    /// Says how many handles there may be, and how far apart their x are at least.
    struct Limits {
        std::size_t min = 1;
        std::size_t max = 1;
        double gap = 0.0;
    };

    HandleArea(const Limits& limits, QWidget* parent);

    void setHandles(const std::vector<Handle>& handles);
    const std::vector<Handle>& handles() const { return handles_; }

    /// Returns the index of the handle that keys and fields change; nothing where it was removed.
    std::optional<std::size_t> chosen() const { return chosen_; }
    void choose(std::size_t index);

    /// Asks for a handle in place of the chosen one, as near to it as its neighbours allow.
    void replaceChosen(const Handle& wanted);
    void removeChosen();

    /// Returns where a handle is in the widget.
    virtual QPointF pixelOf(const Handle& handle) const = 0;

  Q_SIGNALS:
    void interactionBegan();
    void changed(); ///< handles() are what the user asks for
    void interactionEnded();
    void chosenChanged();
    void activated(); ///< the chosen handle was double clicked, or Return was pressed

  protected:
    /// Returns a new handle at a pixel.
    virtual Handle handleAt(const QPointF& pixel) const = 0;
    /// Returns a handle as it is when it is dragged to a pixel.
    virtual Handle dragged(const Handle& handle, const QPointF& pixel) const = 0;
    /// Returns a handle after an arrow key moved it by shares of the field's width and height.
    virtual Handle stepped(const Handle& handle, double right, double up) const = 0;

    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    std::optional<std::size_t> handleNear(const QPointF& pixel) const;
    std::optional<std::size_t> insert(const Handle& handle);
    std::optional<double> roomFor(double x, std::size_t index) const;
    void moveThroughOthers(const Handle& wanted);
    bool isFarOutside(const QPointF& pixel) const;
    void setChosen(std::optional<std::size_t> index);
    void chooseNext(int steps);
    void nudge(double right, double up);
    void cancelDrag();
    void endNudging();

    Limits limits_;
    std::vector<Handle> handles_;
    std::optional<std::size_t> chosen_;
    std::vector<Handle> before_;         ///< are those before the drag, for Esc
    std::vector<Handle> base_;           ///< are those with the dragged one where it was pressed
    std::optional<std::size_t> dragged_; ///< is its index in base_
    QTimer nudging_;                     ///< a held key is one interaction until it rests
};

} // namespace patina
