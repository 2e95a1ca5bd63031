// A network of sensors as one source of points: what each reading and each shared deviation does to points
// measured together, by weighted least squares (Galetto et al., Eqs 1-5).
#include <Eigen/Cholesky>
#include <Eigen/SVD>
#include <cmath>

#include "core/assets/kinds.h"

namespace covaria {

namespace {

struct Member {
    std::string id, name;
    std::shared_ptr<const Asset> asset;
    const SensorSource& sensor() const { return *asset->sensor(); }
};

std::string word_of(Observable observable) {
    static constexpr const char* words[] = {"distance", "azimuth", "elevation"};
    return words[static_cast<int>(observable)];
}

/// The readings of points measured together, linearised at the points.
struct Readings {
    Eigen::MatrixXd to_points;  ///< J: readings x 3 points
    Eigen::MatrixXd shared;     ///< F: readings x shared deviations, each of standard uncertainty one
    Eigen::VectorXd u;          ///< of the readings alone
};

/// Collects readings and what they depend on; the order of its deviations is that of J's rows, then F's
/// columns.
class ReadingCollector {
public:
    ReadingCollector(const std::vector<Member>& members, const std::vector<Eigen::Vector3d>& points)
        : members_(members), points_(points) {}

    void collect() {
        for (std::size_t p = 0; p < points_.size(); ++p)
            for (const Member& member : members_) add_sight(member, p);
        for (const Member& member : members_) add_shared(member);
    }

    std::vector<JointDeviation>& deviations() { return deviations_; }
    std::size_t readings() const { return rows_.size(); }
    double scale(std::size_t row) const { return rows_[row].scale; }

    Readings matrices() const {
        const auto rows = static_cast<Eigen::Index>(rows_.size());
        const auto columns = static_cast<Eigen::Index>(deviations_.size()) - rows;
        Readings r{Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(3 * points_.size())),
                   Eigen::MatrixXd::Zero(rows, columns), Eigen::VectorXd(rows)};
        for (Eigen::Index i = 0; i < rows; ++i) {
            const Row& row = rows_[static_cast<std::size_t>(i)];
            r.to_points.block<1, 3>(i, static_cast<Eigen::Index>(3 * row.point)) = row.to_point;
            r.u[i] = row.scale * standard_uncertainty(static_cast<std::size_t>(i));
        }
        for (Eigen::Index k = 0; k < columns; ++k)
            for (Eigen::Index i = 0; i < rows; ++i)
                r.shared(i, k) = effects_[static_cast<std::size_t>(k)][static_cast<std::size_t>(i)];
        return r;
    }

    double standard_uncertainty(std::size_t deviation) const {
        return deviations_[deviation].component.distribution.standard_uncertainty();
    }

private:
    struct Row {
        const Member* member;
        std::size_t point;
        Observable observable;
        Eigen::RowVector3d to_point;
        Eigen::Matrix<double, 1, 6> to_station;
        Eigen::Vector3d v;
        double scale;  ///< of the reading's own deviation
        bool undefined_azimuth;
    };

    void add_sight(const Member& member, std::size_t point) {
        const SensorSource& sensor = member.sensor();
        const Eigen::Vector3d v = sensor.station().X_WS().inverse() * points_[point];
        if (!sensor.sees(v)) return;
        const ReadingSensitivity s = reading_sensitivity(sensor.station(), points_[point]);
        for (Observable o : observables) {
            if (!sensor.reads(o)) continue;
            UncertaintyComponent component = sensor.reading(o, v);
            if (!(component.distribution.standard_uncertainty() > 0.0)) continue;
            const int i = static_cast<int>(o);
            const bool across = s.overhead && o == Observable::azimuth;
            rows_.push_back({&member, point, o, s.to_point.row(i), s.to_station.row(i), v,
                             across ? s.azimuth_scale : 1.0, across});
            component.name = member.name + ", " + word_of(o);
            component.id = member.id + "." + word_of(o);
            deviations_.push_back({component.id, component.name, std::move(component), point, {}, {}});
        }
    }

    void add_shared(const Member& member) {
        for (const SystematicDeviation& s : member.sensor().systematic())
            add_column(member, s.component, [&](const Row& row) {
                return row.undefined_azimuth ? 0.0 : s.effect(row.observable, row.v);
            });
        const SensorSource& sensor = member.sensor();
        if (sensor.station_correlations().empty()) {
            for (int i = 0; i < 6; ++i)
                add_column(member, sensor.station_components()[static_cast<std::size_t>(i)],
                           [&](const Row& row) { return row.to_station[i]; });
            return;
        }
        const Eigen::Matrix<double, 6, 6> F = station_factor(sensor);
        for (int k = 0; k < 6; ++k)
            add_column(member, combination_component(k),
                       [&](const Row& row) { return row.to_station.dot(F.col(k).transpose()); });
    }

    static UncertaintyComponent combination_component(int k) {
        const std::string number = std::to_string(k + 1);
        return {.id = "station." + number,
                .name = "station, combination " + number,
                .unit = Unit::of("1"),
                .distribution = Distribution::normal(1.0),
                .origin = "instrument: standard uncertainties and correlation of the station"};
    }

    template <class Effect>
    void add_column(const Member& member, UncertaintyComponent component, const Effect& effect) {
        if (!(component.distribution.standard_uncertainty() > 0.0)) return;
        std::vector<double> column(rows_.size(), 0.0);
        for (std::size_t i = 0; i < rows_.size(); ++i)
            if (rows_[i].member == &member) column[i] = effect(rows_[i]);
        effects_.push_back(std::move(column));
        const std::string id = component.id;
        component.name = member.name + ", " + component.name;
        deviations_.push_back({id, component.name, std::move(component), {}, member.id, {}});
    }

