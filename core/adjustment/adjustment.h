// Least squares of readings by their unknowns (Gauss-Markov model), which knows no family: normal equations,
// what they leave open, the datum, cofactors.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "core/adjustment/sparse_factor.h"

namespace covaria::adjustment {

/// Readings that have a covariance in common.
struct CovarianceBlock {
    std::vector<std::size_t> readings;
    Eigen::MatrixXd covariance;
};

/// W with Wᵀ W = C⁻¹ of all readings: W r are residuals of standard uncertainty one, independent of each
/// other. `u` > 0 of each reading; a block stands for the u of its readings. Empty: a block's matrix is not
/// positive definite.
SparseRows whitening(const Eigen::VectorXd& u, const std::vector<CovarianceBlock>& blocks);

/// The normal equations of readings linearised at some place. A stated unknown is a reading of itself; a
/// fixed one is none.
///
/// Unknowns are scaled to columns of length one before anything is decided. Directions that no reading
/// determines are the null space G of the design; those of them that move the unknowns of the datum are
/// taken there (inner constraints: the sum of squares of the datum's changes is least), by an
/// S-transformation of the solution with as many unknowns held (W. Baarda 1973): x = (I − G (GᵀBG)⁻¹ GᵀB)
/// x_held, B: the datum.
class Adjustment {
public:
    /// `design`: readings x unknowns; `whitening`: as above; `datum`: numbers of unknowns. `like`: an
    /// adjustment of the same readings at another place, whose order of elimination is taken.
    Adjustment(SparseRows design, const SparseRows& whitening, const std::vector<std::size_t>& datum,
               const Adjustment* like = nullptr);

    std::size_t unknowns() const { return static_cast<std::size_t>(scale_.size()); }
    std::size_t readings() const { return static_cast<std::size_t>(whitened_.rows()); }
    /// Directions that no reading determines, by columns; the datum's share of them is orthonormal.
    const Eigen::MatrixXd& undetermined() const { return undetermined_; }
    std::size_t defect() const { return static_cast<std::size_t>(undetermined_.cols()); }
    /// Undetermined directions that the datum does not determine either, in unknowns of their scaled size;
    /// without any the equations are solved.
    const Eigen::MatrixXd& open() const { return open_; }
    bool is_solved() const { return open_.cols() == 0 && factor_ != nullptr; }
    /// Readings less unknowns plus defect.
    int degrees_of_freedom() const {
        return static_cast<int>(readings()) - static_cast<int>(unknowns()) + static_cast<int>(defect());
    }
    /// Size of each unknown that the readings see as one: columns of the whitened design have this length.
    const Eigen::VectorXd& scale() const { return scale_; }
    const SparseRows& whitened() const { return whitened_; }

    /// x := Q x for x = Aᵀ W r: the changes of the unknowns, for double or for `Lanes` of such x. `scratch`:
    /// `scratch_size()` numbers. No allocation.
    template <class Number>
    void step(Number* x, Number* scratch) const;
    std::size_t scratch_size() const { return 2 * unknowns() + defect(); }
    Eigen::VectorXd step(const Eigen::VectorXd& gradient) const;
    /// x less its part that only the datum decides: zero change of the datum.
    void to_datum(Eigen::VectorXd& x) const;

    /// Q e: the column of the cofactor matrix, or of several by e.
    Eigen::VectorXd cofactors(const Eigen::VectorXd& e) const;
    /// Element of Q of two unknowns that are the same or that one reading connects.
    double cofactor(std::size_t i, std::size_t j) const;
    /// a Q bᵀ of two readings (whitened) that are the same or in one block.
    double cofactor_of_readings(std::size_t a, std::size_t b) const;
    /// a Q aᵀ of every reading.
    Eigen::VectorXd cofactors_of_readings() const;

private:
    /// A factor of all unknowns, whose order others take; null where there is none.
    const SparseFactor* order() const { return ridged_ ? ridged_.get() : factor_.get(); }
    void take_to_datum(const std::vector<std::size_t>& datum);
    void factorise(const SparseColumns& normal);
    /// x := Z x, the changes where the unknowns `held_` do not move.
    template <class Number>
    void solve_held(Number* x, Number* scratch) const;
    const SelectedInverse& inverse() const;
    double held_cofactor(std::size_t i, std::size_t j) const;

    SparseRows whitened_;
    Eigen::VectorXd scale_;
    Eigen::MatrixXd undetermined_, open_;
    std::vector<std::size_t> datum_, held_;
    std::vector<std::ptrdiff_t> reduced_;         ///< number of each unknown among those not held; -1: held
    std::shared_ptr<const SparseFactor> ridged_;  ///< factor with a ridge, where something may be open
    std::shared_ptr<const SparseFactor> factor_;
    mutable std::shared_ptr<const SelectedInverse> inverse_;  ///< made when it is first asked for
    Eigen::MatrixXd datum_cofactors_, of_datum_;  ///< Z B G and GᵀB Z B G, Z = Q with those held
};

}  // namespace covaria::adjustment
