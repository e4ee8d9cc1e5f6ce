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
    /// Says what a step cost, in milliseconds.
    struct Cost {
        /// Is the longest time between two beats; negative: the step did not end in time.
        double gap = -1.0;
        double time = 0.0; ///< is the time until its picture was on the screen
    };

    explicit EditorCourse(MainWindow& window);

    /// Takes a step, from `begin` until `done` and until a picture drawn after that is on the
    /// screen.
    Cost take(const std::string& name, const std::function<void()>& begin,
              const std::function<bool()>& done);

    /// Does the same, and prints it as a line "gap time name". Returns false when it did not end in
    /// time.
    bool step(const std::string& name, const std::function<void()>& begin,
              const std::function<bool()>& done);

    void rest(int milliseconds);

    Viewport& view() { return view_; }

  private:
    bool waitUntil(const std::function<bool()>& done);
    bool waitForPicture();

    Viewport& view_;
    Heartbeat heart_;
    int onScreen_ = 0; ///< counts the frames that were finished when a picture came on the screen
};

/// Prints a step as step() does.
void printStep(const EditorCourse::Cost& cost, const std::string& name);

} // namespace patina::benchmarks
