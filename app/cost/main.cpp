// SPDX-License-Identifier: GPL-3.0-or-later
// `patina-cost`: compiles programs for graphics cards that are not there, in a process of its own.
#include <iostream>
#include <iterator>

#include <unistd.h>

#include "cost/compile_server.h"

int main() {
    const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
    const int status = patina::serveCompilation(text, [](const std::string& line) {
        std::cout << line << '\n' << std::flush;
    });
    // _exit() skips the driver's clean-up, which has nothing to save and may crash.
    ::_exit(status);
}
