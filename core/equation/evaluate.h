// Runs a compiled program over one trial, a strip of vectors of trials, or dual numbers.
#pragma once

#include "core/equation/program.h"
#include "core/equation/real_functions.h"

namespace covaria::equation {

/// Result of one operation on numbers.
double evaluated(Operation operation, double a, double b, double c, double value);

/// Registers of `width` numbers each: register r is registers[r * width] ... The inputs and constants must be
/// there; everything else is computed. Systems that do not converge give NaN. No allocation.
template <class Real>
void run(const Program& program, Real* registers, std::size_t width);

extern template void run<double>(const Program&, double*, std::size_t);
extern template void run<Batch>(const Program&, Batch*, std::size_t);
extern template void run<Dual>(const Program&, Dual*, std::size_t);

/// Writes the constants into their registers.
template <class Real>
void put_constants(const Program& program, Real* registers, std::size_t width) {
    for (const Program::Constant& constant : program.constants)
        for (std::size_t i = 0; i < width; ++i)
            registers[static_cast<std::size_t>(constant.at) * width + i] = Real(constant.value);
}

}  // namespace covaria::equation
