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

}  // namespace

Moments::Moments(Eigen::VectorXd shift, Eigen::Index outputs)
    : shift_(std::move(shift)),
      powers_(Eigen::ArrayX4d::Zero(shift_.size(), 4)),
      products_(Eigen::MatrixXd::Zero(outputs, outputs)),
      linear_products_(Eigen::MatrixXd::Zero(shift_.size() - outputs, shift_.size() - outputs)) {}

void Moments::clear() {
    count_ = 0;
    powers_.setZero();
    products_.setZero();
    linear_products_.setZero();
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
    add_products(scratch.data(), padded, products_);
    if (linear_products_.size() > 0)
        add_products(scratch.row(static_cast<std::size_t>(products_.rows())), padded, linear_products_);
}

void Moments::merge(const Moments& other) {
    count_ += other.count_;
    powers_ += other.powers_;
    products_ += other.products_;
    linear_products_ += other.linear_products_;
}

void Moments::write(ByteWriter& writer) const {
    writer.put(count_);
    for (const auto& sums :
         {std::span(powers_.data(), static_cast<std::size_t>(powers_.size())),
          std::span(products_.data(), static_cast<std::size_t>(products_.size())),
          std::span(linear_products_.data(), static_cast<std::size_t>(linear_products_.size()))})
        writer.put_all(sums);
}

void Moments::read(ByteReader& reader) {
    count_ = reader.get<std::uint64_t>();
    for (const auto& sums :
         {std::span(powers_.data(), static_cast<std::size_t>(powers_.size())),
          std::span(products_.data(), static_cast<std::size_t>(products_.size())),
          std::span(linear_products_.data(), static_cast<std::size_t>(linear_products_.size()))})
        reader.get_all(sums);
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

Eigen::MatrixXd Moments::covariance() const {
    return covariance_among(products_, 0);
}

Eigen::MatrixXd Moments::covariance_of_linear_parts() const {
    return covariance_among(linear_products_, products_.rows());
}

Eigen::MatrixXd Moments::covariance_among(const Eigen::MatrixXd& products, Eigen::Index first) const {
    const auto n = static_cast<double>(count_);
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(products.rows(), products.rows());
    if (count_ < 2) return result;
    for (Eigen::Index a = 0; a < products.rows(); ++a) {
        result(a, a) = variance(first + a);
        for (Eigen::Index b = 0; b < a; ++b)
            result(a, b) = result(b, a) =
                (products(a, b) - powers_(first + a, 0) * powers_(first + b, 0) / n) / (n - 1);
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
