// Fields of "network adjustment".
#include "core/kinds/network/seen_figures.h"
#include "core/kinds/points/component_evidence.h"

namespace covaria::network {

namespace {

using Stated = StatedAdjustment;

std::vector<ChoiceOf<CoordinateRole>> roles() {
    return {{CoordinateRole::unknown, "unknown", "unknown"},
            {CoordinateRole::datum, "datum", "unknown, of the datum"},
            {CoordinateRole::fixed, "fixed", "fixed"},
            {CoordinateRole::stated, "stated", "stated with u"},
            {CoordinateRole::none, "none", "not part of the network"}};
}

std::vector<ChoiceOf<CoordinateRole>> roles_in_plane() {
    std::vector<ChoiceOf<CoordinateRole>> all = roles();
    all.push_back({CoordinateRole::x_fixed, "x-fixed", "x fixed, y unknown"});
    all.push_back({CoordinateRole::y_fixed, "y-fixed", "y fixed, x unknown"});
    return all;
}

Columns<Stated::Point> point_columns() {
    using Row = Stated::Point;
    const Unit m = Unit::of("m"), mm = Unit::of("mm");
    const std::array<const char*, 3> u{"u_x", "u_y", "u_z"};
    Columns<Row> columns;
    columns.add(&Row::name, "name", "name", "Name of the point, unique.")
        .each(
            &Row::p,
            by_axis(along_axes,
                    "Coordinate *; of an unknown point an approximate one, or empty: the readings place it.",
                    {.unit = m, .optional = true}))
        .choice(&Row::plane, "plane", "plane",
                "What is known of x and y: unknown; unknown, and what no reading tells is taken from this "
                "point and "
                "others like it (free network); fixed without uncertainty; stated with u. For a datum by "
                "three, two and one coordinates (3-2-1) one of the two is fixed by itself.",
                roles_in_plane())
        .choice(&Row::height, "height", "height", "What is known of z, likewise.", roles());
    return columns.each(&Row::u,
                        by_axis({u[0], u[1], u[2]}, "Standard uncertainty of a stated coordinate.",
                                {.unit = mm, .range = {.low = 0.0, .low_open = true}, .optional = true}));
}

std::vector<ChoiceOf<ReadingKind>> kinds() {
    return {{ReadingKind::slope_distance, "slope-distance", "slope distance"},
            {ReadingKind::horizontal_distance, "horizontal-distance", "horizontal distance"},
            {ReadingKind::direction, "direction", "direction"},
            {ReadingKind::angle, "angle", "angle"},
            {ReadingKind::azimuth, "azimuth", "azimuth"},
            {ReadingKind::zenith_angle, "zenith-angle", "zenith angle"},
            {Stated::Reading::elevation, "elevation", "elevation"},
            {ReadingKind::height_difference, "height-difference", "height difference"},
            {ReadingKind::x, "x", "x of a point"},
            {ReadingKind::y, "y", "y of a point"},
            {ReadingKind::z, "z", "z of a point"},
            {ReadingKind::dx, "dx", "difference of x"},
            {ReadingKind::dy, "dy", "difference of y"},
            {ReadingKind::dz, "dz", "difference of z"},
            {ReadingKind::frame_x, "frame-x", "x in a frame"},
            {ReadingKind::frame_y, "frame-y", "y in a frame"},
            {ReadingKind::frame_z, "frame-z", "z in a frame"}};
}

Columns<Stated::Reading> reading_columns() {
    using Row = Stated::Reading;
    const Unit m = Unit::of("m"), mm = Unit::of("mm"), rad = Unit::of("rad");
    const Range positive{.low = 0.0, .low_open = true};
    return Columns<Row>()
        .add(&Row::label, "label", "label", "By which a correlation calls it.", {.optional = true})
        .choice(&Row::kind, "kind", "kind", "What was read.", kinds())
        .add(&Row::from, "from", "from", "The point where it was read; of a coordinate its point.")
        .add(&Row::to, "to", "to", "The point that was sighted.", {.optional = true})
        .add(&Row::second, "second", "second", "Of an angle the point at its second leg.", {.optional = true})
        .add(&Row::round, "round", "round",
             "Of a direction: rounds of one station between which its circle was turned have names; each has "
             "an "
             "orientation of its own.",
             {.optional = true})
        .add(&Row::frame, "frame", "frame",
             "Of a coordinate in a frame: the name of the frame, whose pose the readings tell: that of an "
             "arm, a scanner, a photogrammetric network.",
             {.optional = true})
        .add(&Row::length, "length", "length", "A length or coordinate as read.",
             {.unit = m, .optional = true})
        .add(&Row::angle, "angle", "angle", "An angle as read.", {.unit = rad, .optional = true})
        .add(&Row::u_length, "u_length", "u of length", "Standard uncertainty of the length.",
             {.unit = mm, .range = positive, .optional = true})
        .add(&Row::u_angle, "u_angle", "u of angle", "Standard uncertainty of the angle.",
             {.unit = rad, .range = positive, .optional = true})
        .add(&Row::height_from, "height_from", "height from", "Height of the instrument above its point.",
             {.unit = m, .optional = true})
        .add(&Row::height_to, "height_to", "height to", "Height of the target above its point.",
             {.unit = m, .optional = true})
        .add(
            &Row::instrument, "instrument", "instrument",
            "Which instrument read it: readings of one kind by one instrument rest on one figure when stated "
            "uncertainties are held against the residuals, and share its figures.",
            {.optional = true})
        .choice(&Row::face_two, "face", "face",
                "Of a direction, azimuth or zenith angle: the face in which it was read, as it was read. A "
                "zenith angle beyond half a turn is of face two anyway. It is brought to face one; index and "
                "collimation change it the other way.",
                {{false, "one", "one"}, {true, "two", "two"}}, {.optional = true})
        .choice(&Row::left_out, "use", "use",
                "A reading that is left out stays in the table, and is told among those left out.",
                {{false, "used", "used"}, {true, "left-out", "left out"}}, {.optional = true});
}

Columns<Stated::Figure> figure_columns() {
    using Row = Stated::Figure;
    const Unit mm = Unit::of("mm"), ppm = Unit::of("ppm"), rad = Unit::of("rad");
    const Range positive{.low = 0.0, .low_open = true};
    return Columns<Row>()
        .add(&Row::instrument, "instrument", "instrument",
             "Name of the instrument, as in the column of the readings; empty: of all readings without one.",
             {.optional = true})
        .choice(&Row::kind, "figure", "figure",
                "What it does to all of its readings alike: its zero is added to distances, by its scale "
                "(weather correction included) they are longer, refraction bends its lines of sight, its "
                "index is added to zenith angles, its collimation over the sine of the zenith angle to "
                "directions; in face two both are taken off.",
                {{FigureKind::zero, "zero", "zero of distances"},
                 {FigureKind::scale, "scale", "scale of distances"},
                 {FigureKind::refraction, "refraction", "refraction coefficient"},
                 {FigureKind::index, "index", "vertical index"},
                 {FigureKind::collimation, "collimation", "collimation"}})
        .choice(&Row::knowledge, "knowledge", "knowledge",
                "Unknown: the readings tell it; stated with u: its value is one more reading, which all of "
                "the instrument's share; fixed without uncertainty.",
                {{FigureKnowledge::unknown, "unknown", "unknown"},
                 {FigureKnowledge::stated, "stated", "stated with u"},
                 {FigureKnowledge::fixed, "fixed", "fixed"}})
        .add(&Row::length, "length", "length", "The zero; 0 where it is empty.",
             {.unit = mm, .optional = true})
        .add(&Row::u_length, "u_length", "u of length", "Standard uncertainty of a stated zero.",
             {.unit = mm, .range = positive, .optional = true})
        .add(&Row::ratio, "ratio", "ratio", "The scale beyond 1, or the refraction coefficient.",
             {.unit = ppm, .optional = true})
        .add(&Row::u_ratio, "u_ratio", "u of ratio",
             "Standard uncertainty of a stated scale or refraction coefficient.",
             {.unit = ppm, .range = positive, .optional = true})
        .add(&Row::angle, "angle", "angle", "The index or collimation; 0 where it is empty.",
             {.unit = rad, .optional = true})
        .add(&Row::u_angle, "u_angle", "u of angle", "Standard uncertainty of a stated index or collimation.",
             {.unit = rad, .range = positive, .optional = true});
}

Columns<Stated::Frame> frame_columns() {
    using Row = Stated::Frame;
    const Range positive{.low = 0.0, .low_open = true};
    return Columns<Row>()
        .add(&Row::name, "name", "name", "Name of the frame, as in the column of the readings.")
        .choice(
            &Row::shape, "shape", "shape",
            "An own frame with all of its axes; or a plane, from which points are as far as their z in it "
            "says; or a line along its x-axis, from which their y and z say how far they are.",
            {{FrameShape::axes, "frame", "own frame"},
             {FrameShape::plane, "plane", "plane"},
             {FrameShape::line, "line", "line"}})
        .choice(&Row::scale, "scale", "scale",
                "Scale of an own frame: fixed; unknown, so that the readings tell it; stated with u.",
                {{FigureKnowledge::fixed, "fixed", "fixed"},
                 {FigureKnowledge::unknown, "unknown", "unknown"},
                 {FigureKnowledge::stated, "stated", "stated with u"}})
        .add(&Row::ratio, "ratio", "scale beyond 1",
             "By how much coordinates in the frame are too long; 0 where it is empty.",
             {.unit = Unit::of("ppm"), .optional = true})
        .add(&Row::u_ratio, "u_ratio", "u of scale", "Standard uncertainty of a stated scale.",
             {.unit = Unit::of("ppm"), .range = positive, .optional = true})
        .add(&Row::u_tilt, "u_tilt", "u of tilt",
             "Of an own frame whose z-axis is vertical: within that standard uncertainty about x and about "
             "y; empty: nothing is known of it.",
             {.unit = Unit::of("rad"), .range = positive, .optional = true});
}

Columns<Stated::Correlation> correlation_columns() {
    using Row = Stated::Correlation;
    return Columns<Row>()
        .add(&Row::first, "first", "first", "Label of a reading.")
        .add(&Row::second, "second", "second", "Label of another reading.")
        .add(&Row::coefficient, "coefficient", "coefficient", "Correlation coefficient of the two.",
             {.range = {.low = -1.0, .high = 1.0}});
}

Columns<Stated::Station> station_columns() {
    using Row = Stated::Station;
    return Columns<Row>()
        .add(&Row::point, "point", "point", "The point where the instrument stands.")
        .choice(
            &Row::stated, "tilt", "tilt",
            "How it leans: unknown, so that the readings tell it; or levelled within u, about x and about y.",
            {{false, "unknown", "unknown"}, {true, "levelled", "levelled within u"}})
        .add(&Row::u, "u_tilt", "u of tilt", "Standard uncertainty of each tilt of a levelled instrument.",
             {.unit = Unit::of("rad"), .range = {.low = 0.0, .low_open = true}, .optional = true});
}

Columns<Stated::Distance> distance_columns() {
    using Row = Stated::Distance;
    const Unit mm = Unit::of("mm");
    const Range positive{.low = 0.0, .low_open = true};
    return Columns<Row>()
        .add(&Row::from, "from", "from", "Name of a point.")
        .add(&Row::to, "to", "to", "Name of another point.")
        .add(&Row::reference, "reference", "reference",
             "A calibrated length of the distance, or what was measured along one line of sight. It is held "
             "back from the adjustment, which is held against it (E_n).",
             {.unit = mm, .range = positive, .optional = true})
        .add(&Row::u_reference, "u_reference", "u of reference", "Standard uncertainty of the reference.",
             {.unit = mm, .range = positive, .optional = true});
}

Columns<Stated::Campaign> campaign_columns() {
    return Columns<Stated::Campaign>().add(&Stated::Campaign::seen_in, "campaign", "campaign",
                                           "A network as above.");
}

}  // namespace

const Fields<StatedAdjustment>& adjustment_fields() {
    static const auto fields =
        Fields<Stated>()
            .section("Network")
            .table(&Stated::points, "points", "Points",
                   "Stations and targets alike, with what is known of them beforehand.", point_columns(),
                   {.min_rows = 1})
            .table(&Stated::distances, "distances", "Distances",
                   "Distances between points that are measurands too, and calibrated lengths to hold them "
                   "against.",
                   distance_columns(), {.optional = true})
            .section("Readings")
            .choice(
                &Stated::clockwise, "sense", "Directions grow",
                "In which sense directions, angles and azimuths grow, and from which axis azimuths count.",
                {{false, "x-to-y", "from x towards y; azimuths count from x"},
                 {true, "y-to-x", "from y towards x; azimuths count from y"}},
                false)
            .table(&Stated::readings, "readings", "Readings",
                   "What was read between the points, one row for each figure, typed or from a CSV file.",
                   reading_columns(), {.min_rows = 1, .measured = true})
            .choice(
                &Stated::uncertainties, uncertainties_key, "Uncertainties of the readings",
                "As typed in the table; or as the residuals of this adjustment see them: typed ones times "
                "one common factor s_0, or times the factor of each kind of reading and instrument "
                "(variance components). Either has the degrees of freedom of its estimate.",
                choices_of_uncertainties(), UncertaintiesFrom::stated)
            .add(&Stated::read_on, "read_on", "Date of the readings",
                 "For the chart of figures over campaigns: 2026-11-28; empty: not stated.",
                 {.optional = true})
            .add(&Stated::seen_in, "seen_in", "Figures as seen in",
                 "Another network, rounds of a total station say, whose residuals see what its readings are "
                 "worth. Readings of the same kind and instrument get the standard uncertainty that it sees, "
                 "with its degrees of freedom, and follow its readings; others stay as stated here.",
                 {.optional = true})
            .table(&Stated::further_campaigns, "further_campaigns", "And in further campaigns",
                   "Further networks that see the same figures. What several of them see is combined: their "
                   "mean, with what it changes from one campaign to the next in its degrees of freedom "
                   "(Paule and Mandel).",
                   campaign_columns(), {.optional = true})
            .table(&Stated::figures, "figures", "Figures of instruments",
                   "What an instrument does to all of its readings alike, with what is known of it.",
                   figure_columns(), {.optional = true})
            .add(&Stated::earth_radius, "earth_radius", "Radius of the Earth",
                 "Where the curvature of the Earth counts in zenith angles; empty: it does not.",
                 {.unit = Unit::of("km"), .range = {.low = 100.0, .low_open = true}, .optional = true})
            .add(
                &Stated::refraction, "refraction", "Refraction coefficient",
                "Of zenith angles, where the curvature of the Earth counts and no instrument states its own.",
                {.default_value = Quantity{0.13, Unit{}}})
            .table(&Stated::stations, "stations", "Instruments that are not levelled",
                   "Where an instrument stands that is not levelled, or not exactly; all others are.",
                   station_columns(), {.optional = true})
            .table(&Stated::frames, "frames", "Frames, planes and lines",
                   "Frames that readings name, where more is known of them than that their pose is unknown, "
                   "and planes and lines on which points are.",
                   frame_columns(), {.optional = true})
            .table(&Stated::correlations, "correlations", "Correlations of readings",
                   "Correlation coefficients of readings: they change the weights and the uncertainty.",
                   correlation_columns(), {.optional = true})
            .section("What is left out")
            .add(&Stated::gross_limit, "gross_limit", "Gross readings beyond",
                 "Readings that miss what the others agree on (a robust adjustment) by more, an angle at its "
                 "target, are left out; empty: none.",
                 {.unit = Unit::of("m"), .range = {.low = 0.0, .low_open = true}, .optional = true})
            .choice(&Stated::leaves_undetermined, "undetermined", "Points that nothing tells",
                    "They are refused, by name; or left out with their readings, and told.",
                    {{false, "refuse", "are refused"}, {true, "leave-out", "are left out"}}, false)
            .choice(&Stated::robust, "outliers", "Outliers",
                    "All readings are kept, and the adjustment says which contradict the others; or the "
                    "search begins robustly (Huber's weights), and readings with |w| beyond 3.29 are left "
                    "out, each with its reason.",
                    {{false, "keep", "are kept"}, {true, "leave-out", "robust start, and left out"}}, false);
    return fields;
}

}  // namespace covaria::network
