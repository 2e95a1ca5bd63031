// Least squares of the rounds of a theodolite: residuals, scatter, index error.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/kinds/sheets/scatter.h"
#include "core/kinds/sheets/theodolite_setup.h"
#include "core/text/plot_specification.h"
#include "core/text/table.h"

namespace covaria::sheets {

/// A sum of squares with its degrees of freedom.
struct PooledScatter {
    double squares = 0.0, degrees_of_freedom = 0.0;

    PooledScatter& operator+=(const PooledScatter& more) {
        squares += more.squares;
        degrees_of_freedom += more.degrees_of_freedom;
        return *this;
    }
    explicit operator bool() const { return degrees_of_freedom > 0.0; }
    double s() const { return std::sqrt(squares / degrees_of_freedom); }
    double u_s() const { return u_of_deviation(s(), degrees_of_freedom); }
};

/// The readings of the index error, a mean with the scatter about it.
struct IndexReadings {
    double mean = 0.0;
    std::size_t count = 0;
    PooledScatter scatter;
};

struct TheodoliteSeries {
    std::string name;
    PooledScatter directions, zeniths;
    IndexReadings index;
};

/// s of a direction and of a zenith angle, each the mean of both faces: pooled over the series, of each of
/// which they are residuals of its own least squares (a direction: orientation of the set + direction of the
/// target).
struct TheodoliteFit {
    std::vector<TheodoliteSeries> series;
    std::vector<std::optional<double>> direction_residuals, zenith_residuals;  ///< of each row
    std::vector<double> directions;  ///< of each row: direction of its target in its series, the first at 0
    PooledScatter directions_pooled, zeniths_pooled;
    IndexReadings index;  ///< of all series; its scatter is that within the series

    double u_index() const { return index.scatter.s() / std::sqrt(double(index.count)); }
    /// Ratio of the variance of the index between the series to that within them; empty: nothing to compare.
    std::optional<double> index_ratio() const;
    double series_with_index() const;
};

TheodoliteFit fit_of(const TheodoliteSetup& setup);

std::vector<Table> theodolite_tables(const TheodoliteSetup& setup, const TheodoliteFit& fit);
std::vector<PlotSpecification> theodolite_figures(const TheodoliteFit& fit);

}  // namespace covaria::sheets
