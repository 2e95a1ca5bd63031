// Covariances of the outputs of a result: of every pair, or of thousands of outputs of those in one group.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/model/output_quantity.h"

namespace covaria {

/// Consecutive outputs whose covariances with each other are kept. The outputs of a group (coordinates of a
/// point, figures of a pose) are in one block.
class OutputBlocks {
public:
    struct Block {
        Eigen::Index first = 0;
        Eigen::Index size = 0;
    };

    OutputBlocks() = default;
    /// Makes one block.
    explicit OutputBlocks(Eigen::Index outputs);
    explicit OutputBlocks(std::vector<Block> blocks);
    /// Makes one block of up to `most_in_one_block` outputs, else one for each group: the matrix of more
    /// would be the largest thing of a result, in memory and in files, and hardly anybody reads it.
    static OutputBlocks of(const std::vector<OutputQuantity>& outputs);
    static constexpr std::size_t most_in_one_block = 1500;

    const std::vector<Block>& list() const { return blocks_; }
    Eigen::Index outputs() const { return static_cast<Eigen::Index>(block_of_.size()); }
    std::size_t block_of(Eigen::Index output) const { return block_of_[static_cast<std::size_t>(output)]; }
    bool is_one() const { return blocks_.size() <= 1; }

private:
    std::vector<Block> blocks_;
    std::vector<std::size_t> block_of_;  ///< block of each output
};

/// A symmetric matrix of which the blocks are kept; between blocks it is not known (NaN).
class OutputCovariance {
public:
    OutputCovariance() = default;
    /// Covariance of every pair. Not explicit: a matrix is a covariance of one block.
    OutputCovariance(Eigen::MatrixXd all);
    template <typename Derived>
    OutputCovariance(const Eigen::MatrixBase<Derived>& all) : OutputCovariance(Eigen::MatrixXd(all)) {}
    /// Zeros.
    explicit OutputCovariance(const OutputBlocks& blocks);

    const OutputBlocks& blocks() const { return blocks_; }
    Eigen::Index rows() const { return blocks_.outputs(); }
    bool is_whole() const { return blocks_.is_one(); }
    /// The covariance of every pair; only where it is whole.
    const Eigen::MatrixXd& whole() const;
    Eigen::MatrixXd& whole();
    Eigen::MatrixXd& block(std::size_t k) { return values_[k]; }
    const Eigen::MatrixXd& block(std::size_t k) const { return values_[k]; }

    double operator()(Eigen::Index i, Eigen::Index j) const;
    Eigen::MatrixXd among(const std::vector<std::size_t>& outputs) const;
    /// Writes the row and the column of an output.
    void set(Eigen::Index output, double value);

    friend bool operator==(const OutputCovariance& a, const OutputCovariance& b) {
        return a.values_ == b.values_;
    }

private:
    OutputBlocks blocks_;
    std::vector<Eigen::MatrixXd> values_;  ///< matrix of each block
};

}  // namespace covaria
