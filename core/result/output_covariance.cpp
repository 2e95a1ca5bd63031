// Blocks of covariances.
#include "core/result/output_covariance.h"

#include <algorithm>
#include <limits>
#include <map>
#include <string>

namespace covaria {

OutputBlocks::OutputBlocks(Eigen::Index outputs) : block_of_(static_cast<std::size_t>(outputs), 0) {
    if (outputs > 0) blocks_.push_back({0, outputs});
}

OutputBlocks::OutputBlocks(std::vector<Block> blocks) : blocks_(std::move(blocks)) {
    for (std::size_t k = 0; k < blocks_.size(); ++k)
        block_of_.insert(block_of_.end(), static_cast<std::size_t>(blocks_[k].size), k);
}

OutputBlocks OutputBlocks::of(const std::vector<OutputQuantity>& outputs) {
    if (outputs.size() <= most_in_one_block) return OutputBlocks(static_cast<Eigen::Index>(outputs.size()));
    std::map<std::string, std::size_t> last;  // output of each group
    for (std::size_t j = 0; j < outputs.size(); ++j) last[outputs[j].group] = j;
    std::vector<Block> blocks;
    std::size_t end = 0;  // end of the block that is being made: groups that interlock share one
    for (std::size_t j = 0; j < outputs.size(); ++j) {
        if (j >= end) blocks.push_back({static_cast<Eigen::Index>(j), 0});
        ++blocks.back().size;
        end = std::max(end, last[outputs[j].group] + 1);
    }
    return OutputBlocks(std::move(blocks));
}

OutputCovariance::OutputCovariance(Eigen::MatrixXd all) : blocks_(all.rows()) {
    if (all.rows() > 0) values_.push_back(std::move(all));
}

OutputCovariance::OutputCovariance(const OutputBlocks& blocks) : blocks_(blocks) {
    for (const OutputBlocks::Block& block : blocks.list())
        values_.push_back(Eigen::MatrixXd::Zero(block.size, block.size));
}

const Eigen::MatrixXd& OutputCovariance::whole() const {
    static const Eigen::MatrixXd nothing;
    return values_.empty() ? nothing : values_.front();
}

Eigen::MatrixXd& OutputCovariance::whole() {
    if (values_.empty()) values_.emplace_back();
    return values_.front();
}

double OutputCovariance::operator()(Eigen::Index i, Eigen::Index j) const {
    const std::size_t block = blocks_.block_of(i);
    if (block != blocks_.block_of(j)) return std::numeric_limits<double>::quiet_NaN();
    const Eigen::Index first = blocks_.list()[block].first;
    return values_[block](i - first, j - first);
}

Eigen::MatrixXd OutputCovariance::among(const std::vector<std::size_t>& outputs) const {
    const auto size = static_cast<Eigen::Index>(outputs.size());
    return Eigen::MatrixXd::NullaryExpr(size, size, [&](Eigen::Index i, Eigen::Index j) {
        return (*this)(static_cast<Eigen::Index>(outputs[static_cast<std::size_t>(i)]),
                       static_cast<Eigen::Index>(outputs[static_cast<std::size_t>(j)]));
    });
}

void OutputCovariance::set(Eigen::Index output, double value) {
    const std::size_t block = blocks_.block_of(output);
    const Eigen::Index row = output - blocks_.list()[block].first;
    values_[block].row(row).setConstant(value);
    values_[block].col(row).setConstant(value);
}

}  // namespace covaria
