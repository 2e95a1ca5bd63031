// Five hundred simulated campaigns of three set-ups of this program: a network, the identification of an arm,
// rounds of a total station. Factors are unbiased, stated intervals cover, alarms come at their level.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/resource_path.h"
#include "tests/core/campaigns/expect_campaigns.h"
#include "tests/core/made.h"
#include "tests/core/table_rows.h"

namespace covaria::campaigns_test {
namespace {

using evidence::RedundantReadings;

std::shared_ptr<const RedundantReadings> readings_of(const char* project, const char* analysis) {
    const LoadedProject loaded = load_project(data_directory() / "projects" / project);
    Problems problems;
    const auto prepared = made_analysis(loaded.project, analysis, problems);
    return prepared && prepared->model ? prepared->model->redundant_readings() : nullptr;
}

TEST(SimulatedCampaigns, OfANetwork) {
    const auto readings = readings_of("seen-network.covaria", "stated");
    ASSERT_TRUE(readings);
    expect_campaigns(*readings, {1.3, 1.0, 0.33}, 1);
}

TEST(SimulatedCampaigns, OfRoundsOfATotalStation) {
    const auto readings = readings_of("seen-chain.covaria", "rounds");
    ASSERT_TRUE(readings);
    expect_campaigns(*readings, {1.0, 1.5, 0.4}, 2);
}

TEST(SimulatedCampaigns, OfTheIdentificationOfAnArm) {
    const auto readings = readings_of("er10l-c10.covaria", "poses-measured");
    ASSERT_TRUE(readings);
    for (const double truth : {1.0, 2.0})
        expect_campaigns(*readings, std::vector<double>(readings->figures.size(), truth), 3);
}

/// A pose that was measured in another place than the arm stood is found without help.
TEST(TrackerData, ADisplacedPoseIsFoundAndAnInseparablePairIsNamed) {
    Project project = load_project(data_directory() / "projects/er10l-c10.covaria").project;
    constexpr std::size_t displaced = 16, x_column = 9;
    for (AnalysisEntry& analysis : project.analyses) {
        if (analysis.id != "poses-measured") continue;
        auto& x = std::get<SetupTable>(analysis.setup.values.at("poses")).rows[displaced][x_column];
        x = std::get<double>(x) + 0.2;
    }
    Problems problems;
    const auto prepared = made_analysis(project, "poses-measured", problems);
    ASSERT_TRUE(prepared && prepared->model);
    const auto readings = prepared->model->redundant_readings();
    std::size_t worst = 0;
    for (std::size_t i = 0; i < readings->w.size(); ++i)
        if (std::abs(readings->w[i]) > std::abs(readings->w[worst])) worst = i;
    EXPECT_EQ(readings->names[worst].english(), "P17, x");
    bool said = false;
    for (const Problem& problem : problems.items())
        said = said || problem.message.english().starts_with("pose P17: the residual of its x");
    EXPECT_TRUE(said);
    bool named = false;
    for (const Table& table : prepared->model->evaluation())
        for (const auto& row : test::rows_of(table))
            for (const Cell& cell : row)
                if (const auto* words = std::get_if<Message>(&cell))
                    named = named || words->english().starts_with("moves the measured points as ");
    EXPECT_TRUE(named);
}

/// The measured poses of the project as a simulated set.
class SimulatedPoses {
public:
    static constexpr std::size_t name_column = 0, x_column = 9;

    SimulatedPoses() : project_(load_project(data_directory() / "projects/er10l-c10.covaria").project) {
        prepare();
        // What the fit leaves over is taken away, and noise as stated is put in its place.
        std::mt19937_64 random(23);
        std::normal_distribution<double> noise(0.0, 0.015);
        for (std::size_t i = 0; i < readings_->names.size(); ++i) {
            const std::string words = readings_->names[i].english();
            const std::size_t comma = words.rfind(", ");
            const auto axis = static_cast<std::size_t>(words.back() - 'x');
            double& cell = std::get<double>(row(words.substr(0, comma))[x_column + axis]);
            cell += noise(random) - 1e3 * readings_->residuals[static_cast<Eigen::Index>(i)];
        }
    }

