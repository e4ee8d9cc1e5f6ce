// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "heartbeat.h"
#include "window/main_window.h"

namespace patina::benchmarks {

/// Does steps in the editor's window one after the other, with a heartbeat on its event loop.
class EditorCourse {
  public:
    /// What a step cost, in milliseconds.
    struct Cost {
        double gap = -1.0; ///< the longest between two beats; negative: not done in time
        double time = 0.0; ///< until its picture was on the screen
    };

    explicit EditorCourse(MainWindow& window);

    /// From `begin` until `done` and a picture drawn after that is on the screen.
    Cost take(const std::string& name, const std::function<void()>& begin,
              const std::function<bool()>& done);

    /// The same, printed as a line "gap time name"; false: not done in time.
    bool step(const std::string& name, const std::function<void()>& begin,
              const std::function<bool()>& done);

    void rest(int milliseconds);

    Viewport& view() { return view_; }

  private:
    bool waitUntil(const std::function<bool()>& done);
    bool waitForPicture();

    Viewport& view_;
    Heartbeat heart_;
    int swaps_ = 0;
};

/// As step() prints it.
void printStep(const EditorCourse::Cost& cost, const std::string& name);

} // namespace patina::benchmarks
