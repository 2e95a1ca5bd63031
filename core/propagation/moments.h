// Sums of powers and products of the outputs, about a fixed shift: means, covariance, skewness, kurtosis.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "core/base/bytes.h"
#include "core/propagation/trial_rows.h"

namespace covaria::detail {

/// Sums are exact functions of the order of blocks, so merging in block order gives the same bits for any
/// number of threads. The shift (a value near the mean) keeps the sums well conditioned (gum_algorithms:
/// JCGM 101 9.5 has y near 5e7 u).
class Moments {
public:
    /// Products are summed among the first `outputs` rows, and among the others (linear parts).
    Moments(Eigen::VectorXd shift, Eigen::Index outputs);
    explicit Moments(const Eigen::VectorXd& shift) : Moments(shift, shift.size()) {}
    void clear();
    /// Adds `count` trials; row j of the outputs begins at `first_row + j * block_trials`. `scratch` has one
    /// row per output. No allocation.
    void add(const double* first_row, std::size_t count, TrialRows& scratch);
    void merge(const Moments& other);
    /// The sums, without the shift.
    void write(ByteWriter& writer) const;
    void read(ByteReader& reader);  ///< into moments of as many rows

    std::uint64_t count() const { return count_; }
    double mean(Eigen::Index j) const;
    double variance(Eigen::Index j) const;  ///< divisor count - 1 (JCGM 101 7.6)
    Eigen::VectorXd means() const;
    Eigen::VectorXd standard_uncertainties() const;
    Eigen::MatrixXd covariance() const;  ///< JCGM 102 7.6, Eq. 16; of the outputs
    Eigen::MatrixXd covariance_of_linear_parts() const;
    double skewness(Eigen::Index j) const;  ///< 0 for zero spread
    double kurtosis(Eigen::Index j) const;  ///< excess; 0 for zero spread

private:
    struct Central {
        double m2, m3, m4;
    };
    Central central(Eigen::Index j) const;
    Eigen::MatrixXd covariance_among(const Eigen::MatrixXd& products, Eigen::Index first) const;

    std::uint64_t count_ = 0;
    Eigen::VectorXd shift_;
    Eigen::ArrayX4d powers_;           ///< sums of d, d^2, d^3, d^4
    Eigen::MatrixXd products_;         ///< sums of d_a d_b, lower triangle
    Eigen::MatrixXd linear_products_;  ///< likewise
};

}  // namespace covaria::detail
