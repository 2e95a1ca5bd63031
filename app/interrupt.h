// Ctrl-C and SIGTERM as a stop token.
#pragma once

#include <stop_token>
#include <thread>

namespace covaria {

/// From construction on, the first SIGINT or SIGTERM requests a stop; a second one ends the process at once.
/// Construct it before any other thread starts: the signals are blocked in all threads that follow.
class Interrupt {
public:
    Interrupt();
    std::stop_token token() const { return source_.get_token(); }

private:
    std::stop_source source_;
    std::jthread watcher_;
};

}  // namespace covaria
