// Derivatives of instructions, as further instructions: the Jacobian of Newton's method.
#pragma once

#include "core/equation/emitter.h"

namespace covaria::equation {

/// Emits d(residual)/d(unknown) for the instructions first ... last - 1 of the program, row by row; -1 where
/// it is zero.
std::vector<int> emit_jacobian(Emitter& emitter, std::span<const Instruction> instructions,
                               const std::vector<int>& residuals, const std::vector<int>& unknowns);

}  // namespace covaria::equation
