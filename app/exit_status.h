// Exit status of the program (the command line's contract).
#pragma once

#include "core/base/error.h"

namespace covaria {

enum ExitStatus : int {
    exit_success = 0,
    exit_bad_input = 1,
    exit_wrong_usage = 2,
    exit_not_met = 3,
    exit_interrupted = 130
};

inline int exit_status_of(const Error& error) {
    switch (error.code) {
        case ErrorCode::cancelled:
            return exit_interrupted;
        case ErrorCode::usage:
            return exit_wrong_usage;
        default:
            return exit_bad_input;
    }
}

}  // namespace covaria
