// Poses and robots of others: OptiTrack Motive, UR calibrations.
#include <Eigen/Geometry>
#include <cmath>

#include "core/kinds/registries.h"
#include "tests/core/readers/reading.h"

namespace covaria::poses_test {

using namespace readers_test;

namespace {

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return at == std::string::npos ? text : text.replace(at, what.size(), with);
}

TEST(ReadMotive, TheMeanPoseHasTheCovarianceOfItsFrames) {
    const auto read = read_with("motive", data("take.csv"));
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(errors_of(*read), "");
    const UncertaintyResult result = first_order(*read);
    ASSERT_EQ(result.outputs.size(), 6u);
    EXPECT_NEAR(result.outputs[0].estimate, 1.0002, 1e-12);
    EXPECT_NEAR(result.outputs[5].estimate, std::acos(-1.0) / 2.0, 1e-5);
    // x: 1.0001, 1.0003, 1.0002, 1.0002; y: 2.0000, 2.0001, 2.0002, 2.0001
    const double s2 = 2e-8 / 3.0;
    EXPECT_NEAR(result.outputs[0].standard_uncertainty, std::sqrt(s2 / 4.0), 1e-15);
    EXPECT_NEAR(result.outputs[0].first_order.effective_degrees_of_freedom, 3.0, 1e-9);
    const auto& correlations = read->analyses[0].correlations;
    ASSERT_FALSE(correlations.empty());
    EXPECT_EQ(correlations[0].first + correlations[0].second, "xy");
    EXPECT_NEAR(correlations[0].coefficient, (1e-8 / 3.0) / s2, 1e-6);
    EXPECT_NE(all_found(*read).find("1 frames in which it was not seen"), std::string::npos);
    EXPECT_EQ((*reader_for(data("take.csv"), "take.csv"))->name, "motive");
}

TEST(ReadMotive, WhatIsNotAPoseHasAPlace) {
    const std::string file = data("take.csv");
    struct Case {
        std::string text;
        int line;
        const char* words;
    };
    for (const Case& c :
         {Case{replaced(file, "Quaternion", "XYZ"), 1, "rotations of type 'XYZ'"},
          Case{replaced(file, "2.0002", "two"), 11, "column 8: 'two'"},
          Case{replaced(file, "0.7072000,0.7070000", "0.9,0.9"), 11, "has not the length 1"},
          Case{replaced(file, ",Position,Position,Position,Mean", ",,,,Mean"), 7, "are missing"},
          Case{file.substr(0, file.find("\n1,")), 1, "at least two frames"},
          Case{replaced(file, "Format Version", "Version"), 1, "must begin with"},
          Case{replaced(file, "0.0003,0.7072000,0.7070000", "0.7071068,0,0.7071068"), 11,
               "not determined"}}) {
        const auto read = read_with("motive", c.text);
        ASSERT_FALSE(read) << c.words;
        EXPECT_EQ(read.error().line, c.line) << c.words;
        EXPECT_NE(read.error().message.english().find(c.words), std::string::npos)
            << read.error().message.english();
    }
    const auto unit = read_with("motive", replaced(file, "Meters", "Parsecs"));
    ASSERT_FALSE(unit);
    EXPECT_EQ(unit.error().code, ErrorCode::usage);
}

TEST(ReadRobotCalibration, TheRobotStandsWhereTheFramesLead) {
    const auto read = read_with("robot-calibration", data("arm_calibration.yaml"));
    ASSERT_TRUE(read) << read.error().message.english();
    EXPECT_EQ(errors_of(*read), "");
    ASSERT_EQ(read->assets.size(), 1u);
    EXPECT_EQ(read->assets[0].kind, "serial-robot");
    // The product of the six frames with all joints at 0.
    const std::array<std::array<double, 6>, 6> frames{
        {{0, 0, 0.1626, 0, 0, -2.1e-05},
         {0.0001, 0, 0, 1.5705, 0, 1.2e-05},
         {-0.4251, 0, 0, 0.0002, 0.0004, -3.0e-06},
         {-0.3921, 0.0007, 0.1332, 0.0052, -0.0003, 1.1e-05},
         {3.1e-05, -0.0996, -0.0001, 1.5717, 0, -2.5e-05},
         {5.2e-05, 0.0995, -3.1e-05, 1.5711, 3.1415926, 3.1415}}};
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    for (const auto& f : frames)
        X = X * Eigen::Translation3d(f[0], f[1], f[2]) * Eigen::AngleAxisd(f[5], Eigen::Vector3d::UnitZ()) *
            Eigen::AngleAxisd(f[4], Eigen::Vector3d::UnitY()) *
            Eigen::AngleAxisd(f[3], Eigen::Vector3d::UnitX());
    char words[80];
    std::snprintf(words, sizeof words, "stands at (%.6g, %.6g, %.6g) mm", 1e3 * X.translation().x(),
                  1e3 * X.translation().y(), 1e3 * X.translation().z());
    EXPECT_NE(all_found(*read).find(words), std::string::npos) << words << "\n" << all_found(*read);
    EXPECT_EQ((*reader_for(data("arm_calibration.yaml"), "arm.yaml"))->name, "robot-calibration");
}

TEST(ReadRobotCalibration, WhatIsMissingHasAPlace) {
    const std::string file = data("arm_calibration.yaml");
    struct Case {
        std::string text;
        int line;
        const char* words;
    };
    for (const Case& c :
         {Case{replaced(file, "  wrist_2:", "  wrist_4:"), 2, "the frame of wrist_2 is missing"},
          Case{replaced(file, "z: 0.1626", "z: high"), 5, "shoulder: z 'high' is no number"},
          Case{replaced(file, "    yaw: 3.1415\n", ""), 38, "wrist_3: yaw is missing"},
          Case{replaced(file, "roll: 1.5705", "roll: 90"), 13, "within 10 rad"},
          Case{"shoulder:\n  x: 1\n", 1, "'kinematics' is missing"}}) {
        const auto read = read_with("robot-calibration", c.text);
        ASSERT_FALSE(read) << c.words;
        EXPECT_EQ(read.error().line, c.line) << c.words << read.error().message.english();
        EXPECT_NE(read.error().message.english().find(c.words), std::string::npos)
            << read.error().message.english();
    }
}

}  // namespace

}  // namespace covaria::poses_test
