// A network of sensors as one source of points: the set-up of the model "points from sensors", made for the
// points that are asked for and linearised there (Galetto et al., Eqs 1-5).
#include "core/kinds/network/asset.h"
#include "core/kinds/instruments/linear_reading.h"
#include "core/kinds/instruments/sensor.h"
#include "core/kinds/network/adjustment.h"
#include "core/kinds/network/setup.h"
#include "core/kinds/points/point_uncertainty.h"
#include "core/quantity/input_quantity.h"

#include <algorithm>

namespace covaria {

namespace {

using network::NetworkSetup;
using network::Sensor;

/// Moves of the points of a network by each reading and each shared deviation: the least-squares gain times
/// it.
class Deviations {
public:
    explicit Deviations(const NetworkSetup& setup) : setup_(setup) {
        for (const Sensor& sensor : setup.sensors)
            for (UncertaintyComponent& component : shared_components(*sensor)) {
                component.name = tell<"%1, %2">(sensor.name, component.name);
                component.stated_by = sensor.id;
                shared_.push_back({component.id,
                                   component.name,
                                   std::move(component),
                                   {},
                                   sensor.id,
                                   std::vector<Eigen::Vector3d>(setup.targets.size(), no_move)});
            }
    }

    std::vector<JointDeviation> all() {
        for (const network::JointSetUp& joint : setup_.set_ups) add(joint);
        std::erase_if(shared_, [](const JointDeviation& d) { return !(u_of(d) > 0.0); });
        of_readings_.insert(of_readings_.end(), shared_.begin(), shared_.end());
        return std::move(of_readings_);
    }

private:
    static double u_of(const JointDeviation& d) { return d.component.distribution.standard_uncertainty(); }

    void add(const network::JointSetUp& joint) {
        const network::Sensitivities all = network::sensitivities_of(setup_, joint);
        const bool weighted = setup_.weights == network::Weights::with_stations;
        const Eigen::MatrixXd gain = least_squares_gain(
            all.to_point, all.u, weighted ? all.shared : Eigen::MatrixXd(all.shared.rows(), 0));
        const Eigen::MatrixXd shared = gain * all.shared;
        for (std::size_t k = 0; k < shared_.size(); ++k)
            if (const double u = u_of(shared_[k]); u > 0.0)
                move(joint, shared.col(Eigen::Index(k)) / u, shared_[k]);
        Eigen::Index row = 0;
        for (std::size_t t = joint.first; t < joint.first + joint.targets; ++t)
            for (const network::Sight& sight : setup_.targets[t].sights)
                for (Observable o : observables)
                    if (sight.has[std::size_t(o)]) add(joint, t, sight, o, gain.col(row++));
    }

    void add(const network::JointSetUp& joint, std::size_t target, const network::Sight& sight, Observable o,
             const Eigen::VectorXd& gain) {
        const Sensor& sensor = setup_.sensors[sight.sensor];
        const LinearReading reading = sensitivity_of(setup_, setup_.targets[target], sight);
        UncertaintyComponent component = sensor->reading(o, reading.v);
        component.name = tell<"%1, %2">(sensor.name, words_of(o));
        component.stated_by = sensor.id;
        component.id = sensor.id + "." + words_of(o).english();
        of_readings_.push_back({component.id,
                                component.name,
                                std::move(component),
                                target,
                                {},
                                std::vector<Eigen::Vector3d>(setup_.targets.size(), no_move)});
        move(joint, gain * reading.scale(o), of_readings_.back());
    }

    static void move(const network::JointSetUp& joint, const Eigen::VectorXd& moves,
                     JointDeviation& deviation) {
        for (std::size_t t = 0; t < joint.targets; ++t)
            deviation.directions[joint.first + t] = moves.segment<3>(Eigen::Index(3 * t));
    }

    inline static const Eigen::Vector3d no_move = Eigen::Vector3d::Zero();
    const NetworkSetup& setup_;
    std::vector<JointDeviation> of_readings_, shared_;
};

class SensorNetwork : public Asset, public PointUncertaintySource {
public:
    SensorNetwork(network::SensorList list, network::Weights weights, Problems& problems)
        : list_(std::move(list)), sensors_(network::sensors_of(list_, problems)), weights_(weights) {
        offer(*this);
    }

    Axes axes() const override { return Axes::world; }

    std::vector<PointDeviation> deviations(const Eigen::Vector3d& p) const override {
        std::vector<PointDeviation> found;
        for (JointDeviation& d : joint_deviations({p})) {
            const std::string id = d.owner.empty() ? d.id : d.owner + "." + d.id;
            found.push_back({id, d.name, d.directions[0], std::move(d.component), !d.point.has_value()});
        }
        return found;
    }

    std::vector<JointDeviation> joint_deviations(const std::vector<Eigen::Vector3d>& points) const override {
        Problems problems;
        std::optional<NetworkSetup> setup = setup_for(points, problems);
        if (!setup) return {};
        network::divide_set_ups(*setup, problems);
        network::find_weights(*setup, problems);
        if (problems.has_errors()) return {};
        return Deviations(*setup).all();
    }

