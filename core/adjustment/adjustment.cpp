#include "core/adjustment/adjustment.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/adjustment/lanes.h"
#include "core/math/decompositions.h"

namespace covaria::adjustment {

namespace {

/// Below this, of columns of length one, a direction counts as not determined: its cofactor would have no
/// correct digit.
constexpr double least_determined = 1e-7;
/// Least part of a direction that must lie in the datum for the datum to determine it.
constexpr double least_datum = 1e-6;

using Triplet = Eigen::Triplet<double>;

/// Independent starting vectors without a generator: values of an irrational rotation.
Eigen::MatrixXd spread_vectors(Eigen::Index n, Eigen::Index count) {
    Eigen::MatrixXd V(n, count);
    double at = 0.5;
    for (Eigen::Index j = 0; j < count; ++j)
        for (Eigen::Index i = 0; i < n; ++i) {
            at += 0.6180339887498949 + 0.0137 * static_cast<double>(j);
            at -= std::floor(at);
            V(i, j) = std::sin(37.0 * at * static_cast<double>(i + 1)) + at - 0.5;
        }
    return V;
}

Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& V) {
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(V);
    return qr.householderQ() * Eigen::MatrixXd::Identity(V.rows(), V.cols());
}

/// The lower triangle of a normal matrix with `more` on its diagonal, the first element of each column.
SparseColumns with_ridge(SparseColumns lower, double more) {
    for (Eigen::Index j = 0; j < lower.cols(); ++j) lower.valuePtr()[lower.outerIndexPtr()[j]] += more;
    return lower;
}

/// W A, in place where W weighs each reading by itself.
SparseRows whitened_by(const SparseRows& whitening, SparseRows design) {
    const Eigen::Index n = whitening.rows();
    bool alone = whitening.isCompressed() && whitening.nonZeros() == n;
    for (Eigen::Index i = 0; alone && i < n; ++i)
        alone = whitening.outerIndexPtr()[i + 1] == i + 1 && whitening.innerIndexPtr()[i] == i;
    if (!alone) return whitening * design;
    design.makeCompressed();
    for (Eigen::Index i = 0; i < n; ++i)
        for (int k = design.outerIndexPtr()[i]; k < design.outerIndexPtr()[i + 1]; ++k)
            design.valuePtr()[k] *= whitening.valuePtr()[i];
    return design;
}

/// The lower triangle of AᵀA with columns of A over their `scale`; its diagonal is always there.
SparseColumns lower_normal(const SparseRows& A, const Eigen::VectorXd& scale) {
    const int n = static_cast<int>(A.cols()), *rows = A.outerIndexPtr(), *columns = A.innerIndexPtr();
    const double* values = A.valuePtr();
    struct Place {
        int element, end;
    };
    // The elements of each column, by reading, with the end of their row.
    std::vector<int> starts(static_cast<std::size_t>(n) + 1, 0);
    for (Eigen::Index k = 0; k < A.nonZeros(); ++k) ++starts[static_cast<std::size_t>(columns[k]) + 1];
    for (std::size_t j = 1; j < starts.size(); ++j) starts[j] += starts[j - 1];
    std::vector<Place> places(static_cast<std::size_t>(A.nonZeros()));
    std::vector<int> at(starts.begin(), starts.end() - 1);
    for (Eigen::Index i = 0; i < A.rows(); ++i)
        for (int k = rows[i]; k < rows[i + 1]; ++k)
            places[static_cast<std::size_t>(at[static_cast<std::size_t>(columns[k])]++)] = {k, rows[i + 1]};
    std::vector<double> work(static_cast<std::size_t>(n), 0.0);
    std::vector<int> seen(static_cast<std::size_t>(n), -1), touched, outer(1, 0), inner;
    std::vector<double> elements;
    for (int j = 0; j < n; ++j) {
        touched.assign(1, j);
        seen[static_cast<std::size_t>(j)] = j;
        for (int p = starts[static_cast<std::size_t>(j)]; p < starts[static_cast<std::size_t>(j) + 1]; ++p) {
            const auto [first, end] = places[static_cast<std::size_t>(p)];
            const double a = values[first];
            for (int k = first; k < end; ++k) {
                const auto c = static_cast<std::size_t>(columns[k]);
                if (seen[c] != j) {
                    seen[c] = j;
                    touched.push_back(columns[k]);
                }
                work[c] += a * values[k];
            }
        }
        std::ranges::sort(touched);
        for (const int i : touched) {
            inner.push_back(i);
            elements.push_back(std::exchange(work[static_cast<std::size_t>(i)], 0.0) / (scale[i] * scale[j]));
        }
        outer.push_back(static_cast<int>(inner.size()));
    }
    SparseColumns normal(n, n);
    normal.resizeNonZeros(static_cast<Eigen::Index>(inner.size()));
    std::ranges::copy(outer, normal.outerIndexPtr());
    std::ranges::copy(inner, normal.innerIndexPtr());
    std::ranges::copy(elements, normal.valuePtr());
    return normal;
}

/// Whether the readings see every direction: no pivot is rounding, and inverse iteration finds no direction
/// that they do not see.
bool sees_all(const SparseFactor& factor, const SparseRows& whitened, const Eigen::VectorXd& scale) {
    constexpr double least_pivot = 1e-9;  // far above rounding, of columns of length one
    constexpr int rounds = 6;
    if (!(factor.least_pivot() > least_pivot)) return false;
    Eigen::VectorXd v = spread_vectors(scale.size(), 1).col(0).normalized(), scratch(scale.size());
    for (int round = 0; round < rounds; ++round) {
        factor.solve(v.data(), scratch.data());
        v.normalize();
    }
    return (whitened * v.cwiseQuotient(scale)).norm() >= least_determined;
}

/// Directions that the readings do not see, by inverse iteration with the factor of a matrix that has a
/// ridge.
Eigen::MatrixXd unseen_by(const SparseFactor& ridged, const SparseRows& whitened,
                          const Eigen::VectorXd& scale) {
    constexpr int rounds = 6;
    const Eigen::Index n = scale.size();
    const Eigen::VectorXd by_scale = scale.cwiseInverse();
    Eigen::VectorXd scratch(n);
    // One starting vector first tells whether any direction is open: most networks leave none.
    for (Eigen::Index count = 1;; count = std::min(n, count == 1 ? 10 : 3 * count)) {
        Eigen::MatrixXd V = orthonormal(spread_vectors(n, count));
        for (int round = 0; round < rounds; ++round) {
            for (Eigen::Index j = 0; j < count; ++j) ridged.solve(V.col(j).data(), scratch.data());
            V = orthonormal(V);
        }
        // The design itself is decomposed, not its square, in which half of the digits would be lost.
        const Eigen::MatrixXd seen = whitened * (by_scale.asDiagonal() * V);
        const auto svd = singular_values(Eigen::MatrixXd(seen.transpose() * seen), Eigen::ComputeFullV);
        const Eigen::MatrixXd turned = V * svd.matrixV(), turned_seen = seen * svd.matrixV();
        std::vector<Eigen::Index> unseen;
        for (Eigen::Index j = 0; j < count; ++j)
            if (turned_seen.col(j).norm() < least_determined) unseen.push_back(j);
        if (static_cast<Eigen::Index>(unseen.size()) == count && count < n) continue;
        return turned(Eigen::all, unseen);
    }
}

}  // namespace

