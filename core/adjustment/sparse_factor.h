// A sparse symmetric positive definite matrix in factors: solutions without allocation, and those elements of
// its inverse that the sparsity leaves.
#pragma once

#include <Eigen/SparseCore>
#include <cstddef>
#include <memory>
#include <vector>

namespace covaria::adjustment {

using SparseColumns = Eigen::SparseMatrix<double>;
using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// The order of elimination, and where the factor has elements. The columns before `root` are sparse; those
/// from there on (stations, which nearly all points connect) are one dense block.
struct EliminationOrder {
    std::vector<int> place;         ///< position of each unknown in the order of elimination
    std::vector<int> starts, rows;  ///< elements below the diagonal of the sparse columns, by rising row
    int root = 0;
    std::vector<int> of_starts, of_rows;  ///< pattern of the matrix that the order was made for

    int size() const { return static_cast<int>(place.size()); }
    bool fits(const SparseColumns& lower) const;
};

std::shared_ptr<const EliminationOrder> elimination_order(const SparseColumns& lower);

/// Elements of an inverse where the factor has some (K. Takahashi, J. Fagan, M.-S. Chen 1973): all pairs of
/// unknowns that one reading connects are among them.
class SelectedInverse {
public:
    /// 0 where the element was not computed.
    double at(std::size_t i, std::size_t j) const;
    /// a Z aᵀ of each row a of A, whose columns are first divided by their `scale`; `number`: the unknown of
    /// each column, negative for columns that do not count.
    Eigen::VectorXd quadratic_forms(const SparseRows& A, const std::vector<std::ptrdiff_t>& number,
                                    const Eigen::VectorXd& scale) const;

private:
    friend class SparseFactor;
    std::shared_ptr<const EliminationOrder> order_;
    std::vector<double> values_, diagonal_;  ///< of the sparse columns
    Eigen::MatrixXd root_;
};

/// P N Pᵀ = L D Lᵀ, in an order in which unknowns with few neighbours (points) go first.
class SparseFactor {
public:
    /// Takes the lower triangle; false: the matrix is not positive definite. The order of `like` is taken
    /// where the matrix has the same pattern.
    bool factorise(const SparseColumns& lower, const SparseFactor* like = nullptr);

    std::size_t size() const { return order_ ? order_->place.size() : 0; }
    /// The least pivot: an upper bound of the least eigenvalue.
    double least_pivot() const;
    /// b := N⁻¹ b, for double or for `Lanes` of right-hand sides; `scratch` has room for `size()` numbers. No
    /// allocation.
    template <class Number>
    void solve(Number* b, Number* scratch) const;
    SelectedInverse selected_inverse() const;

private:
    bool factorise_root();
    template <class Number>
    void solve_root(Number* b) const;

    std::shared_ptr<const EliminationOrder> order_;
    std::vector<double> values_, diagonal_;  ///< L and D of the sparse columns
    Eigen::MatrixXd root_;                   ///< Cholesky factor of the dense block, its lower triangle
};

}  // namespace covaria::adjustment
