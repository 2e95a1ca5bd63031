#include "core/adjustment/sparse_factor.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

namespace covaria::adjustment {

bool SparseFactor::factorise(const SparseColumns& lower) {
    diagonal_.clear();
    Eigen::SimplicialLDLT<SparseColumns, Eigen::Lower, Eigen::AMDOrdering<int>> ldlt(lower);
    if (ldlt.info() != Eigen::Success) return false;
    const Eigen::VectorXd D = ldlt.vectorD();
    if (!D.allFinite() || (D.size() > 0 && !(D.minCoeff() > 0.0))) return false;
    const SparseColumns L = ldlt.matrixL();
    const auto n = static_cast<std::size_t>(L.cols());
    place_.resize(n);
    for (std::size_t i = 0; i < n; ++i) place_[i] = ldlt.permutationP().indices()[static_cast<int>(i)];
    starts_.assign(1, 0);
    rows_.clear();
    values_.clear();
    for (int j = 0; j < L.cols(); ++j) {
        for (SparseColumns::InnerIterator it(L, j); it; ++it)
            if (it.row() > j) {
                rows_.push_back(static_cast<int>(it.row()));
                values_.push_back(it.value());
            }
        starts_.push_back(static_cast<int>(rows_.size()));
    }
    diagonal_.assign(D.data(), D.data() + D.size());
    return true;
}

void SparseFactor::solve(double* b, double* scratch) const {
    const std::size_t n = size();
    for (std::size_t i = 0; i < n; ++i) scratch[place_[i]] = b[i];
    for (std::size_t j = 0; j < n; ++j)
        for (int k = starts_[j]; k < starts_[j + 1]; ++k) scratch[rows_[k]] -= values_[k] * scratch[j];
    for (std::size_t j = 0; j < n; ++j) scratch[j] /= diagonal_[j];
    for (std::size_t j = n; j-- > 0;)
        for (int k = starts_[j]; k < starts_[j + 1]; ++k) scratch[j] -= values_[k] * scratch[rows_[k]];
    for (std::size_t i = 0; i < n; ++i) b[i] = scratch[place_[i]];
}

SelectedInverse SparseFactor::selected_inverse() const {
    SelectedInverse Z;
    Z.place_ = place_;
    Z.starts_ = starts_;
    Z.rows_ = rows_;
    Z.values_.assign(values_.size(), 0.0);
    Z.diagonal_.assign(size(), 0.0);
    // Z = D⁻¹ L⁻¹ + (I − Lᵀ) Z, from the last column to the first.
    std::vector<int> index_of(size(), -1);
    std::vector<double> sums;
    for (std::size_t j = size(); j-- > 0;) {
        const int first = starts_[j], end = starts_[j + 1];
        sums.assign(static_cast<std::size_t>(end - first), 0.0);
        for (int k = first; k < end; ++k) index_of[static_cast<std::size_t>(rows_[k])] = k - first;
        for (int k = first; k < end; ++k) {
            const auto column = static_cast<std::size_t>(rows_[k]);
            const double l = values_[k];
            sums[static_cast<std::size_t>(k - first)] -= l * Z.diagonal_[column];
            for (int e = starts_[column]; e < starts_[column + 1]; ++e) {
                const int i = index_of[static_cast<std::size_t>(rows_[e])];
                if (i < 0) continue;
                sums[static_cast<std::size_t>(i)] -= l * Z.values_[e];
                sums[static_cast<std::size_t>(k - first)] -= values_[first + i] * Z.values_[e];
            }
        }
        double own = 1.0 / diagonal_[j];
        for (int k = first; k < end; ++k) {
            Z.values_[k] = sums[static_cast<std::size_t>(k - first)];
            own -= values_[k] * Z.values_[k];
            index_of[static_cast<std::size_t>(rows_[k])] = -1;
        }
        Z.diagonal_[j] = own;
    }
    return Z;
}

double SelectedInverse::at(std::size_t i, std::size_t j) const {
    const int a = std::min(place_[i], place_[j]), b = std::max(place_[i], place_[j]);
    if (a == b) return diagonal_[static_cast<std::size_t>(a)];
    const auto first = rows_.begin() + starts_[static_cast<std::size_t>(a)],
               end = rows_.begin() + starts_[static_cast<std::size_t>(a) + 1];
    const auto found = std::lower_bound(first, end, b);
    return found == end || *found != b ? 0.0 : values_[static_cast<std::size_t>(found - rows_.begin())];
}

}  // namespace covaria::adjustment
