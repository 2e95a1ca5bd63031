// A sparse symmetric positive definite matrix in factors: solutions without allocation, and those elements of
// its inverse that the sparsity leaves.
#pragma once

#include <Eigen/SparseCore>
#include <cstddef>
#include <vector>

namespace covaria::adjustment {

using SparseColumns = Eigen::SparseMatrix<double>;
using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Elements of an inverse where the factor has some (K. Takahashi, J. Fagan, M.-S. Chen 1973): all pairs of
/// unknowns that one reading connects are among them.
class SelectedInverse {
public:
    /// 0 where the element was not computed.
    double at(std::size_t i, std::size_t j) const;

private:
    friend class SparseFactor;
    std::vector<int> place_;  ///< position of each unknown in the order of elimination
    std::vector<int> starts_, rows_;
    std::vector<double> values_, diagonal_;
};

/// P N Pᵀ = L D Lᵀ, in an order in which unknowns with few neighbours (points) go first.
class SparseFactor {
public:
    /// Takes the lower triangle; false: the matrix is not positive definite.
    bool factorise(const SparseColumns& lower);

    std::size_t size() const { return diagonal_.size(); }
    /// b := N⁻¹ b; `scratch` has room for `size()` numbers. No allocation.
    void solve(double* b, double* scratch) const;
    SelectedInverse selected_inverse() const;

private:
    std::vector<int> place_;  ///< position of each unknown in the order of elimination
    std::vector<int> starts_, rows_;
    std::vector<double> values_, diagonal_;
};

}  // namespace covaria::adjustment
