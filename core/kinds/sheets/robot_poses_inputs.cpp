#include "core/kinds/sheets/robot_poses_inputs.h"

#include <cmath>

#include "core/kinds/sheets/scatter.h"

namespace covaria::sheets {

namespace {

class PerformanceInputBuilder {
public:
    PerformanceInputBuilder(const RobotPosesSetup& setup, const RobotPosesFigures& figures)
        : setup_(setup), figures_(figures) {}

    PerformanceInputs build() {
        inputs_.stride = setup_.has_angles() ? 10 : 4;
        for (std::size_t k = 0; k < setup_.series.size(); ++k) add_series(k);
        inputs_.first_place = inputs_.set.quantities.size();
        for (std::size_t p = 0; p < setup_.commanded.size(); ++p) add_place(p);
        inputs_.first_distance = inputs_.set.quantities.size();
        for (std::size_t d = 0; d < figures_.distances.size(); ++d) add_distance(d);
        inputs_.instrument = inputs_.set.quantities.size();
        if (figures_.instrument) add_instrument();
        return std::move(inputs_);
    }

private:
    static std::string number_of(std::size_t k) { return std::to_string(k + 1); }

    UncertaintyComponent scatter(std::string id, Message name, double u, int cycles) const {
        return residual_component(std::move(id), Unit::of("mm"), u, double(cycles - 1), std::move(name),
                                  tell<"%1 cycles">(cycles));
    }

    /// A figure of scatter times what few cycles leave open of it: a distribution of its own.
    void add_scaled(std::string symbol, Message name, const Unit& unit, double figure, Distribution factor,
                    int cycles, Name group) {
        UncertaintyComponent component;
        component.id = symbol + ".cycles";
        component.name = tell<"few cycles">();
        component.distribution = std::move(factor);
        component.type = EvaluationType::type_a;
        component.origin = tell<"%1 cycles, normal scatter of the shape seen">(cycles);
        InputQuantity quantity{
            .symbol = std::move(symbol), .name = std::move(name), .unit = unit, .group = std::move(group)};
        if (figure > 0.0) quantity.shares.push_back({inputs_.set.add(std::move(component)), figure});
        inputs_.set.quantities.push_back(std::move(quantity));
    }

    void add_series(std::size_t k) {
        const PoseSeries& series = setup_.series[k];
        const SeriesFigures& f = figures_.series[k];
        const double n = double(series.cycles());
        VarianceEstimate estimate{"barycentre " + number_of(k), {}};
        std::array<std::size_t, 3> components{InputSet::npos, InputSet::npos, InputSet::npos};
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            const std::string symbol = std::string(pose_axes[std::size_t(axis)]) + "_" + number_of(k);
            const double u = std::sqrt(f.covariance(axis, axis) / n);
            InputQuantity quantity{.symbol = symbol,
                                   .name = tell<"deviation of the barycentre of %1, %2">(
                                       label_of(series), pose_axes[std::size_t(axis)]),
                                   .unit = Unit::of("mm"),
                                   .offset = f.barycentre[axis] - series.commanded[axis],
                                   .group = group_of(setup_.series[k])};
            if (u > 0.0) {
                components[std::size_t(axis)] = inputs_.set.add(
                    scatter(symbol + ".cycles", tell<"scatter of the cycles">(), u, series.cycles()));
                quantity.shares.push_back({components[std::size_t(axis)], 1.0});
                estimate.components.push_back(components[std::size_t(axis)]);
            }
            inputs_.set.quantities.push_back(std::move(quantity));
        }
        for (Eigen::Index i = 0; i < 3; ++i)
            for (Eigen::Index j = 0; j < i; ++j)
                if (components[std::size_t(i)] != InputSet::npos &&
                    components[std::size_t(j)] != InputSet::npos)
                    inputs_.set.correlations.push_back(
                        {components[std::size_t(j)], components[std::size_t(i)],
                         f.covariance(i, j) / std::sqrt(f.covariance(i, i) * f.covariance(j, j))});
        if (estimate.components.size() > 1) inputs_.set.variance_estimates.push_back(std::move(estimate));
        add_scaled("R_" + number_of(k), tell<"repeatability of %1">(label_of(series)), Unit::of("mm"), f.rp,
                   f.law.factor(), series.cycles(), group_of(setup_.series[k]));
        if (setup_.has_angles()) add_angles(k);
    }

