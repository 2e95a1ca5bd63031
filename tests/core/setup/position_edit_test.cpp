// Positions written into set-ups.
#include "core/setup/position_edit.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace covaria::position_edit_test {
namespace {

const Unit mm = Unit::of("mm");

SetupSchema schema() {
    FieldSpec targets{.key = "targets", .title = "Targets", .kind = FieldKind::table, .help = "h"};
    targets.columns = {{.key = "name", .title = "name", .kind = FieldKind::text},
                       {.key = "x", .title = "x", .unit = mm},
                       {.key = "y", .title = "y", .unit = mm},
                       {.key = "z", .title = "z", .unit = mm}};
    return SetupSchema({targets,
                        {.key = "station",
                         .title = "Station",
                         .kind = FieldKind::pose,
                         .help = "h",
                         .default_value = PoseValue{}},
                        {.key = "width", .title = "Width", .help = "h", .unit = mm}});
}

covaria::Setup setup() {
    SetupTable table;
    table.units = {Unit{}, Unit::of("m"), mm, mm};
    table.rows = {{std::string("A"), 1.0, 2.0, 3.0}, {std::string("B"), 1.5, 0.123456, -7.0}};
    table.csv_file = "targets.csv";
    covaria::Setup result;
    result.values["targets"] = table;
    return result;
}

const std::vector<SetupCell>& row(const covaria::Setup& setup, std::size_t index) {
    return std::get<SetupTable>(setup.values.at("targets")).rows[index];
}

TEST(PositionEdit, RowsKeepTheirUnitsAndRoundToTheStep) {
    covaria::Setup edited = setup();
    ASSERT_TRUE(write_position(schema(), edited, "/targets/rows/1", {1.23456, 0.0004567, -0.0070001}, 0.002));
    EXPECT_EQ(std::get<double>(row(edited, 1)[1]), 1.235) << "a step of 2 mm rounds to 1 mm, here in m";
    EXPECT_EQ(std::get<double>(row(edited, 1)[2]), 0.123456) << "less than half a step: as typed";
    EXPECT_EQ(std::get<double>(row(edited, 1)[3]), -7.0);
    EXPECT_EQ(row(edited, 0), row(setup(), 0));
    EXPECT_EQ(std::get<SetupTable>(edited.values.at("targets")).csv_file, "")
        << "no longer what the file says";
}

TEST(PositionEdit, PosesKeepTheirAnglesAndTakeTheirDefault) {
    covaria::Setup edited;
    ASSERT_TRUE(write_position(schema(), edited, "/station", {0.1, -2.03456, 0.0}, 0.01));
    const auto& pose = std::get<PoseValue>(edited.values.at("station"));
    EXPECT_EQ(pose.position, (std::array<double, 3>{100.0, -2030.0, 0.0}));
    EXPECT_EQ(pose.angles, PoseValue{}.angles);
}

TEST(PositionEdit, OrientationsOfPosesAreTheirAngles) {
    covaria::Setup edited;
    PoseValue before;
    before.angles = {10.0, -20.0, 30.0};
    edited.values["station"] = before;
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const Eigen::Matrix3d R = turn * before.si().linear();
    ASSERT_TRUE(write_orientation(schema(), edited, "/station", R, 0.001));
    const auto& pose = std::get<PoseValue>(edited.values.at("station"));
    EXPECT_EQ(pose.position, before.position);
    EXPECT_EQ(pose.angles[0], 10.0) << "as typed";
    EXPECT_EQ(pose.angles[1], -20.0);
    EXPECT_EQ(pose.angles[2], 47.19) << "30 + 17.1887, to 0.01 degrees";
    for (const char* path : {"", "/width", "/targets/rows/1", "/station/position"})
        EXPECT_FALSE(write_orientation(schema(), edited, path, R, 0.001)) << path;
    EXPECT_FALSE(write_orientation(schema(), edited, "/station", R * std::nan(""), 0.001));
}

TEST(PositionEdit, RefusesWhatIsNoPosition) {
    for (const char* path : {"", "/", "/width", "/nothing", "/targets", "/targets/rows/2", "/targets/rows/x",
                             "/targets/rows/1/x", "/targets/rows/-1", "/station/x"}) {
        covaria::Setup edited = setup();
        EXPECT_FALSE(write_position(schema(), edited, path, {1, 2, 3}, 0.001)) << path;
        EXPECT_EQ(edited, setup()) << path;
    }
    covaria::Setup edited = setup();
    EXPECT_FALSE(write_position(schema(), edited, "/station", {std::nan(""), 0, 0}, 0.001));
    EXPECT_EQ(edited, setup());
}

}  // namespace
}  // namespace covaria::position_edit_test
