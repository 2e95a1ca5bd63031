#include "core/kinds/network/sensor_evidence.h"

#include <algorithm>
#include <limits>
#include <map>

#include "core/evidence/plain_readings.h"

namespace covaria::network {

namespace {

using evidence::RedundantReadings;

constexpr double no_height = std::numeric_limits<double>::quiet_NaN();

class SensorReadings {
public:
    explicit SensorReadings(const NetworkSetup& setup) : setup_(setup) {
        for (const JointSetUp& joint : setup.set_ups) {
            rows_ += static_cast<Eigen::Index>(joint.bars.size());
            for (std::size_t t = joint.first; t < joint.first + joint.targets; ++t)
                rows_ += static_cast<Eigen::Index>(setup.targets[t].rows);
        }
    }

    std::shared_ptr<const RedundantReadings> take() {
        const auto unknowns = static_cast<Eigen::Index>(3 * setup_.targets.size());
        if (rows_ <= unknowns || rows_ > static_cast<Eigen::Index>(most_joint_rows)) return nullptr;
        design_ = Eigen::MatrixXd::Zero(rows_, unknowns);
        others_ = Eigen::MatrixXd::Zero(rows_, systematic() + stations());
        described_.residuals.resize(rows_);
        described_.abscissas = {{tell<"distance">(), Unit::of("m"), {}},
                                {tell<"height">(), Unit::of("m"), {}}};
        for (const JointSetUp& joint : setup_.set_ups) add(joint);
        for (const auto& [figure, rows] : rows_of_figures_) {
            Eigen::MatrixXd share = Eigen::MatrixXd::Zero(rows_, static_cast<Eigen::Index>(rows.size()));
            for (std::size_t k = 0; k < rows.size(); ++k) share(rows[k], static_cast<Eigen::Index>(k)) = 1.0;
            described_.shares.push_back(std::move(share));
        }
        described_.others = std::move(others_);
        return std::make_shared<const RedundantReadings>(
            evidence::readings_together(std::move(described_), design_));
    }

private:
    Eigen::Index systematic() const {
        std::size_t count = 0;
        for (const Sensor& sensor : setup_.sensors) count += sensor->systematic().size();
        return static_cast<Eigen::Index>(count);
    }
    Eigen::Index stations() const {
        return static_cast<Eigen::Index>(6 * setup_.sensors.size() * setup_.stations);
    }

    /// Rows are over their u: distances and angles count alike.
    void add(const JointSetUp& joint) {
        const Sensitivities s = sensitivities_of(setup_, joint);
        const Eigen::VectorXd by_u = s.u.cwiseInverse();
        const Eigen::Index first = row_, n = s.u.size();
        design_.block(first, static_cast<Eigen::Index>(3 * joint.first), n, s.to_point.cols()) =
            by_u.asDiagonal() * s.to_point;
        described_.residuals.segment(first, n) = by_u.cwiseProduct(residuals_of(setup_, joint));
        add_shared(joint, by_u.asDiagonal() * s.shared);
        for (std::size_t t = joint.first; t < joint.first + joint.targets; ++t)
            for (const Sight& sight : setup_.targets[t].sights)
                for (std::size_t o = 0; o < 3; ++o)
                    if (sight.has[o]) add_reading(setup_.targets[t], sight, o, s.u[row_ - first]);
        for (const std::size_t b : joint.bars) add_bar(setup_.bars[b]);
    }

    /// Columns of a sensor: its systematic deviations, which all set-ups share, then its station.
    void add_shared(const JointSetUp& joint, const Eigen::MatrixXd& shared) {
        Eigen::Index from = 0, to = 0;
        for (std::size_t k = 0; k < setup_.sensors.size(); ++k) {
            const auto own = static_cast<Eigen::Index>(setup_.sensors[k]->systematic().size());
            others_.block(row_, to, shared.rows(), own) = shared.middleCols(from, own);
            others_.block(
                row_, systematic() + static_cast<Eigen::Index>(6 * (joint.index * setup_.sensors.size() + k)),
                shared.rows(), 6) = shared.middleCols(from + own, 6);
            from += own + 6;
            to += own;
        }
    }

    void add_reading(const Target& target, const Sight& sight, std::size_t o, double u) {
        static const std::array<Message, 3> kinds{tell<"distances">(), tell<"azimuths">(),
                                                  tell<"elevations">()};
        const Sensor& sensor = setup_.sensors[sight.sensor];
        evidence::StatedFigure& figure =
            figure_of({sight.sensor, o}, {.name = tell<"%1 of %2">(kinds[o], sensor.name),
                                          .unit = Unit::of(o == 0 ? "mm" : "arcsec"),
                                          .source = sight.source[o]});
        // An azimuth near the zenith is read by its effect, in metres.
        if (!(sight.overhead && observables[o] == Observable::azimuth)) {
            figure.least = figure.most == 0.0 ? u : std::min(figure.least, u);
            figure.most = std::max(figure.most, u);
        }
        described_.names.push_back(tell<"%1 to %2, %3">(sensor.name, target.name, kinds[o]));
        described_.abscissas[0].values.push_back(
            setup_.station(target, sight).in_axes(target.nominal).norm());
        described_.abscissas[1].values.push_back(target.nominal.z());
    }

    void add_bar(const ScaleBar& bar) {
        evidence::StatedFigure& figure =
            figure_of({setup_.sensors.size(), 0},
                      {.name = tell<"calibrated lengths">(), .unit = Unit::of("mm"), .source = bar.source});
        figure.least = figure.most == 0.0 ? bar.u : std::min(figure.least, bar.u);
        figure.most = std::max(figure.most, bar.u);
        described_.names.push_back(bar.name);
        described_.abscissas[0].values.push_back(bar.length);
        described_.abscissas[1].values.push_back(no_height);
    }

    /// The figure of the next row.
    evidence::StatedFigure& figure_of(std::pair<std::size_t, std::size_t> key, evidence::StatedFigure made) {
        const auto [known, added] = numbers_.try_emplace(key, described_.figures.size());
        if (added) described_.figures.push_back(std::move(made));
        evidence::StatedFigure& figure = described_.figures[known->second];
        ++figure.count;
        rows_of_figures_[known->second].push_back(row_++);
        described_.figure_of.push_back(known->second);
        return figure;
    }

    const NetworkSetup& setup_;
    Eigen::Index rows_ = 0, row_ = 0;
    Eigen::MatrixXd design_, others_;
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> numbers_;  ///< by sensor and kind of reading
    std::map<std::size_t, std::vector<Eigen::Index>> rows_of_figures_;
    RedundantReadings described_;
};

}  // namespace

std::shared_ptr<const RedundantReadings> sensor_evidence(const NetworkSetup& setup) {
    if (!setup.measured) return nullptr;
    return SensorReadings(setup).take();
}

}  // namespace covaria::network