SparseRows whitening(const Eigen::VectorXd& u, const std::vector<CovarianceBlock>& blocks) {
    std::vector<char> in_block(static_cast<std::size_t>(u.size()), 0);
    std::vector<Triplet> elements;
    for (const CovarianceBlock& block : blocks) {
        const Eigen::LLT<Eigen::MatrixXd> factors(block.covariance);
        if (factors.info() != Eigen::Success) return {};
        const Eigen::Index n = block.covariance.rows();
        const Eigen::MatrixXd inverse = factors.matrixL().solve(Eigen::MatrixXd::Identity(n, n));
        if (!inverse.allFinite()) return {};
        for (Eigen::Index i = 0; i < n; ++i) {
            in_block[block.readings[static_cast<std::size_t>(i)]] = 1;
            for (Eigen::Index j = 0; j <= i; ++j)
                if (inverse(i, j) != 0.0)
                    elements.emplace_back(static_cast<int>(block.readings[static_cast<std::size_t>(i)]),
                                          static_cast<int>(block.readings[static_cast<std::size_t>(j)]),
                                          inverse(i, j));
        }
    }
    for (Eigen::Index i = 0; i < u.size(); ++i)
        if (!in_block[static_cast<std::size_t>(i)])
            elements.emplace_back(static_cast<int>(i), static_cast<int>(i), 1.0 / u[i]);
    SparseRows W(u.size(), u.size());
    W.setFromTriplets(elements.begin(), elements.end());
    return W;
}

