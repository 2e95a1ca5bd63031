// The asset "force-sensor": a multi-axis force/moment sensor with its calibration (Kim).
#include "core/kinds/force/calibration.h"

#include <cmath>
#include <numbers>

#include "core/base/name.h"
#include "core/kinds/force/assets.h"
#include "core/kinds/force/force_sensor.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

using force::Calibration;
using force::StatedSensor;

class ForceSensor : public Asset, public ForceSensorSource {
public:
    explicit ForceSensor(Calibration calibration) : calibration_(std::move(calibration)) {
        for (std::size_t c = 0; c < calibration_.series.size(); ++c)
            for (const force::Run& run : calibration_.series[c].runs)
                for (const force::StepReading& r : run.increasing) increasing_.push_back({c, r.load, r.net});
        offer(*this);
    }

    const std::vector<ForceChannel>& channels() const override { return calibration_.channels; }
    double resolution() const override { return calibration_.resolution; }
    const Eigen::MatrixXd& rated_outputs() const override { return calibration_.rated_outputs; }
    bool has_signs() const override { return calibration_.has_signs; }
    const std::vector<LoadedReading>& increasing() const override { return increasing_; }
    double paper_expanded_uncertainty(std::size_t channel) const override { return calibration_.U(channel); }
    const Eigen::Isometry3d& placement() const override { return calibration_.placement; }
    double height() const override { return calibration_.height; }

    std::vector<Table> evaluation() const override { return force::calibration_tables(calibration_); }
    std::vector<PlotSpecification> figures() const override {
        return force::calibration_figures(calibration_);
    }

    /// The housing below the plane of the axes, and the axes.
    Layout layout() const override {
        Layout layout;
        LayoutBody body{.name = own_name<"sensor">(), .kind = BodyKind::plate};
        constexpr int corners = 48;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / corners, r = 0.5 * calibration_.diameter;
            body.outline_W.push_back(calibration_.placement *
                                     Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), 0.0));
        }
        body.thickness = calibration_.height;
        layout.bodies.push_back(std::move(body));
        layout.frames.push_back(
            {.name = own_name<"sensor">(),
             .X_WF = calibration_.placement,
             .source = {.path = force::sensor_fields().place(&StatedSensor::placement), .draggable = true}});
        return layout;
    }

private:
    Calibration calibration_;
    std::vector<LoadedReading> increasing_;
};

bool make_channels(Calibration& calibration, Problems& problems) {
    using Channel = StatedSensor::Channel;
    for (std::size_t row = 0; row < calibration.stated_channels.size(); ++row) {
        const Channel& stated = calibration.stated_channels[row];
        const auto cell = [&](auto column) {
            return force::sensor_fields().place(&StatedSensor::stated_channels, row, column);
        };
        ForceChannel channel;
        channel.axis = stated.axis;
        channel.runs = std::max(2, calibration.plan.runs);
        channel.degrees_of_freedom = channel.runs - 1.0;
        const std::string key = channel.kind().key;
        const auto rated = channel.kind().is_moment ? &Channel::rated_moment : &Channel::rated_force;
        if (calibration.channel_of(channel.axis))
            problems.error(cell(&Channel::axis), tell<"channel %1 is listed twice">(key));
        else if (!(stated.*rated))
            problems.error(cell(rated),
                           tell<"channel %1 needs its rated load, a %2">(
                               key, (channel.kind().is_moment ? tell<"moment">() : tell<"force">())));
        channel.rated_load = (stated.*rated).value_or(0.0);
        calibration.channels.push_back(channel);
    }
    return !problems.has_errors();
}

bool take_calibrator(Calibration& calibration, Problems& problems) {
    for (ForceChannel& channel : calibration.channels) {
        const auto u = calibration.calibrator->relative_uncertainty(channel.axis);
        if (!u)
            problems.error(force::sensor_fields().place(&StatedSensor::calibrator),
                           tell<"%1 states no uncertainty of its load on %2: add it to its certificate">(
                               calibration.calibrator.name, channel.kind().key));
        channel.u_calibrator = u.value_or(0.0);
    }
    return !problems.has_errors();
}

std::unique_ptr<Asset> create_sensor(const SetupReader& setup, const AssetLibrary& assets,
                                     Problems& problems) {
    Calibration calibration{force::sensor_fields().read(setup, assets, problems), {}, {}, {}, {}, {}};
    if (!make_channels(calibration, problems) || !take_calibrator(calibration, problems)) return nullptr;
    calibration.stated_u_b.resize(calibration.size());
    calibration.has_signs = calibration.has_signs || calibration.from_readings;
    if (calibration.from_readings) {
        force::read_series(calibration, problems);
        if (!problems.has_errors()) force::evaluate_series(calibration, problems);
    } else {
        force::read_summary(calibration, problems);
    }
    if (problems.has_errors()) return nullptr;
    return std::make_unique<ForceSensor>(std::move(calibration));
}

std::vector<std::string> sensor_notes() {
    return {
        "Tables 1 to 4 reproduce from raw readings that are consistent with them, to the printed digits, "
        "with "
        "relative uncertainties of the machine of 8.6e-4, 8.7e-4, 1.2e-5, 8.7e-4, 8.6e-4 and 1.7e-3.",
        "Type B, Table 3: differs for five of six sensors, because the stated uncertainties of the machine "
        "(2.1e-4, 1.8e-4, 1.2e-5, 3.1e-4, 2.9e-4, 2.4e-4) give 0.16, 0.23, 0.28, 0.31, 0.30, 0.36 µV/V and "
        "not "
        "0.27, 0.31, 0.28, 0.41, 0.40, 0.62. The list equals the Type A column in five places: most likely "
        "copied there.",
        "Table 4, Mx under Fy: differs, printed 1.55 %, is 0.15 %; the largest for Mx is 1.38 %, and the "
        "difference to its U 0.30 %, not 0.13 %.",
        "Section 2.5 calls e_12 the output of Fy under Fx, but Table 4 divides by the rated output of the "
        "row: a row is taken as a sensor.",
        "Eq 12 adds hysteresis and interference, limits that are not standard uncertainties, to an expanded "
        "uncertainty: the sum is neither a standard uncertainty nor a coverage interval.",
        "The largest values of Type A and Type B need not occur at the same step. Eq 5 takes the rated "
        "output "
        "at every step. In 2.1.1 \"h=2\" of My and Mz is a slip."};
}

}  // namespace

AssetDescriptor force_sensor_kind() {
    AssetDescriptor d;
    d.kind = "force-sensor";
    d.title = "Multi-axis force/moment sensor";
    d.category = AssetCategory::instrument;
    d.summary =
        "Up to three forces and three moments measured at once; calibrated with one load at a time, "
        "evaluated "
        "from its readings.";
    d.references = {
        {"G.-S. Kim: Uncertainty evaluation of a multi-axis force/moment sensor, International "
         "Journal of the KSPE 3 (3)"}};
    d.notes = sensor_notes();
    d.capabilities = {ForceSensorSource::capability};
    d.schema = force::sensor_fields().schema();
    d.create = create_sensor;
    return d;
}

}  // namespace covaria
