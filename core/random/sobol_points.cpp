// Points in Gray code order, row by row.
#include "core/random/sobol_points.h"

#include <algorithm>
#include <bit>
#include <boost/random/sobol.hpp>

#include "core/random/philox.h"

namespace covaria {
namespace {

constexpr std::size_t most_dimensions = 3667;  // dimensions of Boost's table

/// 52 bits in the middle of their cell.
double to_unit(std::uint64_t word) {
    return (std::bit_cast<double>((word >> 12) | 0x3FF0000000000000u) - 1.0) + 0x1p-53;
}

}  // namespace

SobolPoints::SobolPoints(std::uint64_t seed, std::size_t components, std::size_t estimates,
                         std::uint64_t batch_trials)
    : seed_(seed),
      components_(components),
      batch_trials_(batch_trials),
      dimensions_(std::min(components + estimates, most_dimensions)) {
    // Point n is point n - 1 with direction number ctz(n) turned over: number k shows between 2^k - 1 and
    // 2^k.
    for (std::size_t k = 0; k < bits && !dimensions_.empty(); ++k) {
        boost::random::sobol engine(dimensions_.size());
        std::vector<std::uint64_t> before(dimensions_.size(), 0);
        if (k > 0) {
            engine.discard(dimensions_.size() * ((std::uint64_t{1} << k) - 2));
            for (std::uint64_t& x : before) x = engine();
        }
        for (std::size_t d = 0; d < dimensions_.size(); ++d)
            dimensions_[d].directions[k] = engine() ^ before[d];
    }
}

void SobolPoints::fill_batch(const Dimension& dimension, std::uint64_t shift, std::uint64_t index,
                             std::span<double> u) const {
    std::uint64_t point = shift;
    for (std::uint64_t gray = index ^ (index >> 1); gray != 0; gray &= gray - 1)
        point ^= dimension.directions[std::countr_zero(gray)];
    for (double& value : u) {
        value = to_unit(point);
        ++index;
        point ^= dimension.directions[std::min<std::size_t>(static_cast<std::size_t>(std::countr_zero(index)),
                                                            bits - 1)];
    }
}

void SobolPoints::fill(DrawPurpose purpose, std::uint32_t address, std::uint64_t first_trial,
                       std::span<double> u) const {
    const std::size_t place = address + (purpose == DrawPurpose::variance_estimates ? components_ : 0);
    if (place >= dimensions_.size()) return uniforms(seed_, purpose, address, first_trial, u);
    for (std::size_t done = 0; done < u.size();) {
        const std::uint64_t batch = (first_trial + done) / batch_trials_;
        const std::uint64_t index = (first_trial + done) % batch_trials_;
        const std::size_t count = std::min<std::size_t>(u.size() - done, batch_trials_ - index);
        const PhiloxCounter random = philox4x32(
            {static_cast<std::uint32_t>(batch), static_cast<std::uint32_t>(batch >> 32), address,
             static_cast<std::uint32_t>(DrawPurpose::sobol_shifts) + static_cast<std::uint32_t>(purpose)},
            {static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32)});
        const std::uint64_t shift = (std::uint64_t{random[1]} << 32) | random[0];
        fill_batch(dimensions_[place], shift, index, u.subspan(done, count));
        done += count;
    }
}

}  // namespace covaria
