// The fields of "geometry from points".
#include "core/kinds/geometry/setup.h"
#include "core/kinds/points/stated_figure.h"

namespace covaria::geometry {

namespace {

using Stated = StatedGeometry;

Columns<StatedFeature> feature_columns() {
    return Columns<StatedFeature>()
        .add(&StatedFeature::name, "name", "name", "Name of the feature, unique.")
        .choice(&StatedFeature::form, "form", "form",
                "What is fitted to its points. In the xy-plane z does not matter.",
                {{Form::plane, "plane", "plane"},
                 {Form::line, "line", "line"},
                 {Form::circle, "circle", "circle"},
                 {Form::sphere, "sphere", "sphere"},
                 {Form::cylinder, "cylinder", "cylinder"},
                 {Form::cone, "cone", "cone"},
                 {Form::point, "point", "point"},
                 {Form::line_2d, "line-2d", "line in the xy-plane"},
                 {Form::circle_2d, "circle-2d", "circle in the xy-plane"}})
        .add(&StatedFeature::reversed, "reversed", "reversed",
             "The direction is stated with the other sign: the largest component of the direction is "
             "negative, that of a cone leads to its apex.",
             {.optional = true});
}

Columns<StatedPoint> point_columns() {
    const Unit mm = Unit::of("mm");
    const Range not_negative{.low = 0.0}, correlation{.low = -1.0, .high = 1.0};
    return Columns<StatedPoint>()
        .add(&StatedPoint::feature, "feature", "feature",
             "The feature that it is a point of; empty: that of the row above, of the first row the first.",
             {.optional = true})
        .add(&StatedPoint::name, "name", "name",
             "Name of the point, unique in its feature; empty: its number. Of points that an analysis "
             "measured the name there.",
             {.optional = true})
        .each(
            &StatedPoint::p,
            by_axis(along_axes,
                    "Measured coordinate *; empty where the point is a feature of an analysis, and z in the "
                    "xy-plane.",
                    {.unit = mm, .optional = true}))
        .each(&StatedPoint::u,
              by_axis({"u_x", "u_y", "u_z"},
                      "Standard uncertainty of coordinate * of this point; empty: as for all points.",
                      {.unit = mm, .range = not_negative, .optional = true}))
        .each(&StatedPoint::r,
              std::array<ColumnSpec, 3>{{{.key = "r_xy",
                                          .title = "r_xy",
                                          .range = correlation,
                                          .optional = true,
                                          .help = "Correlation coefficient of the point's own x and y."},
                                         {.key = "r_xz",
                                          .title = "r_xz",
                                          .range = correlation,
                                          .optional = true,
                                          .help = "Correlation coefficient of the point's own x and z."},
                                         {.key = "r_yz",
                                          .title = "r_yz",
                                          .range = correlation,
                                          .optional = true,
                                          .help = "Correlation coefficient of the point's own y and z."}}});
}

std::array<FieldSpec, 3> common_fields() {
    std::array<FieldSpec, 3> fields;
    for (std::size_t c = 0; c < 3; ++c) {
        const std::string axis = along_axes[c];
        fields[c] = {.key = "u_common_" + axis,
                     .title = "Common u of " + axis,
                     .help = "Standard uncertainty of a deviation along " + axis +
                             " that all points share beside their own: where the instrument stands.",
                     .unit = Unit::of("mm"),
                     .default_value = Quantity{0.0, Unit::of("mm")}};
        fields[c].range.low = 0.0;
    }
    return fields;
}

void add_uncertainty(Fields<Stated>& fields) {
    fields.section("Uncertainty of the points")
        .choice(&Stated::uncertainty, "point_uncertainty", "Uncertainty of the points",
                "Typed, from the scatter of the points about their feature, or of what measured them: an "
                "instrument of the project, or an analysis whose results are points.",
                {{PointUncertainty::typed, "typed", "typed"},
                 {PointUncertainty::scatter, "scatter", "from the scatter about the feature"},
                 {PointUncertainty::source, "asset", "an instrument or an analysis"}},
                PointUncertainty::typed)
        .add(
            &Stated::u_point, "u_point", "Standard uncertainty of a coordinate",
            "Of every coordinate of every point that states none, independent of all others.",
            {.unit = Unit::of("mm"), .range = {.low = 0.0}, .default_value = Quantity{0.005, Unit::of("mm")}})
        .add(&Stated::distribution,
             distribution_field("distribution", "the coordinates' deviations", "Uncertainty of the points"))
        .each(&Stated::u_common, common_fields())
        .add(&Stated::instrument, "instrument", "Measured by",
             "An instrument that stands somewhere, whose scale and station are alike for all points; or an "
             "analysis, whose points are known by their names and are evaluated with this one in every "
             "trial.")
        .shown_where(&Stated::uncertainty, {PointUncertainty::typed}, &Stated::u_point, &Stated::distribution,
                     &Stated::u_common)
        .shown_where(&Stated::uncertainty, {PointUncertainty::source}, &Stated::instrument);
}

}  // namespace

const Fields<StatedGeometry>& geometry_fields() {
    static const auto fields = [] {
        Fields<Stated> made;
        made.section("Features")
            .table(&Stated::features, "features", "Features",
                   "Forms that are fitted to points by orthogonal least squares.", feature_columns(),
                   {.min_rows = 1})
            .add(&Stated::with_form, "form_deviations", "Form deviations",
                 "Peak to valley and root mean square of the points' deviations from their feature are "
                 "results too.",
                 {.default_value = true})
            .section("Points")
            .table(&Stated::points, "points", "Points",
                   "Measured points of the features, typed, pasted or from a CSV file.", point_columns(),
                   {.min_rows = 1, .measured = true});
        add_uncertainty(made);
        return made;
    }();
    return fields;
}

}  // namespace covaria::geometry
