// Ctrl-C and SIGTERM as a stop token.
#pragma once

#include <stop_token>
#include <thread>

namespace covaria {

/// From construction on, the first SIGINT or SIGTERM requests a stop, and a third of a second later ends the
/// process with status 130, whatever it is doing (reading, writing, drawing); a second one ends it at once.
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
