// A network of sensors as one source of points: what each reading and each shared deviation does to points
// measured together, by weighted least squares (Galetto et al., Eqs 1-5).
#include "core/kinds/network/asset.h"
#include "core/kinds/instruments/linear_reading.h"
#include "core/kinds/instruments/sensor.h"
#include "core/kinds/network/adjustment.h"
#include "core/kinds/network/setup.h"
#include "core/kinds/points/point_uncertainty.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

namespace {

using Member = network::Sensor;

/// The readings of points measured together, linearised at the points.
struct Readings {
    Eigen::MatrixXd to_points;               ///< J: readings x 3 points
    Eigen::MatrixXd shared;                  ///< readings x shared deviations, per unit of each
    Eigen::VectorXd scale;                   ///< what the own deviation of a reading is multiplied by
    std::vector<JointDeviation> deviations;  ///< of the readings, then the shared ones; without directions

    double standard_uncertainty(Eigen::Index deviation) const {
        return deviations[static_cast<std::size_t>(deviation)].component.distribution.standard_uncertainty();
    }
    /// Of the readings alone.
    Eigen::VectorXd u() const {
        Eigen::VectorXd u(scale.size());
        for (Eigen::Index i = 0; i < u.size(); ++i) u[i] = scale[i] * standard_uncertainty(i);
        return u;
    }
    /// The columns of `shared` for deviations of standard uncertainty one.
    Eigen::MatrixXd unit_shared() const {
        Eigen::MatrixXd F = shared;
        for (Eigen::Index k = 0; k < F.cols(); ++k) F.col(k) *= standard_uncertainty(scale.size() + k);
        return F;
    }
};

class ReadingCollector {
public:
    ReadingCollector(const std::vector<Member>& members, const std::vector<Eigen::Vector3d>& points)
        : members_(members), points_(points) {}

    Readings collect() {
        for (std::size_t p = 0; p < points_.size(); ++p)
            for (std::size_t m = 0; m < members_.size(); ++m) add_sight(m, p);
        const auto rows = static_cast<Eigen::Index>(rows_.size());
        readings_.to_points.setZero(rows, static_cast<Eigen::Index>(3 * points_.size()));
        readings_.scale.resize(rows);
        for (Eigen::Index i = 0; i < rows; ++i) {
            const Row& row = rows_[static_cast<std::size_t>(i)];
            readings_.to_points.block<1, 3>(i, static_cast<Eigen::Index>(3 * row.point)) = row.to_point;
            readings_.scale[i] = row.scale;
        }
        readings_.shared.resize(rows, 0);
        for (std::size_t m = 0; m < members_.size(); ++m) add_shared(m);
        return std::move(readings_);
    }

private:
    struct Row {
        std::size_t member, point;
        Eigen::RowVector3d to_point;
        double scale;
        Eigen::RowVectorXd shared;  ///< by the member's shared components
    };

    void add_sight(std::size_t m, std::size_t point) {
        const Member& member = members_[m];
        const SensorSource& sensor = *member;
        const LinearReading s = linear_reading(sensor.station(), points_[point]);
        if (!sensor.sees(s.v)) return;
        const Eigen::Matrix3Xd effects = shared_effects(sensor, s);
        for (Observable o : observables) {
            if (!sensor.reads(o)) continue;
            const int i = static_cast<int>(o);
            rows_.push_back({m, point, s.to_point.row(i), s.scale(o), effects.row(i)});
            UncertaintyComponent component = sensor.reading(o, s.v);
            component.name = tell<"%1, %2">(member.name, words_of(o));
            component.id = member.id + "." + words_of(o).english();
            readings_.deviations.push_back(
                {component.id, component.name, std::move(component), point, {}, {}});
        }
    }

    void add_shared(std::size_t m) {
        const Member& member = members_[m];
        Eigen::Index k = -1;
        for (UncertaintyComponent& component : shared_components(*member)) {
            ++k;
            if (!(component.distribution.standard_uncertainty() > 0.0)) continue;
            Eigen::MatrixXd& F = readings_.shared;
            F.conservativeResize(Eigen::NoChange, F.cols() + 1);
            for (std::size_t i = 0; i < rows_.size(); ++i)
                F(static_cast<Eigen::Index>(i), F.cols() - 1) =
                    rows_[i].member == m ? rows_[i].shared[k] : 0.0;
            const std::string id = component.id;
            component.name = tell<"%1, %2">(member.name, component.name);
            readings_.deviations.push_back({id, component.name, std::move(component), {}, member.id, {}});
        }
    }

