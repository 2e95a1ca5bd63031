// Sums of powers and products in vector code.
#include "core/propagation/moments.h"

#include <algorithm>
#include <cmath>
#include <xsimd/xsimd.hpp>

namespace covaria::detail {
namespace {

using Lanes = xsimd::batch<double>;
static_assert(8 % Lanes::size == 0);

// Products are made of slices and tiles small enough for Eigen to pack them on the stack.
constexpr Eigen::Index slice_trials = 128;
constexpr Eigen::Index tile_outputs = 96;

/// d = y - shift, zeros in the lanes after the last trial; returns the sums of d, d^2, d^3, d^4.
Eigen::Array4d deviations_of(const double* y, double shift, std::size_t count, double* d) {
    Lanes s1(0.0), s2(0.0), s3(0.0), s4(0.0);
    const std::size_t padded = padded_to_lanes(count);
    for (std::size_t t = 0; t < count; ++t) d[t] = y[t] - shift;
    for (std::size_t t = count; t < padded; ++t) d[t] = 0.0;
    for (std::size_t t = 0; t < padded; t += Lanes::size) {
        const Lanes v = Lanes::load_aligned(d + t);
        const Lanes v2 = v * v;
        s1 += v;
        s2 += v2;
        s3 += v2 * v;
        s4 += v2 * v2;
    }
    return {xsimd::hadd(s1), xsimd::hadd(s2), xsimd::hadd(s3), xsimd::hadd(s4)};
}

/// Rows of `products.rows()` outputs, one after the other.
void add_products(const double* deviations, std::size_t count, Eigen::MatrixXd& products) {
    const Eigen::Index outputs = products.rows();
    const Eigen::Map<const Eigen::MatrixXd, Eigen::Aligned64> d(deviations, block_trials, outputs);
    const auto trials = static_cast<Eigen::Index>(count);
    for (Eigen::Index t = 0; t < trials; t += slice_trials) {
        const auto slice = d.middleRows(t, std::min(slice_trials, trials - t));
        for (Eigen::Index a = 0; a < outputs; a += tile_outputs) {
            const Eigen::Index na = std::min(tile_outputs, outputs - a);
            products.block(a, a, na, na)
                .selfadjointView<Eigen::Lower>()
                .rankUpdate(slice.middleCols(a, na).transpose());
            for (Eigen::Index b = 0; b < a; b += tile_outputs)
                products.block(a, b, na, tile_outputs).noalias() +=
                    slice.middleCols(a, na).transpose() * slice.middleCols(b, tile_outputs);
        }
    }
}

/// The rows of `products` begin at `first_row`.
void add_products(const TrialRows& deviations, Eigen::Index first_row, std::size_t count,
                  OutputCovariance& products) {
    for (std::size_t k = 0; k < products.blocks().list().size(); ++k)
        add_products(deviations.row(static_cast<std::size_t>(first_row + products.blocks().list()[k].first)),
                     count, products.block(k));
}

}  // namespace

Moments::Moments(Eigen::VectorXd shift, const OutputBlocks& outputs, const OutputBlocks& linear_parts)
    : shift_(std::move(shift)),
      powers_(Eigen::ArrayX4d::Zero(shift_.size(), 4)),
      products_(outputs),
      linear_products_(linear_parts) {}

template <typename Self, typename Use>
void Moments::each_sum(Self& self, Use use) {
    use(self.powers_.data(), static_cast<std::size_t>(self.powers_.size()));
    for (auto* products : {&self.products_, &self.linear_products_})
        for (std::size_t k = 0; k < products->blocks().list().size(); ++k)
            use(products->block(k).data(), static_cast<std::size_t>(products->block(k).size()));
}

void Moments::clear() {
    count_ = 0;
    each_sum(*this, [](double* sums, std::size_t count) { std::fill_n(sums, count, 0.0); });
}

void Moments::add(const double* first_row, std::size_t count, TrialRows& scratch) {
    if (count == 0) return;
    for (Eigen::Index j = 0; j < shift_.size(); ++j) {
        const auto row = static_cast<std::size_t>(j);
        powers_.row(j) +=
            deviations_of(first_row + row * block_trials, shift_(j), count, scratch.row(row)).transpose();
    }
    count_ += count;
    const std::size_t padded = padded_to_lanes(count);
    add_products(scratch, 0, padded, products_);
    add_products(scratch, products_.rows(), padded, linear_products_);
}

void Moments::merge(const Moments& other) {
    count_ += other.count_;
    powers_ += other.powers_;
    for (std::size_t k = 0; k < products_.blocks().list().size(); ++k)
        products_.block(k) += other.products_.block(k);
    for (std::size_t k = 0; k < linear_products_.blocks().list().size(); ++k)
        linear_products_.block(k) += other.linear_products_.block(k);
}

void Moments::write(ByteWriter& writer) const {
    writer.put(count_);
    each_sum(*this, [&](const double* sums, std::size_t count) { writer.put_all(std::span(sums, count)); });
}

void Moments::read(ByteReader& reader) {
    count_ = reader.get<std::uint64_t>();
    each_sum(*this, [&](double* sums, std::size_t count) { reader.get_all(std::span(sums, count)); });
}

double Moments::mean(Eigen::Index j) const {
    return shift_(j) + powers_(j, 0) / static_cast<double>(count_);
}

double Moments::variance(Eigen::Index j) const {
    if (count_ < 2) return 0.0;
    const auto n = static_cast<double>(count_);
    return std::max(0.0, (powers_(j, 1) - powers_(j, 0) * powers_(j, 0) / n) / (n - 1));
}

Eigen::VectorXd Moments::means() const {
    return Eigen::VectorXd::NullaryExpr(shift_.size(), [this](Eigen::Index j) { return mean(j); });
}

Eigen::VectorXd Moments::standard_uncertainties() const {
    return Eigen::VectorXd::NullaryExpr(shift_.size(),
                                        [this](Eigen::Index j) { return std::sqrt(variance(j)); });
}

OutputCovariance Moments::covariance() const {
    return covariance_among(products_, 0);
}

OutputCovariance Moments::covariance_of_linear_parts() const {
    return covariance_among(linear_products_, products_.rows());
}

OutputCovariance Moments::covariance_among(const OutputCovariance& products, Eigen::Index first_row) const {
    const auto n = static_cast<double>(count_);
    OutputCovariance result(products.blocks());
    if (count_ < 2) return result;
    for (std::size_t k = 0; k < products.blocks().list().size(); ++k) {
        const Eigen::Index first = first_row + products.blocks().list()[k].first;
        const Eigen::MatrixXd& sums = products.block(k);
        Eigen::MatrixXd& block = result.block(k);
        for (Eigen::Index a = 0; a < sums.rows(); ++a) {
            block(a, a) = variance(first + a);
            for (Eigen::Index b = 0; b < a; ++b)
                block(a, b) = block(b, a) =
                    (sums(a, b) - powers_(first + a, 0) * powers_(first + b, 0) / n) / (n - 1);
        }
    }
    return result;
}

Moments::Central Moments::central(Eigen::Index j) const {
    const auto n = static_cast<double>(count_);
    const double mu = powers_(j, 0) / n;
    const double a2 = powers_(j, 1) / n, a3 = powers_(j, 2) / n, a4 = powers_(j, 3) / n;
    return {a2 - mu * mu, a3 - 3 * mu * a2 + 2 * mu * mu * mu,
            a4 - 4 * mu * a3 + 6 * mu * mu * a2 - 3 * mu * mu * mu * mu};
}

double Moments::skewness(Eigen::Index j) const {
    if (!(variance(j) > 0)) return 0.0;
    const Central c = central(j);
    const double skewness = c.m3 / (c.m2 * std::sqrt(c.m2));
    return std::isfinite(skewness) ? skewness : 0.0;
}

double Moments::kurtosis(Eigen::Index j) const {
    if (!(variance(j) > 0)) return 0.0;
    const Central c = central(j);
    const double kurtosis = c.m4 / (c.m2 * c.m2) - 3.0;
    return std::isfinite(kurtosis) ? kurtosis : 0.0;
}

}  // namespace covaria::detail
