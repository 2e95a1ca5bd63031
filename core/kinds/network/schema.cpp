// Fields of "points from sensors".
#include "core/kinds/network/setup.h"
#include "core/kinds/points/stated_figure.h"

namespace covaria::network {

namespace {

using Stated = StatedNetwork;

Columns<Stated::Target> target_columns() {
    using Row = Stated::Target;
    return Columns<Row>()
        .add(&Row::name, "name", "name", "Name of the target, unique.")
        .each(&Row::nominal, by_axis(along_axes, "Nominal coordinate *.", {.unit = Unit::of("mm")}))
        .add(&Row::new_set_up, "new_set_up", "new set-up",
             "The sensors were located anew before this target: it and those below share the deviations of "
             "the stations with each other, not with the targets above.",
             {.optional = true});
}

Columns<Stated::Distance> distance_columns() {
    using Row = Stated::Distance;
    return Columns<Row>()
        .add(&Row::from, "from", "from", "Name of a target.")
        .add(&Row::to, "to", "to", "Name of another target.");
}

Columns<Stated::Angle> angle_columns() {
    using Row = Stated::Angle;
    return Columns<Row>()
        .add(&Row::from, "from", "from", "Name of a target.")
        .add(&Row::at, "at", "at", "Name of the target where the angle is.")
        .add(&Row::to, "to", "to", "Name of a third target.");
}

Columns<Stated::Frame> frame_columns() {
    using Row = Stated::Frame;
    return Columns<Row>()
        .add(&Row::name, "name", "name", "Name of the frame, unique.")
        .add(&Row::origin, "origin", "origin", "Target at its origin.")
        .add(&Row::on_x, "on_x", "on x", "Target on its positive x-axis.")
        .add(&Row::in_xy, "in_xy", "in xy", "Target in its xy-plane, at positive y.");
}

Columns<Stated::Bar> bar_columns() {
    using Row = Stated::Bar;
    const Unit mm = Unit::of("mm");
    const Range positive{.low = 0.0, .low_open = true};
    return Columns<Row>()
        .add(&Row::from, "from", "from", "Name of a target.")
        .add(&Row::to, "to", "to", "Name of another target.")
        .add(&Row::length, "length", "length",
             "Calibrated length; empty in a design: the distance of the nominal targets.",
             {.unit = mm, .range = positive, .optional = true})
        .add(&Row::u, "u", "u",
             "Standard uncertainty of the length as it is during the measurement, with temperature.",
             {.unit = mm, .range = positive})
        .choice(&Row::constrains, "role", "role",
                "Check: the difference between network and calibration is a measurand. Constraint: the "
                "length is adjusted with the readings.",
                {{false, "check", "check"}, {true, "constraint", "constraint"}})
        .add(&Row::distribution, distribution_column());
}

Columns<Stated::Reading> reading_columns() {
    using Row = Stated::Reading;
    const Unit mm = Unit::of("mm"), rad = Unit::of("rad");
    return Columns<Row>()
        .add(&Row::target, "target", "target", "Name of the target.")
        .add(&Row::sensor, "sensor", "sensor", "The instrument that read it.")
        .each(&Row::values,
              std::array<ColumnSpec, 3>{
                  {{.key = "distance",
                    .title = "distance",
                    .unit = mm,
                    .optional = true,
                    .help = "Slope distance."},
                   {.key = "azimuth",
                    .title = "azimuth",
                    .unit = rad,
                    .optional = true,
                    .help = "Horizontal angle from the sensor's x-axis, positive towards y; whole turns do "
                            "not matter."},
                   {.key = "elevation",
                    .title = "elevation",
                    .unit = rad,
                    .optional = true,
                    .help = "Vertical angle above the sensor's xy-plane."}}});
}

void add_measurands(Fields<Stated>& fields) {
    fields.section("Network")
        .table(&Stated::targets, "targets", "Targets",
               "Points to be localised, at their nominal coordinates.", target_columns(), {.min_rows = 1})
        .table(&Stated::distances, "distances", "Distances",
               "Distances between targets that are measurands too, for instance of a scale bar.",
               distance_columns(), {.optional = true})
        .table(&Stated::angles, "angles", "Angles",
               "Angles at a target between the directions to two others, measurands too.", angle_columns(),
               {.optional = true})
        .table(&Stated::frames, "frames", "Frames",
               "Frames on three targets (3-2-1), whose position and Z-Y-X angles in the world "
               "are measurands too.",
               frame_columns(), {.optional = true})
        .table(&Stated::bars, "scale_bars", "Calibrated lengths",
               "Scale bars and other calibrated distances between two targets: compared with the "
               "network, or a constraint of the estimation.",
               bar_columns(), {.optional = true});
}

void add_readings(Fields<Stated>& fields) {
    fields.section("Readings")
        .choice(&Stated::measured, "evaluation", "Evaluation",
                "A priori: the readings are those of the nominal targets. A posteriori: the "
                "readings are given.",
                {{false, "a-priori", "a priori (design: nominal targets)"},
                 {true, "a-posteriori", "a posteriori (given readings)"}},
                false)
        .table(&Stated::readings, "readings", "Readings",
               "What the sensors read, one row for a sensor and a target, typed or from a CSV file; "
               "leave empty what was not read.",
               reading_columns(), {.optional = true, .measured = true})
        .shown_where(&Stated::measured, {true}, &Stated::readings);
}

void add_estimation(Fields<Stated>& fields) {
    fields.section("Estimation")
        .choice(&Stated::estimator, "estimator", "Estimator",
                "How a target's coordinates follow from its readings.",
                {{Estimator::nonlinear, "nonlinear", "non-linear weighted least squares"},
                 {Estimator::linear, "linear", "linearised equations: OLS, then GLS (Eqs 1-4 of the paper)"},
                 {Estimator::linear_start, "linear-start",
                  "linearised equations: OLS alone (Eq 3 of the paper)"}},
                Estimator::nonlinear)
        .choice(&Stated::weights, "weights", "Weights",
                "What the weights of the equations account for. Weights from the readings "
                "alone, as in the paper, "
                "are not the best where the stations are uncertain.",
                {{Weights::with_stations, "with-stations",
                  "readings and stations, all targets of a set-up at once"},
                 {Weights::observations_only, "observations",
                  "readings alone, each target by itself (the paper)"}},
                Weights::with_stations)
        .shown_where(&Stated::estimator, {Estimator::nonlinear}, &Stated::weights);
}

}  // namespace

const Fields<SensorList>& sensor_list_fields() {
    using Row = SensorList::Row;
    static const auto fields = Fields<SensorList>().section("Network").table(
        &SensorList::rows, "sensors", "Sensors",
        "The instruments of the network, each an instrument of the project that stands "
        "somewhere.",
        Columns<Row>().add(&Row::sensor, "sensor", "sensor", "An instrument of the project."),
        {.min_rows = 1});
    return fields;
}

const Fields<StatedNetwork>& network_fields() {
    static const auto fields = [] {
        Fields<Stated> made;
        made.part(&Stated::sensors, sensor_list_fields());
        add_measurands(made);
        add_readings(made);
        add_estimation(made);
        return made;
    }();
    return fields;
}

}  // namespace covaria::network
