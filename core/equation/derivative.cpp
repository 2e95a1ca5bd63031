// The chain rule, operation by operation.
#include "core/equation/derivative.h"

#include <map>
#include <numbers>

namespace covaria::equation {

namespace {

using O = Operation;
constexpr int zero = -1;

/// Forward differentiation with respect to one unknown.
class Differentiator {
public:
    Differentiator(Emitter& emitter, int unknown) : emitter_(emitter) {
        derivative_[unknown] = emitter_.constant(1.0);
    }

    int of(int at) const {
        const auto found = derivative_.find(at);
        return found == derivative_.end() ? zero : found->second;
    }

    void differentiate(const Instruction& i) {
        const int da = of(i.a), db = of(i.b), dc = of(i.c);
        const int d = derivative(i, da, operands_of(i.operation) > 1 ? db : zero,
                                 operands_of(i.operation) > 2 ? dc : zero);
        if (d != zero) derivative_[i.y] = d;
    }

private:
    int constant(double value) { return emitter_.constant(value); }
    int plus(int a, int b) {
        if (a == zero || b == zero) return a == zero ? b : a;
        return emitter_.operation(O::add, a, b);
    }
    int minus(int a) { return a == zero ? zero : emitter_.operation(O::negate, a); }
    int times(int a, int b) {
        if (a == zero || b == zero) return zero;
        if (emitter_.value(a) == 1.0) return b;
        if (emitter_.value(b) == 1.0) return a;
        return emitter_.operation(O::multiply, a, b);
    }
    int over(int a, int b) { return a == zero ? zero : emitter_.operation(O::divide, a, b); }
    int apply(O function, int a) { return emitter_.operation(function, a); }
    int square(int a) { return times(a, a); }
    int value_or_zero(int d) { return d == zero ? constant(0.0) : d; }
    int choice(int condition, int d_true, int d_false) {
        if (d_true == zero && d_false == zero) return zero;
        return emitter_.operation(O::select, condition, value_or_zero(d_true), value_or_zero(d_false));
    }

    int derivative(const Instruction& i, int da, int db, int dc) {
        if (is_condition(i.operation) || (da == zero && db == zero && dc == zero)) return zero;
        switch (i.operation) {
            case O::add:
                return plus(da, db);
            case O::subtract:
                return plus(da, minus(db));
            case O::multiply:
                return plus(times(da, i.b), times(i.a, db));
            case O::divide:
                return over(plus(da, minus(times(i.y, db))), i.b);
            case O::negate:
                return minus(da);
            case O::power:
                return of_power(i, da, db);
            case O::integer_power:
                return times(times(constant(i.value), emitter_.power(i.a, constant(i.value - 1.0))), da);
            case O::select:
                return choice(i.a, db, dc);
            case O::arc_tangent_2:
                return over(plus(times(da, i.b), minus(times(i.a, db))), plus(square(i.a), square(i.b)));
            case O::hypotenuse:
                return over(plus(times(i.a, da), times(i.b, db)), i.y);
            case O::minimum:
                return choice(emitter_.operation(O::less, i.b, i.a), db, da);
            case O::maximum:
                return choice(emitter_.operation(O::less, i.a, i.b), db, da);
            default:
                return of_function(i, da);
        }
    }

    int of_power(const Instruction& i, int da, int db) {
        const int of_base =
            da == zero ? zero : times(times(i.b, emitter_.power(i.a, plus(i.b, constant(-1.0)))), da);
        return plus(of_base, db == zero ? zero : times(times(i.y, apply(O::logarithm, i.a)), db));
    }

    int of_function(const Instruction& i, int da) {
        switch (i.operation) {
            case O::square_root:
                return over(da, times(constant(2.0), i.y));
            case O::cube_root:
                return over(da, times(constant(3.0), square(i.y)));
            case O::exponential:
                return times(i.y, da);
            case O::logarithm:
                return over(da, i.a);
            case O::logarithm_10:
                return over(da, times(constant(std::numbers::ln10), i.a));
            case O::logarithm_2:
                return over(da, times(constant(std::numbers::ln2), i.a));
            case O::absolute:
                return times(apply(O::sign, i.a), da);
            case O::sign:
                return zero;
            default:
                return of_angle(i, da);
        }
    }

    int of_angle(const Instruction& i, int da) {
        const auto one_plus = [&](int x) { return plus(constant(1.0), x); };
        switch (i.operation) {
            case O::sine:
                return times(apply(O::cosine, i.a), da);
            case O::cosine:
                return minus(times(apply(O::sine, i.a), da));
            case O::tangent:
                return times(one_plus(square(i.y)), da);
            case O::arc_sine:
                return over(da, apply(O::square_root, one_plus(minus(square(i.a)))));
            case O::arc_cosine:
                return minus(over(da, apply(O::square_root, one_plus(minus(square(i.a))))));
            case O::arc_tangent:
                return over(da, one_plus(square(i.a)));
            case O::hyperbolic_sine:
                return times(apply(O::hyperbolic_cosine, i.a), da);
            case O::hyperbolic_cosine:
                return times(apply(O::hyperbolic_sine, i.a), da);
            case O::hyperbolic_tangent:
                return times(one_plus(minus(square(i.y))), da);
            case O::area_sine:
                return over(da, apply(O::square_root, one_plus(square(i.a))));
            case O::area_cosine:
                return over(da, apply(O::square_root, plus(square(i.a), constant(-1.0))));
            default:  // area_tangent
                return over(da, one_plus(minus(square(i.a))));
        }
    }

    Emitter& emitter_;
    std::map<int, int> derivative_;
};

}  // namespace

std::vector<int> emit_jacobian(Emitter& emitter, std::span<const Instruction> instructions,
                               const std::vector<int>& residuals, const std::vector<int>& unknowns) {
    std::vector<int> jacobian(residuals.size() * unknowns.size(), zero);
    for (std::size_t u = 0; u < unknowns.size(); ++u) {
        Differentiator differentiator(emitter, unknowns[u]);
        for (const Instruction& instruction : instructions) differentiator.differentiate(instruction);
        for (std::size_t r = 0; r < residuals.size(); ++r)
            jacobian[r * unknowns.size() + u] = differentiator.of(residuals[r]);
    }
    return jacobian;
}

}  // namespace covaria::equation
