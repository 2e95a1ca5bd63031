// Newton's method with step halving, for all trials of a strip at once and for each by itself: what happens
// in one lane does not depend on the others.
//
// Derivatives follow from the last step: u = u - J^-1 r(u, x) has, in dual numbers and at r = 0, exactly the
// derivatives -J^-1 dr/dx of the solution (JCGM 102 6.3).
#pragma once

#include <array>
#include <limits>

#include "core/equation/program.h"
#include "core/equation/real_functions.h"

namespace covaria::equation {

template <class Real>
struct Registers {
    Real* first;
    std::size_t width;
    Real* at(int index) const { return first + static_cast<std::size_t>(index) * width; }
};

template <class Real>
class Newton {
public:
    static constexpr int most_steps = 100;

    Newton(const NewtonSystem& system, const Registers<Real>& registers)
        : system_(system), registers_(registers) {}

    /// `evaluate` computes residuals and Jacobian from the unknowns.
    template <class Evaluate>
    void solve(Evaluate evaluate) {
        for (std::size_t i = 0; i < registers_.width; ++i) start(i);
        bool more = true;
        for (int step = 0; step < most_steps && more; ++step) {
            evaluate();
            more = false;
            for (std::size_t i = 0; i < registers_.width; ++i) more = advance(i) || more;
        }
        for (std::size_t i = 0; i < registers_.width; ++i) finish(i);
    }

private:
    using Mask = mask_of<Real>;
    using Vector = std::array<Real, most_unknowns>;
    template <std::size_t most>
    using Rows = std::array<std::array<Real, most>, most>;

    std::size_t n() const { return system_.size(); }
    Real& unknown(std::size_t k, std::size_t i) { return registers_.at(system_.unknowns[k])[i]; }
    Real& scratch(std::size_t s, std::size_t i) {
        return registers_.at(system_.scratch + static_cast<int>(s))[i];
    }
    // Scratch: the accepted unknowns, their steps, and four numbers.
    Real& accepted(std::size_t k, std::size_t i) { return scratch(k, i); }
    Real& step_of(std::size_t k, std::size_t i) { return scratch(n() + k, i); }
    Real& norm(std::size_t i) { return scratch(2 * n(), i); }
    Real& fraction(std::size_t i) { return scratch(2 * n() + 1, i); }
    Real& small_steps(std::size_t i) { return scratch(2 * n() + 2, i); }  ///< in a row: two end the search
    Real& halvings(std::size_t i) { return scratch(2 * n() + 3, i); }

    void start(std::size_t i) {
        for (std::size_t k = 0; k < n(); ++k) {
            unknown(k, i) = accepted(k, i) = registers_.at(system_.starts[k])[i];
            step_of(k, i) = Real(0.0);
        }
        norm(i) = Real(std::numeric_limits<double>::infinity());
        fraction(i) = Real(1.0);
        small_steps(i) = halvings(i) = Real(0.0);
    }

    Real norm_now(std::size_t i) {
        Real sum(0.0);
        for (const int r : system_.residuals) sum = sum + absolute(registers_.at(r)[i]);
        return sum;
    }

    /// True while a lane goes on.
    bool advance(std::size_t i) {
        using namespace real_functions;
        const Mask running = small_steps(i) < Real(1.5);
        if (!any(running)) return false;
        const Real now = norm_now(i);
        const Real worst(std::numeric_limits<double>::max());
        const Mask better = (now <= norm(i)) || (small_steps(i) > Real(0.5));
        const Mask good = better && (now <= worst);  // NaN compares as false
        Vector newton;
        constexpr std::size_t usual = 6;  // the others do not pay for what a large system needs
        n() <= usual ? newton_step<usual>(i, newton) : newton_step<most_unknowns>(i, newton);
        Mask tiny = good;
        for (std::size_t k = 0; k < n(); ++k) tiny = tiny && is_tiny(newton[k], k, i);
        for (std::size_t k = 0; k < n(); ++k) {
            accepted(k, i) = select(good && running, unknown(k, i), accepted(k, i));
            step_of(k, i) = select(good && running, newton[k], step_of(k, i));
        }
        norm(i) = select(good && running, now, norm(i));
        fraction(i) = select(good, Real(1.0), Real(0.5) * fraction(i));
        const Real counted = select(tiny, small_steps(i) + Real(1.0), Real(0.0));
        small_steps(i) = select(running, counted, small_steps(i));
        for (std::size_t k = 0; k < n(); ++k)
            unknown(k, i) = select(running, accepted(k, i) + fraction(i) * step_of(k, i), unknown(k, i));
        return any(small_steps(i) < Real(1.5));
    }

    Mask is_tiny(const Real& step, std::size_t k, std::size_t i) {
        return absolute(step) <= Real(1e-9) * absolute(unknown(k, i)) +
                                     Real(1e-14) * absolute(registers_.at(system_.starts[k])[i]);
    }

    void finish(std::size_t i) {
        using namespace real_functions;
        const Real none(std::numeric_limits<double>::quiet_NaN());
        for (std::size_t k = 0; k < n(); ++k)
            unknown(k, i) = select(small_steps(i) > Real(1.5), unknown(k, i), none);
    }

    /// -J^-1 r by elimination with row exchange, lane by lane.
    template <std::size_t most>
    void newton_step(std::size_t i, Vector& x) {
        Rows<most> a;
        std::array<Real, most> b;
        for (std::size_t r = 0; r < n(); ++r) {
            for (std::size_t c = 0; c < n(); ++c) {
                const int at = system_.jacobian[r * n() + c];
                a[r][c] = at < 0 ? Real(0.0) : registers_.at(at)[i];
            }
            b[r] = -registers_.at(system_.residuals[r])[i];
        }
        for (std::size_t c = 0; c + 1 < n(); ++c) eliminate(a, b, c);
        for (std::size_t r = n(); r-- > 0;) {
            Real sum = b[r];
            for (std::size_t c = r + 1; c < n(); ++c) sum = sum - a[r][c] * x[c];
            x[r] = sum / a[r][r];
        }
    }

    template <class Matrix, class Right>
    void eliminate(Matrix& a, Right& b, std::size_t c) {
        for (std::size_t r = c + 1; r < n(); ++r) {
            const Mask exchange = absolute(a[r][c]) > absolute(a[c][c]);
            for (std::size_t k = c; k < n(); ++k) swap_where(exchange, a[r][k], a[c][k]);
            swap_where(exchange, b[r], b[c]);
        }
        for (std::size_t r = c + 1; r < n(); ++r) {
            const Real factor = a[r][c] / a[c][c];
            for (std::size_t k = c; k < n(); ++k) a[r][k] = a[r][k] - factor * a[c][k];
            b[r] = b[r] - factor * b[c];
        }
    }

    static void swap_where(const Mask& mask, Real& x, Real& y) {
        using namespace real_functions;
        const Real old = x;
        x = select(mask, y, x);
        y = select(mask, old, y);
    }

    const NewtonSystem& system_;
    Registers<Real> registers_;
};

}  // namespace covaria::equation
