// Products of sensitivities and deviations in vector code.
#include "core/propagation/linear_rows.h"

#include <xsimd/xsimd.hpp>

namespace covaria::detail {
namespace {

using Lanes = xsimd::batch<double>;

/// Two vectors of trials at a time: their sums stay in registers while the terms go by.
void add_up(const LinearRow& row, const TrialRows& inputs, std::size_t t, double* sums) {
    Lanes a(0.0), b(0.0);
    for (const LinearRow::Term& term : row.terms) {
        const double* x = inputs.row(term.quantity) + t;
        const Lanes estimate(term.estimate), sensitivity(term.sensitivity);
        a += sensitivity * (Lanes::load_aligned(x) - estimate);
        b += sensitivity * (Lanes::load_aligned(x + Lanes::size) - estimate);
    }
    a.store_aligned(sums + t);
    b.store_aligned(sums + t + Lanes::size);
}

static_assert(8 % (2 * Lanes::size) == 0);

}  // namespace

void LinearRows::evaluate(const TrialRows& inputs, std::size_t count, double* first_row) const {
    for (std::size_t k = 0; k < rows_.size(); ++k)
        for (std::size_t t = 0; t < count; t += 2 * Lanes::size)
            add_up(rows_[k], inputs, t, first_row + k * block_trials);
}

}  // namespace covaria::detail
