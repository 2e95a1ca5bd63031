// Robots out and in: from URDF and from the calibration of a UR arm comes the same chain, whatever its
// convention, zero readings and directions.
#include <cmath>
#include <random>

#include "core/base/resource_path.h"
#include "core/kinds/robot/serial_robot.h"
#include "core/kinds/robot/urdf.h"
#include "core/made/library.h"
#include "core/readers/entry_texts.h"
#include "core/readers/readers.h"
#include "tests/core/shipped_projects.h"
#include "tests/core/writers/evaluated.h"

namespace covaria::robots_test {

namespace {

using writers_test::Evaluated;
using writers_test::write_as;

MadeProject::Pointer made_of(AssetEntry robot) {
    Project project;
    project.assets.push_back(std::move(robot));
    auto made = MadeProject::make(std::move(project));
    const Problems problems = made->problems();
    for (const Problem& problem : problems.items())
        EXPECT_NE(problem.severity, Severity::error) << problem.path << " " << problem.message.english();
    return made;
}

const SerialRobotSource& robot_in(const MadeProject& made, const std::string& id) {
    const auto* entry = made.assets().find(id);
    const SerialRobotSource* robot = entry ? offers<SerialRobotSource>(entry->asset) : nullptr;
    if (!robot) throw std::runtime_error("no robot " + id);
    return *robot;
}

Result<WrittenFile> written(const std::string& writer, const MadeProject& made) {
    return write_as(writer, {made, {}});
}

MadeProject::Pointer back_from_urdf(const std::string& text) {
    auto robot = import_urdf(text);
    if (!robot) throw std::runtime_error(robot.error().message.english() + "\n" + text);
    return made_of({.id = "back", .kind = robot->kind, .name = robot->name, .setup = robot->setup});
}

MadeProject::Pointer back_from_calibration(const std::string& text) {
    const auto read =
        find_reader("robot-calibration")->read(text, {.file_name = "back.yaml", .chosen = true});
    if (!read) throw std::runtime_error(read.error().message.english() + "\n" + text);
    AssetEntry asset = read->assets.at(0);
    asset.id = "back";
    return made_of(std::move(asset));
}

Eigen::Isometry3d tool_of(const SerialRobotSource& robot, const std::vector<double>& q) {
    return robot.X_WB() * link_frames(robot, q).back();
}

/// Compares the tool poses of two robots at a hundred random readings.
void expect_same_tool(const SerialRobotSource& a, const SerialRobotSource& b, const std::string& what) {
    ASSERT_EQ(a.joints().size(), b.joints().size()) << what;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> angle(-3.0, 3.0), length(-0.5, 0.5);
    double largest = 0.0;
    for (int trial = 0; trial < 100; ++trial) {
        std::vector<double> q;
        for (const RobotJoint& joint : a.joints()) q.push_back(joint.slides ? length(random) : angle(random));
        largest = std::max(largest, (tool_of(a, q).matrix() - tool_of(b, q).matrix()).cwiseAbs().maxCoeff());
    }
    EXPECT_LT(largest, 1e-12) << what;
}

/// An arm near a right-angled one: neighbouring axes skew, parallel and opposite, each a little off.
AssetEntry random_arm(unsigned seed, std::size_t joints, bool sliding) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    std::uniform_int_distribution<int> pick(0, 5);
    const bool craig = seed % 3 == 0;
    TableRows rows(table_of("serial-robot", "joints"));
    for (std::size_t i = 0; i < joints; ++i) {
        const bool parallel = !craig && pick(random) < 2, slides = sliding && pick(random) == 0;
        const double alpha = parallel ? 0.2 * part(random) : 90.0 * (pick(random) % 3 - 1) + part(random);
        rows.add({{"theta", 180.0 * part(random)},
                  {"d", parallel ? 0.0 : 400.0 * part(random)},
                  {"a", 500.0 * part(random)},
                  {"alpha", alpha},
                  {"beta", parallel ? SetupCell(0.1 * part(random)) : SetupCell()},
                  {slides ? "s_zero" : "q_zero", 40.0 * part(random)},
                  {slides ? "s_min" : "q_min", -100.0 - pick(random)},
                  {slides ? "s_max" : "q_max", 120.0},
                  {"direction", std::string(pick(random) < 3 ? "negative" : "positive")},
                  {"type", std::string(slides ? "sliding" : "turning")}});
    }
    AssetEntry robot{.id = "arm", .kind = "serial-robot", .name = "A <b> & \"c\" -- \x01"};
    robot.setup.values["convention"] = std::string(craig ? "craig" : "modified");
    robot.setup.values["joints"] = rows.table();
    for (const char* pose : {"base", "tool"}) {
        PoseValue value;
        for (std::size_t k = 0; k < 3; ++k) {
            value.position[k] = 300.0 * part(random);
            value.angles[k] = 170.0 * part(random);
        }
        robot.setup.values[pose] = value;
    }
    return robot;
}

TEST(WriteRobots, UrdfIsTheSameChain) {
    for (unsigned seed = 1; seed <= 60; ++seed) {
        const auto made = made_of(random_arm(seed, 1 + seed % 7, seed % 2 == 0));
        const auto file = written("urdf", *made);
        ASSERT_TRUE(file) << file.error().message.english();
        EXPECT_EQ(file->bytes, written("urdf", *made)->bytes);
        const auto back = back_from_urdf(file->bytes);
        const SerialRobotSource &a = robot_in(*made, "arm"), &b = robot_in(*back, "back");
        expect_same_tool(a, b, "seed " + std::to_string(seed));
        for (std::size_t i = 0; i < a.joints().size() && i < b.joints().size(); ++i) {
            EXPECT_EQ(a.joints()[i].slides, b.joints()[i].slides);
            EXPECT_NEAR(a.joints()[i].low, b.joints()[i].low, 1e-12);
            EXPECT_NEAR(a.joints()[i].high, b.joints()[i].high, 1e-12);
        }
    }
}

TEST(WriteRobots, UrdfOfTheLibraryComesBack) {
    std::size_t robots = 0;
    for (const LibraryItem& item : load_library().items) {
        const auto made = made_of(item.asset);
        const auto* entry = made->assets().find(item.asset.id);
        if (!entry || !offers<SerialRobotSource>(entry->asset)) {
            EXPECT_FALSE(written("urdf", *made)) << item.asset.id;
            continue;
        }
        const auto file = written("urdf", *made);
        ASSERT_TRUE(file) << file.error().message.english();
        expect_same_tool(robot_in(*made, item.asset.id), robot_in(*back_from_urdf(file->bytes), "back"),
                         item.asset.id);
        ++robots;
    }
    EXPECT_GE(robots, 11u);
}

TEST(WriteRobots, ACalibrationComesBackToTheSameNumbers) {
    const auto text =
        read_file(std::filesystem::path(COVARIA_SOURCE_DIR) / "tests/data/readers/arm_calibration.yaml");
    ASSERT_TRUE(text);
    const auto first = back_from_calibration(*text);
    const auto file = written("ur-calibration", *first);
    ASSERT_TRUE(file) << file.error().message.english();
    expect_same_tool(robot_in(*first, "back"), robot_in(*back_from_calibration(file->bytes), "back"),
                     "calibration");
    EXPECT_NE(file->bytes.find("\n  hash: calib_"), std::string::npos) << file->bytes;
    // The URDF describes the same arm.
    expect_same_tool(robot_in(*first, "back"),
                     robot_in(*back_from_urdf(written("urdf", *first)->bytes), "back"), "as URDF");
}

TEST(WriteRobots, ACalibrationIsTheArmUpToTheFrameOfWrist3) {
    for (unsigned seed = 1; seed <= 30; ++seed) {
        AssetEntry arm = random_arm(seed, 6, false);
        if (seed % 2) arm.setup.values.erase("base");
        const auto made = made_of(arm);
        const auto file = written("ur-calibration", *made);
        ASSERT_TRUE(file) << file.error().message.english();
        const auto back = back_from_calibration(file->bytes);
        const SerialRobotSource &a = robot_in(*made, "arm"), &b = robot_in(*back, "back");
        // The tool that the file has no place for stands in wrist_3 the same at all readings.
        const std::vector<double> zero(6, 0.0);
        const Eigen::Isometry3d X = tool_of(b, zero).inverse() * tool_of(a, zero);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> angle(-3.0, 3.0);
        for (int trial = 0; trial < 20; ++trial) {
            std::vector<double> q(6);
            for (double& v : q) v = angle(random);
            const double off = ((tool_of(b, q) * X).matrix() - tool_of(a, q).matrix()).cwiseAbs().maxCoeff();
            EXPECT_LT(off, 3e-12) << seed;
        }
        bool tool_said = false, base_said = false;
        for (const std::string& line : file->said) {
            tool_said = tool_said || line.find("the tool has no place in the file") != std::string::npos;
            base_said = base_said || line.find("in the world frame") != std::string::npos;
        }
        EXPECT_TRUE(tool_said);
        EXPECT_EQ(base_said, seed % 2 == 0);
    }
}

TEST(WriteRobots, ACalibrationIsOfSixJointsThatTurn) {
    for (const std::size_t joints : {1u, 5u, 7u}) {
        const auto file = written("ur-calibration", *made_of(random_arm(1, joints, false)));
        ASSERT_FALSE(file);
        EXPECT_NE(file.error().message.english().find("six joints that turn"), std::string::npos);
    }
    AssetEntry robot = random_arm(1, 6, false);
    auto& table = std::get<SetupTable>(robot.setup.values.at("joints"));
    const FieldSpec& field = table_of("serial-robot", "joints");
    auto& row = table.rows[2];
    for (const char* turning : {"q_zero", "q_min", "q_max"}) row[SetupSchema::column(field, turning)] = {};
    row[SetupSchema::column(field, "type")] = std::string("sliding");
    EXPECT_FALSE(written("ur-calibration", *made_of(robot)));
    const auto urdf = written("urdf", *made_of(robot));
    ASSERT_TRUE(urdf);
    bool said = false;
    for (const std::string& line : urdf->said)
        said = said || line.find("joint 3 has no limits in the file") != std::string::npos;
    EXPECT_TRUE(said);
}

/// The shipped identification, by the law of propagation.
Evaluated identification(const std::vector<std::string>& analyses) {
    Project project = writers_test::loaded(data_directory() / "projects" / "er10l-c10.covaria");
    std::erase_if(project.analyses, [&](const AnalysisEntry& analysis) {
        return std::find(analyses.begin(), analyses.end(), analysis.id) == analyses.end();
    });
    return writers_test::evaluate(std::move(project));
}

TEST(WriteRobots, AnIdentifiedRobotHasItsParametersAndUncertainties) {
    const Evaluated evaluated = identification({"poses-measured"});
    const auto file = write_as("urdf", evaluated.source());
    ASSERT_TRUE(file) << file.error().message.english();
    // The analysis gives a robot and is made from the nominal one: the identified is written.
    const auto asset = evaluated.analyses[0].analysis->model->as_asset("poses-measured");
    expect_same_tool(*offers<SerialRobotSource>(asset), robot_in(*back_from_urdf(file->bytes), "back"),
                     "identified");
    std::size_t stated = 0;
    for (const OutputResult& output : evaluated.analyses[0].result->outputs) {
        if (!output.quantity.group.starts_with("joint ")) continue;
        const std::size_t at = file->bytes.find(" " + output.quantity.symbol + " = ");
        ASSERT_NE(at, std::string::npos) << output.quantity.symbol;
        const bool length = output.quantity.unit.dimension() == Unit::of("mm").dimension();
        const Unit unit = Unit::of(length ? "mm" : "deg");
        const char* text = file->bytes.c_str() + at + output.quantity.symbol.size() + 4;
        const double value = unit.interval_from_si(output.estimate);
        EXPECT_NEAR(std::strtod(text, nullptr), value, 1e-11 * std::max(1.0, std::abs(value))) << text;
        const double u = unit.interval_from_si(output.standard_uncertainty);
        EXPECT_NEAR(std::strtod(std::strstr(text, "(u = ") + 5, nullptr), u, 6e-3 * u)
            << output.quantity.symbol;
        ++stated;
    }
    EXPECT_GE(stated, 18u);
    EXPECT_NE(file->said.front().find(std::to_string(stated) + " parameters"), std::string::npos)
        << file->said.front();
}

TEST(WriteRobots, OfSeveralRobotsOneIsToBeChosen) {
    const auto both = write_as("urdf", identification({"zero-pose", "zero-pose-nominal"}).source());
    ASSERT_FALSE(both);
    for (const char* words : {"er10l-calibrated", "er10l-nominal", "--analysis"})
        EXPECT_NE(both.error().message.english().find(words), std::string::npos)
            << both.error().message.english();
    const auto one = write_as("urdf", identification({"trajectories", "zero-pose-identified"}).source());
    ASSERT_TRUE(one) << one.error().message.english();
    EXPECT_EQ(one->said.front().substr(0, 18), "robot trajectories");
    EXPECT_FALSE(write_as("urdf", {*MadeProject::make(Project{}), {}}));
}

}  // namespace

}  // namespace covaria::robots_test