Adjustment::Adjustment(SparseRows design, const SparseRows& whitening, const std::vector<std::size_t>& datum,
                       const Adjustment* like)
    : whitened_(whitened_by(whitening, std::move(design))), datum_(datum) {
    scale_ = Eigen::VectorXd::Zero(whitened_.cols());
    for (Eigen::Index i = 0; i < whitened_.rows(); ++i)
        for (SparseRows::InnerIterator it(whitened_, i); it; ++it)
            scale_[it.col()] += it.value() * it.value();
    scale_ = scale_.cwiseSqrt();
    for (double& s : scale_)
        if (!(s > 0.0)) s = 1.0;
    const SparseColumns normal = lower_normal(whitened_, scale_);
    open_.resize(scale_.size(), 0);
    undetermined_.resize(scale_.size(), 0);
    const SparseFactor* order = like ? like->order() : nullptr;
    const auto factor = std::make_shared<SparseFactor>();
    if (scale_.size() > 0 && !(like && like->defect() > 0) && factor->factorise(normal, order) &&
        sees_all(*factor, whitened_, scale_)) {
        reduced_.resize(unknowns());
        std::iota(reduced_.begin(), reduced_.end(), 0);
        factor_ = factor;
        return;
    }
    // A ridge far below what is determined, far above rounding.
    constexpr double ridge = 1e-11;
    const auto ridged = std::make_shared<SparseFactor>();
    if (scale_.size() > 0 && ridged->factorise(with_ridge(normal, ridge), order)) {
        ridged_ = ridged;
        undetermined_ = unseen_by(*ridged, whitened_, scale_);
    }
    take_to_datum(datum);
    if (open_.cols() == 0) factorise(normal);
}

void Adjustment::take_to_datum(const std::vector<std::size_t>& datum) {
    const Eigen::Index d = undetermined_.cols();
    if (d == 0) return;
    const auto in_datum = static_cast<Eigen::Index>(datum.size());
    Eigen::MatrixXd of_datum(std::max<Eigen::Index>(in_datum, d), d);
    of_datum.setZero();
    for (Eigen::Index i = 0; i < in_datum; ++i)
        of_datum.row(i) = undetermined_.row(static_cast<Eigen::Index>(datum[static_cast<std::size_t>(i)]));
    const auto svd = singular_values(of_datum, Eigen::ComputeFullV);
    std::vector<Eigen::Index> open;
    for (Eigen::Index j = 0; j < d; ++j)
        if (svd.singularValues()[j] < least_datum) open.push_back(j);
    if (!open.empty()) {
        open_ = undetermined_ * svd.matrixV()(Eigen::all, open);
        return;
    }
    // The held unknowns, while the others are found, are those of the datum that the directions move most.
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> pivots(of_datum.transpose());
    for (Eigen::Index j = 0; j < d; ++j)
        held_.push_back(datum[static_cast<std::size_t>(pivots.colsPermutation().indices()[j])]);
    // The directions are stated in the unknowns themselves, orthonormal in the datum.
    undetermined_ = scale_.cwiseInverse().asDiagonal() * undetermined_;
    for (Eigen::Index i = 0; i < in_datum; ++i)
        of_datum.row(i) = undetermined_.row(static_cast<Eigen::Index>(datum[static_cast<std::size_t>(i)]));
    for (Eigen::Index j = 0; j < d; ++j) {
        const double length = of_datum.col(j).norm();
        of_datum.col(j) /= length;
        undetermined_.col(j) /= length;
    }
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(of_datum);
    const Eigen::MatrixXd R = qr.matrixQR().topRows(d).triangularView<Eigen::Upper>();
    undetermined_ =
        R.transpose().triangularView<Eigen::Lower>().solve(undetermined_.transpose()).transpose().eval();
}

void Adjustment::factorise(const SparseColumns& normal) {
    std::vector<std::size_t> held = held_;
    std::sort(held.begin(), held.end());
    reduced_.assign(unknowns(), -1);
    std::ptrdiff_t count = 0;
    for (std::size_t i = 0; i < unknowns(); ++i)
        if (!std::binary_search(held.begin(), held.end(), i)) reduced_[i] = count++;
    std::vector<Triplet> elements;
    for (Eigen::Index j = 0; j < normal.cols(); ++j)
        for (SparseColumns::InnerIterator it(normal, j); it; ++it) {  // its lower triangle
            const std::ptrdiff_t a = reduced_[static_cast<std::size_t>(it.row())],
                                 b = reduced_[static_cast<std::size_t>(j)];
            if (a >= b && b >= 0) elements.emplace_back(static_cast<int>(a), static_cast<int>(b), it.value());
        }
    SparseColumns lower(count, count);
    lower.setFromTriplets(elements.begin(), elements.end());
    const auto factor = std::make_shared<SparseFactor>();
    if (!factor->factorise(lower)) return;
    factor_ = factor;
    if (defect() == 0) return;
    datum_cofactors_ = Eigen::MatrixXd::Zero(scale_.size(), undetermined_.cols());
    for (const std::size_t i : datum_)
        datum_cofactors_.row(static_cast<Eigen::Index>(i)) = undetermined_.row(static_cast<Eigen::Index>(i));
    const Eigen::MatrixXd BG = datum_cofactors_;
    std::vector<double> scratch(scratch_size());
    for (Eigen::Index j = 0; j < BG.cols(); ++j) solve_held(datum_cofactors_.col(j).data(), scratch.data());
    of_datum_ = BG.transpose() * datum_cofactors_;
}

