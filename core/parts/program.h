// Program that made a part: results are bit-equal only where the same one runs on the same instructions.
#pragma once

#include <string>

namespace covaria {

struct ProgramIdentity {
    std::string program;       ///< "covaria 0.2.0 (GCC 12.2.0, GNU C library 2.36)"
    std::string instructions;  ///< "AVX2, FMA"
    bool operator==(const ProgramIdentity&) const = default;
};
const ProgramIdentity& this_program();

}  // namespace covaria
