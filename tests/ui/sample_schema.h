// A set-up schema with a field of every kind, and a project with an asset of it: the forms' tests need no
// real model.
#pragma once

#include "core/project/project.h"
#include "core/setup/setup_schema.h"
#include "ui/document/setup_address.h"

namespace covaria::ui {

inline const SetupSchema& sample_schema() {
    static const SetupSchema schema = [] {
        std::vector<FieldSpec> fields;
        fields.push_back({.key = "length",
                          .title = "Length",
                          .help = "How long it is.",
                          .unit = Unit::of("mm"),
                          .range = {0.0, 10.0, true},
                          .default_value = Quantity{100.0, Unit::of("mm")}});
        fields.push_back({.key = "count",
                          .title = "Count",
                          .kind = FieldKind::integer,
                          .help = "How many.",
                          .range = {1.0, 9.0},
                          .default_value = Quantity{3.0, Unit()}});
        fields.push_back({.key = "mode",
                          .title = "Mode",
                          .kind = FieldKind::choice,
                          .help = "How it is done.",
                          .default_value = std::string("simple"),
                          .choices = {{"simple", "Simple way"}, {"full", "Full way"}},
                          .section = "Way"});
        fields.push_back({.key = "depth",
                          .title = "Depth",
                          .help = "Only of the full way.",
                          .unit = Unit::of("mm"),
                          .default_value = Quantity{5.0, Unit::of("mm")},
                          .shown_if = Condition{"mode", {"full"}},
                          .section = "Details"});
        fields.push_back({.key = "label",
                          .title = "Label",
                          .kind = FieldKind::text,
                          .help = "Any text.",
                          .optional = true,
                          .section = "More"});
        fields.push_back({.key = "exact",
                          .title = "Exact",
                          .kind = FieldKind::flag,
                          .help = "Whether it is exact.",
                          .default_value = false,
                          .section = "More"});
        fields.push_back({.key = "pose",
                          .title = "Pose",
                          .kind = FieldKind::pose,
                          .help = "Where it stands.",
                          .default_value = PoseValue{},
                          .section = "More"});
        fields.push_back(
            {.key = "points",
             .title = "Points",
             .kind = FieldKind::table,
             .help = "The points.",
             .columns = {{.key = "name", .title = "Name", .kind = FieldKind::text, .help = "Its name."},
                         {.key = "x", .title = "x", .unit = Unit::of("mm"), .help = "Coordinate."},
                         {.key = "u_x",
                          .title = "u_x",
                          .unit = Unit::of("um"),
                          .range = {0.0, Range::infinity_value},
                          .help = "Its uncertainty."},
                         {.key = "kind",
                          .title = "Kind",
                          .kind = FieldKind::choice,
                          .choices = {{"a", "Nest"}, {"b", "Target"}},
                          .help = "What it is."}},
             .section = "More"});
        fields.push_back({.key = "source",
                          .title = "Source",
                          .kind = FieldKind::reference,
                          .help = "What measured it.",
                          .optional = true,
                          .capabilities = {"no such capability"},
                          .section = "More"});
        return SetupSchema(std::move(fields));
    }();
    return schema;
}

inline const SetupAddress& sample_address() {
    static const SetupAddress address{SetupOwner::asset, "sample"};
    return address;
}

/// One asset with three points.
inline Project sample_project() {
    SetupTable points;
    points.units = {Unit(), Unit::of("mm"), Unit::of("um"), Unit()};
    const std::string nest = "a";
    points.rows = {{std::string("b1"), 1.0, 10.0, nest},
                   {std::string("b2"), 2.0, 20.0, nest},
                   {std::string("b3"), 3.0, 30.0, nest}};
    Project project;
    project.assets.push_back({"sample", "sample-kind", "Sample", {}, {}});
    project.assets[0].setup.values["points"] = points;
    return project;
}

}  // namespace covaria::ui
