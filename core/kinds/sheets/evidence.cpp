#include "core/kinds/sheets/evidence.h"

#include <map>

#include "core/evidence/plain_readings.h"

namespace covaria::sheets {

namespace {

using evidence::RedundantReadings;

/// Readings of rounds: the orientation of each set, where it has one, and each target of a series are
/// unknown.
class RoundsAsReadings {
public:
    explicit RoundsAsReadings(const TheodoliteSetup& setup) : setup_(setup) {}

    /// `stated`: the figure of the readings; without one nothing is added.
    void add(const std::optional<double>& stated, const std::vector<std::optional<double>>& residuals,
             bool with_orientations, evidence::StatedFigure figure) {
        if (!stated) return;
        for (std::size_t row = 0; row < residuals.size(); ++row) {
            if (!residuals[row]) continue;
            const FaceReadings& r = setup_.readings[row];
            Row made{column_of({figures_.size(), r.series, "target", r.target}), no_column, *stated,
                     -*residuals[row]};
            if (with_orientations) made.orientation = column_of({figures_.size(), r.series, "set", r.set});
            rows_.push_back(made);
            described_.figure_of.push_back(figures_.size());
            described_.names.push_back(
                tell<"%1 in set %2 of series %3, %4">(r.target, r.set, r.series, figure.name));
        }
        figures_.push_back(std::move(figure));
    }

    std::shared_ptr<const RedundantReadings> take() {
        if (rows_.empty()) return nullptr;
        const auto n = static_cast<Eigen::Index>(rows_.size());
        Eigen::MatrixXd design = Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(columns_.size()));
        Eigen::VectorXd u(n);
        described_.residuals.resize(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            const Row& row = rows_[static_cast<std::size_t>(i)];
            design(i, row.target) = 1.0;
            if (row.orientation != no_column) design(i, row.orientation) = 1.0;
            u[i] = row.u;
            described_.residuals[i] = row.residual;
        }
        described_.figures = figures_;
        return std::make_shared<const RedundantReadings>(
            evidence::readings_apart(std::move(described_), design, u));
    }

private:
    static constexpr Eigen::Index no_column = -1;
    struct Row {
        Eigen::Index target, orientation;
        double u, residual;
    };
    struct Unknown {
        std::size_t figure;
        std::string series, kind, name;
        auto operator<=>(const Unknown&) const = default;
    };
    Eigen::Index column_of(Unknown unknown) {
        return columns_.emplace(std::move(unknown), static_cast<Eigen::Index>(columns_.size())).first->second;
    }

    const TheodoliteSetup& setup_;
    std::map<Unknown, Eigen::Index> columns_;
    std::vector<Row> rows_;
    std::vector<evidence::StatedFigure> figures_;
    RedundantReadings described_;
};

}  // namespace

std::shared_ptr<const RedundantReadings> redundant_readings(const DistanceMeterSetup& setup,
                                                            const DistanceMeterFit& fit) {
    if (!setup.stated_s) return nullptr;
    RedundantReadings described;
    described.residuals = -fit.residuals;
    described.figure_of.assign(setup.readings.size(), 0);
    described.figures = {{.name = tell<"distances">(),
                          .unit = Unit::of("mm"),
                          .source = distance_meter_fields().place(&DistanceMeterSetup::stated_s)}};
    described.abscissas = {{tell<"distance">(), Unit::of("m"), {}}};
    for (const BaselineReading& reading : setup.readings) {
        described.names.push_back(tell<"%1 to %2">(reading.from, reading.to));
        described.abscissas.front().values.push_back(reading.distance);
    }
    const Eigen::VectorXd u = Eigen::VectorXd::Constant(fit.residuals.size(), *setup.stated_s);
    return std::make_shared<const RedundantReadings>(
        evidence::readings_apart(std::move(described), fit.design, u));
}

std::shared_ptr<const RedundantReadings> redundant_readings(const TheodoliteSetup& setup,
                                                            const TheodoliteFit& fit) {
    const auto figure = [](Message name, std::string source) {
        return evidence::StatedFigure{
            .name = std::move(name), .unit = Unit::of("arcsec"), .source = std::move(source)};
    };
    // The first field of each part states its figure.
    const auto& fields = theodolite_fields();
    RoundsAsReadings rounds(setup);
    rounds.add(setup.direction_tests.stated, fit.direction_residuals, true,
               figure(tell<"directions">(), fields.place(&TheodoliteSetup::direction_tests)));
    rounds.add(setup.zenith_tests.stated, fit.zenith_residuals, false,
               figure(tell<"zenith angles">(), fields.place(&TheodoliteSetup::zenith_tests)));
    return rounds.take();
}

}  // namespace covaria::sheets