    const std::vector<Member>& members_;
    const std::vector<Eigen::Vector3d>& points_;
    std::vector<Row> rows_;
    std::vector<std::vector<double>> effects_;
    std::vector<JointDeviation> deviations_;
};

class SensorNetwork : public Asset, public PointUncertaintySource {
public:
    SensorNetwork(std::vector<Member> members, bool with_stations)
        : members_(std::move(members)), with_stations_(with_stations) {}

    const PointUncertaintySource* point_uncertainty() const override { return this; }
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
        ReadingCollector collector(members_, points);
        collector.collect();
        const Readings readings = collector.matrices();
        const Eigen::MatrixXd gain = gain_of(collector, readings);
        std::vector<JointDeviation> joint = std::move(collector.deviations());
        for (std::size_t k = 0; k < joint.size(); ++k) {
            const std::size_t rows = collector.readings();
            const Eigen::VectorXd moves =
                k < rows ? Eigen::VectorXd(gain.col(static_cast<Eigen::Index>(k)) * collector.scale(k))
                         : Eigen::VectorXd(gain * readings.shared.col(static_cast<Eigen::Index>(k - rows)));
            for (std::size_t p = 0; p < points.size(); ++p)
                joint[k].directions.push_back(moves.segment<3>(static_cast<Eigen::Index>(3 * p)));
        }
        return joint;
    }

    std::string objection(const Eigen::Vector3d& p) const override {
        const std::vector<Eigen::Vector3d> points{p};
        std::string seeing;
        for (const Member& member : members_) {
            const Eigen::Vector3d v = member.sensor().station().X_WS().inverse() * p;
            if (v.norm() == 0.0) return "it is at the place of " + member.name;
            if (member.sensor().sees(v)) seeing += (seeing.empty() ? "" : ", ") + member.name;
        }
        if (seeing.empty()) return "no sensor of the network sees it";
        ReadingCollector collector(members_, points);
        collector.collect();
        const Readings r = collector.matrices();
        const Eigen::VectorXd values =
            (r.u.cwiseInverse().asDiagonal() * r.to_points).eval().jacobiSvd().singularValues();
        if (values.size() == 3 && values[2] > 1e-9 * values[0]) return {};
        return "it cannot be localised from what " + seeing +
               " read: the readings leave a direction undetermined; add a sensor or a reading";
    }

    std::vector<Eigen::Vector3d> stations_seeing(const Eigen::Vector3d& p) const override {
        std::vector<Eigen::Vector3d> stations;
        for (const Member& member : members_) {
            const Eigen::Isometry3d X_WS = member.sensor().station().X_WS();
            if (member.sensor().sees(X_WS.inverse() * p)) stations.push_back(X_WS.translation());
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
                if (member.sensor().reads(o)) reads += (reads.empty() ? "" : ", ") + word_of(o);
            const auto& at = member.sensor().station().coordinates;
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
    /// (Jᵀ C⁻¹ J)⁻¹ Jᵀ C⁻¹, C of the readings alone (Eq 4) or with what they share.
    Eigen::MatrixXd gain_of(const ReadingCollector& collector, const Readings& r) const {
        Eigen::MatrixXd C = r.u.cwiseAbs2().asDiagonal();
        if (with_stations_) {
            Eigen::VectorXd u(r.shared.cols());
            for (Eigen::Index k = 0; k < u.size(); ++k)
                u[k] = collector.standard_uncertainty(collector.readings() + static_cast<std::size_t>(k));
            const Eigen::MatrixXd F = r.shared * u.asDiagonal();
            C += F * F.transpose();
        }
        const Eigen::MatrixXd WJ = C.llt().solve(r.to_points);
        return (r.to_points.transpose() * WJ).llt().solve(WJ.transpose());
    }

    std::vector<Member> members_;
    bool with_stations_;
};

SetupSchema network_asset_schema() {
    FieldSpec sensors{.key = "sensors",
                      .title = "Sensors",
                      .kind = FieldKind::table,
                      .help =
                          "The instruments of the network, each an instrument of the project that stands "
                          "somewhere.",
                      .min_rows = 1,
                      .section = "Network"};
    sensors.columns = {{.key = "sensor",
                        .title = "sensor",
                        .kind = FieldKind::reference,
                        .help = "An instrument of the project.",
                        .capabilities = {"sensor"}}};
    return SetupSchema(
        {sensors,
         {.key = "weights",
          .title = "Weights",
          .kind = FieldKind::choice,
          .help = "What the weights of the readings account for. With the stations, all points of one "
                  "analysis are estimated together.",
          .default_value = std::string("with-stations"),
          .choices = {{"with-stations", "readings and stations, all points at once"},
                      {"observations", "readings alone, each point by itself"}},
          .section = "Network"}});
}

std::unique_ptr<Asset> create_network(const SetupReader& setup, const AssetLibrary& assets,
                                      Problems& problems) {
    std::vector<Member> members;
    for (std::size_t row = 0; row < setup.rows("sensors"); ++row) {
        const std::string id = setup.cell_text("sensors", row, "sensor");
        const std::string path = "/sensors/rows/" + std::to_string(row);
        const AssetLibrary::Entry* entry = assets.find(id);
        if (!entry || !entry->asset || !entry->asset->sensor()) {
            problems.error(path, "'" + id + "' is no sensor");
            continue;
        }
        for (const Member& member : members)
            if (member.id == id) problems.error(path, "the sensor " + member.name + " is listed twice");
        members.push_back({id, entry->name.empty() ? id : entry->name, entry->asset});
    }
    return std::make_unique<SensorNetwork>(std::move(members), setup.text("weights") == "with-stations");
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
    d.capabilities = {"point-uncertainty"};
    d.schema = network_asset_schema();
    d.create = create_network;
    return d;
}

}  // namespace covaria