    std::vector<std::vector<SetupCell>>& rows() {
        for (AnalysisEntry& analysis : project_.analyses)
            if (analysis.id == "poses-measured")
                return std::get<SetupTable>(analysis.setup.values.at("poses")).rows;
        throw std::out_of_range("poses-measured");
    }
    std::vector<SetupCell>& row(const std::string& pose) {
        for (auto& row : rows())
            if (std::get<std::string>(row[name_column]) == pose) return row;
        throw std::out_of_range(pose);
    }
    /// Moves a pose by `mm` along each axis.
    void displace(const std::string& pose, double mm) {
        for (std::size_t axis = 0; axis < 3; ++axis) std::get<double>(row(pose)[x_column + axis]) += mm;
    }
    void prepare() {
        problems_ = {};
        const auto prepared = made_analysis(project_, "poses-measured", problems_);
        readings_ = prepared && prepared->model ? prepared->model->redundant_readings() : nullptr;
    }
    const std::shared_ptr<const RedundantReadings>& readings() const { return readings_; }
    /// The warnings of outliers.
    std::vector<std::string> outliers() const {
        std::vector<std::string> said;
        for (const Problem& problem : problems_.items())
            if (problem.message.english().find(": the residual of its ") != std::string::npos)
                said.push_back(problem.message.english());
        return said;
    }

private:
    Project project_;
    Problems problems_;
    std::shared_ptr<const RedundantReadings> readings_;
};

std::size_t worst_of(const RedundantReadings& readings) {
    std::size_t worst = 0;
    for (std::size_t i = 0; i < readings.w.size(); ++i)
        if (std::abs(readings.w[i]) > std::abs(readings.w[worst])) worst = i;
    return worst;
}

TEST(TrackerData, EachDisplacedPoseOfASimulatedSetIsFound) {
    SimulatedPoses poses;
    poses.prepare();
    EXPECT_TRUE(poses.outliers().empty());
    for (const char* pose : {"P3", "P17", "P28"}) {
        poses.displace(pose, 0.15);
        poses.prepare();
        ASSERT_EQ(poses.outliers().size(), 1u) << pose;
        EXPECT_EQ(poses.outliers()[0].find(std::string("pose ") + pose + ": "), 0u) << poses.outliers()[0];
        const RedundantReadings& readings = *poses.readings();
        EXPECT_EQ(readings.names[worst_of(readings)].english().find(std::string(pose) + ", "), 0u);
        poses.displace(pose, -0.15);
    }
}

/// With hardly more readings than unknowns an error of one pose looks like one of another: both are named.
TEST(TrackerData, PosesThatCannotBeToldApartAreNamedTogether) {
    SimulatedPoses poses;
    const auto all = poses.rows();
    for (std::size_t count = 6; count < all.size(); ++count) {
        poses.rows().assign(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count));
        poses.prepare();
        if (poses.readings() && poses.readings()->design.rows() > poses.readings()->design.cols()) break;
    }
    ASSERT_TRUE(poses.readings());
    poses.displace("P3", 5.0);
    poses.prepare();
    ASSERT_EQ(poses.outliers().size(), 1u);
    const std::string said = poses.outliers()[0];
    // Residuals by components, and how they hang together, straight from the matrices.
    const RedundantReadings& readings = *poses.readings();
    const Eigen::MatrixXd A = readings.design;
    Eigen::MatrixXd C = readings.others * readings.others.transpose();
    for (const Eigen::MatrixXd& share : readings.shares) C += share * share.transpose();
    const Eigen::MatrixXd R = Eigen::MatrixXd::Identity(A.rows(), A.rows()) -
                              A * A.completeOrthogonalDecomposition().pseudoInverse();
    const Eigen::MatrixXd V = R * C * R.transpose();
    const auto worst = static_cast<Eigen::Index>(worst_of(readings));
    std::size_t alike = 0, named = 0;
    for (Eigen::Index i = 0; i < V.rows(); ++i) {
        if (i == worst || V(i, i) < 1e-12 * V.diagonal().maxCoeff()) continue;
        if (std::abs(V(i, worst)) <= 0.98 * std::sqrt(V(i, i) * V(worst, worst))) continue;
        const std::string name = readings.names[static_cast<std::size_t>(i)].english();
        const std::size_t comma = name.rfind(", ");
        named +=
            said.find("the " + name.substr(comma + 2) + " of " + name.substr(0, comma)) != std::string::npos;
        ++alike;
    }
    ASSERT_GT(alike, 0u) << said;
    EXPECT_EQ(named, std::min<std::size_t>(alike, 3)) << said;
}

}  // namespace
}  // namespace covaria::campaigns_test