    const std::vector<Member>& members_;
    const std::vector<Eigen::Vector3d>& points_;
    std::vector<Row> rows_;
    Readings readings_;
};

class SensorNetwork : public Asset, public PointUncertaintySource {
public:
    SensorNetwork(std::vector<Member> members, bool with_stations)
        : members_(std::move(members)), with_stations_(with_stations) {
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
        Readings readings = ReadingCollector(members_, points).collect();
        const Eigen::MatrixXd gain = gain_of(readings);
        const Eigen::Index rows = readings.scale.size();
        Eigen::MatrixXd moves(gain.rows(), rows + readings.shared.cols());
        moves << gain * readings.scale.asDiagonal(), gain * readings.shared;
        for (Eigen::Index k = 0; k < moves.cols(); ++k)
            for (std::size_t p = 0; p < points.size(); ++p)
                readings.deviations[static_cast<std::size_t>(k)].directions.push_back(
                    moves.col(k).segment<3>(static_cast<Eigen::Index>(3 * p)));
        return std::move(readings.deviations);
    }

    Message objection(const Eigen::Vector3d& p) const override {
        const std::vector<Eigen::Vector3d> points{p};
        std::string seeing;
        for (const Member& member : members_) {
            const Eigen::Vector3d v = member->station().X_WS().inverse() * p;
            if (v.norm() == 0.0) return tell<"it is at the place of %1">(member.name);
            if (member->sees(v)) seeing += (seeing.empty() ? "" : ", ") + member.name;
        }
        if (seeing.empty()) return tell<"no sensor of the network sees it">();
        if (localises(ReadingCollector(members_, points).collect().to_points)) return {};
        return tell<
            "it cannot be localised from what %1 read: the readings leave a direction undetermined; "
            "add a sensor or a reading">(seeing);
    }

    std::vector<Eigen::Vector3d> stations_seeing(const Eigen::Vector3d& p) const override {
        std::vector<Eigen::Vector3d> stations;
        for (const Member& member : members_) {
            const Eigen::Isometry3d X_WS = member->station().X_WS();
            if (member->sees(X_WS.inverse() * p)) stations.push_back(X_WS.translation());
        }
        return stations;
    }

    std::vector<DataTable> evaluation() const override {
        const Unit mm = Unit::of("mm");
        DataTable table;
        table.id = "sensors";
        table.title = "Sensors of the network";
        table.columns = {{.header = "sensor"},
                         {.header = "reads"},
                         {.header = "x", .unit = mm, .digits = 2},
                         {.header = "y", .unit = mm, .digits = 2},
                         {.header = "z", .unit = mm, .digits = 2}};
        for (const Member& member : members_) {
            std::string reads;
            for (Observable o : observables)
                if (member->reads(o)) reads += (reads.empty() ? "" : ", ") + words_of(o).english();
            const auto& at = member->station().coordinates;
            table.rows.push_back({member.name, reads, at[0], at[1], at[2]});
        }
        return {table};
    }

    Layout layout() const override {
        Layout layout;
        for (const Member& member : members_) {
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
    /// With weights of the readings alone, or with what they share.
    Eigen::MatrixXd gain_of(const Readings& r) const {
        const Eigen::MatrixXd F = r.unit_shared();
        const Eigen::VectorXd u = weighting_uncertainties(r.to_points, r.u(), F);
        return least_squares_gain(r.to_points, u, with_stations_ ? F : Eigen::MatrixXd(F.rows(), 0));
    }

    std::vector<Member> members_;
    bool with_stations_;
};

struct StatedSource {
    network::SensorList sensors;
    bool with_stations = true;
};

const Fields<StatedSource>& source_fields() {
    static const auto fields =
        Fields<StatedSource>()
            .section("Network")
            .part(&StatedSource::sensors, network::sensor_list_fields())
            .choice(&StatedSource::with_stations, "weights", "Weights",
                    "What the weights of the readings account for. With the stations, all points of one "
                    "analysis are estimated together.",
                    {{true, "with-stations", "readings and stations, all points at once"},
                     {false, "observations", "readings alone, each point by itself"}},
                    true);
    return fields;
}

std::unique_ptr<Asset> create_network(const SetupReader& setup, const AssetLibrary& assets,
                                      Problems& problems) {
    const StatedSource stated = source_fields().read(setup, assets, problems);
    return std::make_unique<SensorNetwork>(network::sensors_of(stated.sensors, problems),
                                           stated.with_stations);
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