    Message objection(const Eigen::Vector3d& p) const override {
        std::string seeing;
        for (const Sensor& sensor : sensors_) {
            const Eigen::Vector3d v = StationGeometry(sensor->station()).in_axes(p);
            if (v.norm() == 0.0) return tell<"it is at the place of %1">(sensor.name);
            if (sensor->sees(v)) seeing += (seeing.empty() ? "" : ", ") + sensor.name;
        }
        if (seeing.empty()) return tell<"no sensor of the network sees it">();
        Problems problems;
        const std::optional<NetworkSetup> setup = setup_for({p}, problems);
        if (!setup) return first_error(problems);
        if (localises(network::sensitivities_of(*setup, setup->set_ups.front()).to_point)) return {};
        return tell<
            "it cannot be localised from what %1 read: the readings leave a direction undetermined; "
            "add a sensor or a reading">(seeing);
    }

    std::vector<Eigen::Vector3d> stations_seeing(const Eigen::Vector3d& p) const override {
        std::vector<Eigen::Vector3d> stations;
        for (const Sensor& member : sensors_) {
            const Eigen::Isometry3d X_WS = member->station().X_WS();
            if (member->sees(X_WS.inverse() * p)) stations.push_back(X_WS.translation());
        }
        return stations;
    }

    std::vector<Table> evaluation() const override {
        const Unit mm = Unit::of("mm");
        Table table{"sensors", "Sensors of the network"};
        table.add("sensor");
        table.add("reads");
        table.add("x").in(mm).figure(2);
        table.add("y").in(mm).figure(2);
        table.add("z").in(mm).figure(2);
        for (const Sensor& member : sensors_) {
            Message reads;
            for (Observable o : observables)
                if (member->reads(o)) reads += Message(reads.empty() ? "" : ", ") + words_of(o);
            const auto& at = member->station().coordinates;
            table.row({member.name, reads, at[0], at[1], at[2]});
        }
        return {table};
    }

    Layout layout() const override {
        Layout layout;
        for (const Sensor& member : sensors_) {
            const Layout own = as_part(member.asset->layout(), member.id);
            for (LayoutBody body : own.bodies) {
                body.name = member.name;
                layout.bodies.push_back(std::move(body));
            }
            for (LayoutPoint point : own.points) {
                point.name = member.name;
                layout.points.push_back(std::move(point));
            }
            layout.links.insert(layout.links.end(), own.links.begin(), own.links.end());
        }
        return layout;
    }

private:
    /// The model's set-up of the points that are asked for.
    std::optional<NetworkSetup> setup_for(const std::vector<Eigen::Vector3d>& points,
                                          Problems& problems) const {
        network::StatedNetwork stated;
        stated.sensors = list_;
        stated.weights = weights_;
        for (std::size_t i = 0; i < points.size(); ++i)
            stated.targets.push_back({.name = std::to_string(i + 1), .nominal = points[i]});
        return network::network_setup(stated, problems);
    }

    static Message first_error(const Problems& problems) {
        const auto found = std::ranges::find(problems.items(), Severity::error, &Problem::severity);
        return found == problems.items().end() ? Message() : found->message;
    }

    network::SensorList list_;
    std::vector<Sensor> sensors_;
    network::Weights weights_;
};

struct StatedSource {
    network::SensorList sensors;
    network::Weights weights = network::Weights::with_stations;
};

const Fields<StatedSource>& source_fields() {
    static const auto fields =
        Fields<StatedSource>()
            .section("Network")
            .part(&StatedSource::sensors, network::sensor_list_fields())
            .choice(&StatedSource::weights, "weights", "Weights",
                    "What the weights of the readings account for. With the stations, all points of one "
                    "analysis are estimated together.",
                    {{network::Weights::with_stations, "with-stations",
                      "readings and stations, all points at once"},
                     {network::Weights::observations_only, "observations",
                      "readings alone, each point by itself"}},
                    network::Weights::with_stations);
    return fields;
}

std::unique_ptr<Asset> create_network(const SetupReader& setup, const AssetLibrary& assets,
                                      Problems& problems) {
    const StatedSource stated = source_fields().read(setup, assets, problems);
    return std::make_unique<SensorNetwork>(stated.sensors, stated.weights, problems);
}

}  // namespace

AssetDescriptor sensor_network_kind() {
    AssetDescriptor d;
    d.kind = "sensor-network";
    d.title = "Network of sensors";
    d.category = AssetCategory::instrument;
    d.summary =
        "Instruments of the project that measure the same points together. Points measured by the network "
        "keep what they share: the scale and the station of each instrument.";
    d.references = {
        {"M. Galetto, L. Mastrogiacomo, D. A. Maisano, F. Franceschini: Uncertainty evaluation of "
         "distributed Large-Scale-Metrology systems by a Monte Carlo approach"}};
    d.notes = {
        "A point's deviations are the least-squares gain times those of the readings and stations, "
        "linearised "
        "at the point: exact to first order, and in Monte Carlo as long as the angles' deviations stay below "
        "about a milliradian.",
        "All points that an analysis takes from the network are measured from one set-up: none of its "
        "instruments is moved or located anew between them.",
        "A sensor contributes to a point that is in its range and field of view, and no others."};
    d.capabilities = {PointUncertaintySource::capability};
    d.schema = source_fields().schema();
    d.create = create_network;
    return d;
}

}  // namespace covaria