template <class Number>
void Adjustment::solve_held(Number* x, Number* scratch) const {
    const std::size_t n = unknowns();
    for (std::size_t i = 0; i < n; ++i) {
        x[i] /= scale_[static_cast<Eigen::Index>(i)];
        if (reduced_[i] >= 0) scratch[static_cast<std::size_t>(reduced_[i])] = x[i];
    }
    factor_->solve(scratch, scratch + n);
    for (std::size_t i = 0; i < n; ++i) {
        x[i] = reduced_[i] < 0 ? Number(0.0) : scratch[static_cast<std::size_t>(reduced_[i])];
        x[i] /= scale_[static_cast<Eigen::Index>(i)];
    }
}

template <class Number>
void Adjustment::step(Number* x, Number* scratch) const {
    const std::size_t n = unknowns();
    solve_held(x, scratch);
    for (Eigen::Index j = 0; j < undetermined_.cols(); ++j) {
        Number along(0.0);
        for (const std::size_t i : datum_)
            add_product(along, undetermined_(static_cast<Eigen::Index>(i), j), x[i]);
        scratch[2 * n + static_cast<std::size_t>(j)] = along;
    }
    for (Eigen::Index j = 0; j < undetermined_.cols(); ++j)
        for (std::size_t i = 0; i < n; ++i)
            add_product(x[i], -undetermined_(static_cast<Eigen::Index>(i), j),
                        scratch[2 * n + static_cast<std::size_t>(j)]);
}

template void Adjustment::step(double*, double*) const;
template void Adjustment::step(OneLane*, OneLane*) const;
template void Adjustment::step(FewLanes*, FewLanes*) const;
template void Adjustment::step(ManyLanes*, ManyLanes*) const;

Eigen::VectorXd Adjustment::step(const Eigen::VectorXd& gradient) const {
    Eigen::VectorXd x = gradient;
    std::vector<double> scratch(scratch_size());
    step(x.data(), scratch.data());
    return x;
}

void Adjustment::to_datum(Eigen::VectorXd& x) const {
    Eigen::VectorXd along = Eigen::VectorXd::Zero(undetermined_.cols());
    for (const std::size_t i : datum_)
        along +=
            undetermined_.row(static_cast<Eigen::Index>(i)).transpose() * x[static_cast<Eigen::Index>(i)];
    x -= undetermined_ * along;
}

Eigen::VectorXd Adjustment::cofactors(const Eigen::VectorXd& e) const {
    Eigen::VectorXd x = e;
    const Eigen::VectorXd along = undetermined_.transpose() * e;
    for (const std::size_t i : datum_)
        x[static_cast<Eigen::Index>(i)] -= undetermined_.row(static_cast<Eigen::Index>(i)).dot(along);
    return step(x);
}

const SelectedInverse& Adjustment::inverse() const {
    if (!inverse_) inverse_ = std::make_shared<const SelectedInverse>(factor_->selected_inverse());
    return *inverse_;
}

double Adjustment::held_cofactor(std::size_t i, std::size_t j) const {
    if (reduced_[i] < 0 || reduced_[j] < 0) return 0.0;
    return inverse().at(static_cast<std::size_t>(reduced_[i]), static_cast<std::size_t>(reduced_[j])) /
           (scale_[static_cast<Eigen::Index>(i)] * scale_[static_cast<Eigen::Index>(j)]);
}

double Adjustment::cofactor(std::size_t i, std::size_t j) const {
    const auto a = static_cast<Eigen::Index>(i), b = static_cast<Eigen::Index>(j);
    double q = held_cofactor(i, j);
    if (defect() > 0)
        q += -undetermined_.row(a).dot(datum_cofactors_.row(b)) -
             datum_cofactors_.row(a).dot(undetermined_.row(b)) +
             undetermined_.row(a) * of_datum_ * undetermined_.row(b).transpose();
    return q;
}

Eigen::VectorXd Adjustment::cofactors_of_readings() const {
    return inverse().quadratic_forms(whitened_, reduced_, scale_);
}

double Adjustment::cofactor_of_readings(std::size_t a, std::size_t b) const {
    double sum = 0.0;
    for (SparseRows::InnerIterator i(whitened_, static_cast<Eigen::Index>(a)); i; ++i)
        for (SparseRows::InnerIterator j(whitened_, static_cast<Eigen::Index>(b)); j; ++j)
            sum += i.value() * j.value() *
                   held_cofactor(static_cast<std::size_t>(i.col()), static_cast<std::size_t>(j.col()));
    return sum;
}

}  // namespace covaria::adjustment
