// The three number types for which equations are compiled, under one set of names: double (one trial),
// xsimd::batch<double> (a vector of trials) and Dual (derivatives, dual.h).
//
// Equations are templates over `Real`. They call sqrt, sin, atan2, select ... unqualified, after
// `using namespace real_functions;`: that brings the functions of double, those of batches and duals are
// found by argument-dependent lookup. A branch becomes `select(condition, a, b)`.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <xsimd/xsimd.hpp>

namespace covaria {

using Batch = xsimd::batch<double>;

template <class Real>
struct MaskOf {
    using type = bool;
};
template <>
struct MaskOf<Batch> {
    using type = xsimd::batch_bool<double>;
};
/// Result of a comparison of two `Real`: bool, or one bool per lane.
template <class Real>
using mask_of = typename MaskOf<Real>::type;

template <class Real>
using Vector3 = Eigen::Matrix<Real, 3, 1>;
template <class Real>
using Matrix3 = Eigen::Matrix<Real, 3, 3>;

namespace real_functions {

using std::abs;
using std::acos;
using std::asin;
using std::atan2;
using std::cos;
using std::exp;
using std::hypot;
using std::log;
using std::pow;
using std::sin;
using std::sqrt;
using std::tan;
using xsimd::all;
using xsimd::any;
using xsimd::select;

inline double min(double a, double b) {
    return b < a ? b : a;
}
inline double max(double a, double b) {
    return a < b ? b : a;
}
template <class Real>
requires(!std::is_same_v<Real, Batch>) Real select(bool condition, const Real& a, const Real& b) {
    return condition ? a : b;
}
inline bool all(bool condition) {
    return condition;
}
inline bool any(bool condition) {
    return condition;
}

}  // namespace real_functions

}  // namespace covaria

namespace Eigen {

/// Lets Eigen use a batch as a scalar, for small fixed-size vectors and matrices.
template <>
struct NumTraits<covaria::Batch> : GenericNumTraits<double> {
    using Real = covaria::Batch;
    using NonInteger = covaria::Batch;
    using Nested = covaria::Batch;
    using Literal = double;
    enum {
        IsComplex = 0,
        IsInteger = 0,
        IsSigned = 1,
        RequireInitialization = 0,
        ReadCost = 1,
        AddCost = 1,
        MulCost = 1
    };
};

}  // namespace Eigen
