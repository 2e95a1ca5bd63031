#include "core/kinds/sheets/robot_poses_figures.h"

#include <algorithm>
#include <cmath>

namespace covaria::sheets {

namespace {

/// Simulated campaigns of a law; fewer where so many cycles are drawn that a reader of the form would wait.
int campaigns_of(const RobotPosesSetup& setup) {
    double cycles = 1.0;
    for (const PoseSeries& series : setup.series) cycles += std::min(300.0, double(series.cycles()));
    return int(std::clamp(1e7 / cycles, 500.0, 4000.0));
}

SeriesFigures figures_of_series(const RobotPosesSetup& setup, const PoseSeries& series, int campaigns) {
    SeriesFigures f;
    f.barycentre = series.points.colwise().mean().transpose();
    f.covariance = covariance_of(series.points);
    f.rp = repeatability(series.points);
    f.law = repeatability_law(principal_deviations(series.points), series.cycles(), campaigns);
    const auto commanded = std::ranges::find(setup.commanded, series.pose, &CommandedPose::pose);
    f.pose = std::size_t(commanded - setup.commanded.begin());
    if (series.angles.rows() == 0) return f;
    f.angles = series.angles.colwise().mean().transpose();
    f.s_angles = covariance_of(series.angles).diagonal().cwiseSqrt();
    return f;
}

DistanceFigures figures_of_pair(const RobotPosesSetup& setup, const PosePair& pair) {
    const PoseSeries& from = *std::ranges::find(setup.series, pair.from, &PoseSeries::pose);
    const PoseSeries& to = *std::ranges::find(setup.series, pair.to, &PoseSeries::pose);
    const Eigen::ArrayXd lengths = (to.points - from.points).rowwise().norm().array();
    DistanceFigures f{pair.from + " – " + pair.to, (to.commanded - from.commanded).norm(), lengths.mean(),
                      0.0, from.cycles()};
    f.s = std::sqrt((lengths - f.mean).square().sum() / double(f.cycles - 1));
    return f;
}

std::optional<SeenRepeatability> figures_of_instrument(const RobotPosesSetup& setup) {
    if (setup.instrument == InstrumentScatter::none) return std::nullopt;
    if (setup.instrument == InstrumentScatter::stated)
        return SeenRepeatability{setup.instrument_rp,
                                 repeatability_law(Eigen::Vector3d::Ones(), setup.instrument_cycles)};
    Eigen::MatrixX3d points(Eigen::Index(setup.fixed_target.size()), 3);
    for (std::size_t i = 0; i < setup.fixed_target.size(); ++i)
        points.row(Eigen::Index(i)) = setup.fixed_target[i].p.transpose();
    return SeenRepeatability{repeatability(points),
                             repeatability_law(principal_deviations(points), int(points.rows()))};
}

/// Series that agree in what `same` compares, where there are two or more.
template <class Same>
std::vector<std::vector<std::size_t>> together(const std::vector<PoseSeries>& series, Same same) {
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < series.size(); ++i) {
        const auto found = std::ranges::find_if(
            groups, [&](const auto& group) { return same(series[group.front()], series[i]); });
        if (found == groups.end())
            groups.push_back({i});
        else
            found->push_back(i);
    }
    std::erase_if(groups, [](const auto& group) { return group.size() < 2; });
    return groups;
}

}  // namespace

double SeriesFigures::u_ap(const PoseSeries& series) const {
    const Eigen::Vector3d deviation = barycentre - series.commanded;
    const double length = deviation.norm();
    const double variance = length > 0.0 ? deviation.dot(covariance * deviation) / (length * length)
                                         : covariance.diagonal().maxCoeff();
    return std::sqrt(variance / double(series.cycles()));
}

double SeriesFigures::floor_of_ap(const PoseSeries& series) const {
    return mean_length(principal_deviations(series.points)) / std::sqrt(double(series.cycles()));
}

RobotPosesFigures figures_of(const RobotPosesSetup& setup) {
    RobotPosesFigures all;
    const int campaigns = campaigns_of(setup);
    for (const PoseSeries& series : setup.series)
        all.series.push_back(figures_of_series(setup, series, campaigns));
    for (const PosePair& pair : setup.pairs) all.distances.push_back(figures_of_pair(setup, pair));
    all.instrument = figures_of_instrument(setup);
    for (const SeriesFigures& f : all.series)
        all.is_split.push_back(all.instrument && f.best_rp() > all.instrument->best_rp());
    all.directions = together(setup.series, [](const PoseSeries& a, const PoseSeries& b) {
        return a.pose == b.pose && a.time == b.time;
    });
    all.drifts = together(setup.series, [](const PoseSeries& a, const PoseSeries& b) {
        return a.pose == b.pose && a.direction == b.direction && a.time && b.time;
    });
    for (auto& group : all.drifts)
        std::ranges::sort(group, {}, [&](std::size_t k) { return *setup.series[k].time; });
    return all;
}

}  // namespace covaria::sheets
