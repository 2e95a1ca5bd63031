#include "core/kinds/groups/evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/adjustment/adjustment.h"
#include "core/evidence/plain_readings.h"
#include "core/evidence/seen.h"

namespace covaria::group_observations {

namespace {

using evidence::RedundantReadings;

/// A row of the equations: l = (mean + deviation of its group) * `of_mean` + deviation within.
struct GroupRow {
    Message name;
    std::size_t group = 0;
    double value = 0.0;    ///< SI, less the reference of the set-up
    double of_mean = 1.0;  ///< 0: a contrast, orthonormal to the mean and the others of its group
    double within = 1.0;   ///< share of the deviation within: 1/sqrt(n) of a mean
    bool is_observed = true;
};

std::vector<GroupRow> rows_of_observations(const GroupSetup& setup) {
    std::vector<GroupRow> rows;
    std::vector<std::size_t> counted(setup.groups.size());
    for (const StatedGroups::Observation& row : setup.observations) {
        const auto at = std::ranges::find(setup.groups, row.group, &Group::name) - setup.groups.begin();
        const auto group = static_cast<std::size_t>(at);
        rows.push_back({.name = tell<"%1, observation %2">(row.group, ++counted[group]),
                        .group = group,
                        .value = setup.unit.to_si(row.value) - setup.reference});
    }
    return rows;
}

/// A mean and contrasts that have the sum of squares say what the observations would.
std::vector<GroupRow> rows_of_summaries(const GroupSetup& setup) {
    std::vector<GroupRow> rows;
    for (std::size_t j = 0; j < setup.groups.size(); ++j) {
        const Group& group = setup.groups[j];
        rows.push_back({.name = tell<"mean of %1">(group.name),
                        .group = j,
                        .value = group.mean,
                        .within = 1.0 / std::sqrt(group.count)});
        const auto contrasts = static_cast<std::size_t>(group.count) - 1;
        for (std::size_t k = 0; k < contrasts; ++k)
            rows.push_back({.name = tell<"%1, contrast %2">(group.name, k + 1),
                            .group = j,
                            .value = std::sqrt(group.sum_of_squares / static_cast<double>(contrasts)),
                            .of_mean = 0.0,
                            .is_observed = false});
    }
    return rows;
}

evidence::StatedFigure figure_within(const GroupSetup& setup) {
    return {.name = tell<"scatter within the groups">(),
            .unit = setup.unit.interval(),
            .least = *setup.stated_within,
            .most = *setup.stated_within,
            .source = group_fields().place(&StatedGroups::stated_within)};
}

RedundantReadings described(const GroupSetup& setup, const std::vector<GroupRow>& rows) {
    RedundantReadings readings;
    readings.residuals.resize(static_cast<Eigen::Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        readings.residuals[static_cast<Eigen::Index>(i)] = rows[i].value;
        readings.names.push_back(rows[i].name);
    }
    readings.figures.push_back(figure_within(setup));
    readings.figures.front().count = rows.size();
    return readings;
}

/// The means of the groups are unknowns, each of its own readings alone.
RedundantReadings within_alone(const GroupSetup& setup, const std::vector<GroupRow>& rows) {
    RedundantReadings readings = described(setup, rows);
    const auto n = static_cast<Eigen::Index>(rows.size());
    std::vector<Eigen::Triplet<double>> design;
    Eigen::VectorXd u(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const GroupRow& row = rows[static_cast<std::size_t>(i)];
        const Group& group = setup.groups[row.group];
        u[i] = row.within * *setup.stated_within;
        if (row.of_mean != 0.0) {
            design.emplace_back(i, static_cast<Eigen::Index>(row.group), row.of_mean);
            readings.residuals[i] -= group.mean;
        }
        const double redundancy = row.within == 1.0 ? 1.0 - 1.0 / group.count : 0.0;
        readings.w.push_back(redundancy > 0.0 ? readings.residuals[i] / (u[i] * std::sqrt(redundancy))
                                              : std::numeric_limits<double>::quiet_NaN());
    }
    readings.design.resize(n, static_cast<Eigen::Index>(setup.groups.size()));
    readings.design.setFromTriplets(design.begin(), design.end());
    readings.whitening = adjustment::whitening(u, {});
    readings.figure_of.assign(rows.size(), 0);
    return readings;
}

/// One mean of all is unknown; groups deviate from it.
RedundantReadings within_and_between(const GroupSetup& setup, const std::vector<GroupRow>& rows) {
    RedundantReadings readings = described(setup, rows);
    const auto n = static_cast<Eigen::Index>(rows.size()), J = static_cast<Eigen::Index>(setup.groups.size());
    Eigen::MatrixXd design(n, 1), within = Eigen::MatrixXd::Zero(n, n), between = Eigen::MatrixXd::Zero(n, J);
    for (Eigen::Index i = 0; i < n; ++i) {
        const GroupRow& row = rows[static_cast<std::size_t>(i)];
        design(i, 0) = row.of_mean;
        within(i, i) = row.within * *setup.stated_within;
        between(i, static_cast<Eigen::Index>(row.group)) = row.of_mean * *setup.stated_between;
    }
    readings.figures.push_back({.name = tell<"scatter between the groups">(),
                                .unit = setup.unit.interval(),
                                .least = *setup.stated_between,
                                .most = *setup.stated_between,
                                .count = setup.groups.size(),
                                .source = group_fields().place(&StatedGroups::stated_between)});
    readings.shares = {std::move(within), std::move(between)};
    return evidence::readings_together(std::move(readings), design);
}

}  // namespace

std::shared_ptr<const RedundantReadings> redundant_readings(const GroupSetup& setup) {
    if (!setup.stated_within) return nullptr;
    double observations = 0.0;
    for (const Group& group : setup.groups) observations += group.count;
    const std::size_t most = setup.stated_between ? most_held_between : evidence::most_readings;
    if (observations > static_cast<double>(most)) return nullptr;
    const std::vector<GroupRow> rows =
        setup.data == StatedGroups::Data::summary ? rows_of_summaries(setup) : rows_of_observations(setup);
    RedundantReadings readings =
        setup.stated_between ? within_and_between(setup, rows) : within_alone(setup, rows);
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (!rows[i].is_observed) readings.w[i] = std::numeric_limits<double>::quiet_NaN();
    return std::make_shared<const RedundantReadings>(std::move(readings));
}

}  // namespace covaria::group_observations
