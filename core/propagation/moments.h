// Sums of powers and products of the outputs, about a fixed shift: means, covariance, skewness, kurtosis.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/base/bytes.h"
#include "core/propagation/trial_rows.h"
#include "core/result/output_covariance.h"

namespace covaria::detail {

/// Sums are exact functions of the order of blocks, so merging in block order gives the same bits for any
/// number of threads. The shift (a value near the mean) keeps the sums well conditioned (gum_algorithms:
/// JCGM 101 9.5 has y near 5e7 u).
class Moments {
public:
    /// Products are summed within the blocks of the outputs, which come first, and of their linear parts.
    Moments(Eigen::VectorXd shift, const OutputBlocks& outputs, const OutputBlocks& linear_parts);
    explicit Moments(const Eigen::VectorXd& shift) : Moments(shift, OutputBlocks(shift.size()), {}) {}
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
    OutputCovariance covariance() const;  ///< JCGM 102 7.6, Eq. 16; of the outputs
    OutputCovariance covariance_of_linear_parts() const;
    double skewness(Eigen::Index j) const;  ///< 0 for zero spread
    double kurtosis(Eigen::Index j) const;  ///< excess; 0 for zero spread

private:
    struct Central {
        double m2, m3, m4;
    };
    Central central(Eigen::Index j) const;
    OutputCovariance covariance_among(const OutputCovariance& products, Eigen::Index first_row) const;
    /// use(sums, count), in the order of files.
    template <typename Self, typename Use>
    static void each_sum(Self& self, Use use);

    std::uint64_t count_ = 0;
    Eigen::VectorXd shift_;
    Eigen::ArrayX4d powers_;            ///< sums of d, d^2, d^3, d^4
    OutputCovariance products_;         ///< sums of d_a d_b, lower triangles of the blocks
    OutputCovariance linear_products_;  ///< the same for the linear parts
};

}  // namespace covaria::detail