    void add_angles(std::size_t k) {
        const PoseSeries& series = setup_.series[k];
        const SeriesFigures& f = figures_.series[k];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double u = f.s_angles[Eigen::Index(axis)] / std::sqrt(double(series.cycles()));
            const std::string symbol = std::string(pose_angles[axis]) + "_" + number_of(k);
            UncertaintyComponent component =
                scatter(symbol + ".cycles", tell<"scatter of the cycles">(), u, series.cycles());
            component.unit = Unit::of("deg");
            InputQuantity quantity{
                .symbol = symbol,
                .name = tell<"mean deviation of angle %1 of %2">(pose_angles[axis], label_of(series)),
                .unit = Unit::of("deg"),
                .offset = f.angles[Eigen::Index(axis)],
                .group = group_of(setup_.series[k])};
            if (u > 0.0) quantity.shares.push_back({inputs_.set.add(std::move(component)), 1.0});
            inputs_.set.quantities.push_back(std::move(quantity));
        }
        for (std::size_t axis = 0; axis < 3; ++axis)
            add_scaled("R" + std::string(pose_angles[axis]) + "_" + number_of(k),
                       tell<"repeatability of angle %1 of %2">(pose_angles[axis], label_of(series)),
                       Unit::of("deg"), 3.0 * f.s_angles[Eigen::Index(axis)],
                       deviation_factor(double(series.cycles() - 1)), series.cycles(),
                       group_of(setup_.series[k]));
    }

    UncertaintyComponent of_instrument(std::string id, double u) const {
        UncertaintyComponent component;
        component.id = std::move(id);
        component.name = tell<"instrument and base of the robot">();
        component.unit = Unit::of("mm");
        component.distribution = Distribution::normal(u);
        component.origin = tell<"u of a measured coordinate">();
        return component;
    }

    /// Adds the deviations that instrument and base add to all cycles of a pose.
    void add_place(std::size_t p) {
        for (const char* axis : pose_axes) {
            const std::string symbol = std::string("e") + axis + "_" + std::to_string(p + 1);
            inputs_.set.add(
                {.symbol = symbol,
                 .name = tell<"error of the measured place of %1, %2">(setup_.commanded[p].pose, axis),
                 .unit = Unit::of("mm"),
                 .group = own_name<"instrument">()},
                {of_instrument(symbol + ".instrument", setup_.u_place)});
        }
    }

    void add_distance(std::size_t d) {
        const DistanceFigures& f = figures_.distances[d];
        const std::string symbol = "D_" + std::to_string(d + 1);
        const Name group = own_name<"distance %1">(f.label);
        std::vector<UncertaintyComponent> own{
            of_instrument(symbol + ".instrument", std::sqrt(2.0) * setup_.u_place)};
        if (f.s > 0.0)
            own.push_back(scatter(symbol + ".cycles", tell<"scatter of the cycles">(),
                                  f.s / std::sqrt(double(f.cycles)), f.cycles));
        inputs_.set.add({.symbol = symbol,
                         .name = tell<"deviation of the mean distance %1">(f.label),
                         .unit = Unit::of("mm"),
                         .offset = f.mean - f.commanded,
                         .group = group},
                        std::move(own));
        add_scaled("RD_" + std::to_string(d + 1), tell<"repeatability of distance %1">(f.label),
                   Unit::of("mm"), 3.0 * f.s, deviation_factor(double(f.cycles - 1)), f.cycles, group);
    }

    void add_instrument() {
        const int cycles = setup_.instrument == InstrumentScatter::stated ? setup_.instrument_cycles
                                                                          : int(setup_.fixed_target.size());
        add_scaled("RP_I", tell<"repeatability of the instrument alone">(), Unit::of("mm"),
                   figures_.instrument->rp, figures_.instrument->law.factor(), cycles,
                   own_name<"instrument">());
    }

    const RobotPosesSetup& setup_;
    const RobotPosesFigures& figures_;
    PerformanceInputs inputs_;
};

}  // namespace

Name group_of(const PoseSeries& series) {
    return own_name<"pose %1">(label_of(series));
}

PerformanceInputs performance_inputs(const RobotPosesSetup& setup, const RobotPosesFigures& figures) {
    return PerformanceInputBuilder(setup, figures).build();
}

}  // namespace covaria::sheets
