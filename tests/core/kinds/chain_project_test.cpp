// projects/chain.covaria, from the certificate of a scale bar to the tool of a robot, against the same chain
// written by hand: models called one after the other, matrices multiplied.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

#include "core/base/resource_path.h"
#include "core/model/composed_model.h"
#include "core/project/entry_graph.h"
#include "core/project/links.h"
#include "core/project/project_file.h"
#include "core/propagation/engine.h"
#include "tests/core/made.h"

namespace covaria::chain_project_test {
namespace {

const char* const order[] = {"bar", "network", "flange", "identification", "tool"};

/// One model of the chain by itself, as `ComposedModel` was given it.
struct Link {
    const MeasurementModel* model;
    const InputSet* inputs;
    std::vector<double> x;
    Eigen::MatrixXd J;
    bool differentiate() {
        SensitivityRows rows;
        if (!model->sensitivities(x, rows)) return false;
        J.setZero(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(x.size()));
        for (std::size_t j = 0; j < rows.size(); ++j)
            for (const Sensitivity& s : rows[j])
                J(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(s.input)) = s.coefficient;
        return true;
    }
    std::size_t at(const std::string& symbol) const { return inputs->find(symbol); }
    std::size_t output(const std::string& group, const std::string& symbol) const {
        for (std::size_t j = 0; j < model->outputs().size(); ++j)
            if (model->outputs()[j].group == group && model->outputs()[j].symbol == symbol) return j;
        throw std::out_of_range(group + ": " + symbol);
    }
};

struct Wire {
    std::size_t input, output;
};

class ChainByHand : public testing::Test {
protected:
    void SetUp() override {
        LoadedProject loaded = load_project(data_directory() / "projects/chain.covaria");
        for (const Problem& p : loaded.problems.items())
            ADD_FAILURE() << p.path << ": " << p.message.english();
        project_ = loaded.project;
        Problems problems;
        analysis_ = made_analysis(project_, "tool", problems);
        ASSERT_TRUE(analysis_);
        const auto* chain = dynamic_cast<const ComposedModel*>(analysis_->model.get());
        ASSERT_NE(chain, nullptr);
        for (const char* id : order)
            for (const ChainPart& part : chain->parts())
                if (part.id == id) links_.push_back({part.model.get(), &part.inputs, {}, {}});
        ASSERT_EQ(links_.size(), 5u);
        wire();
    }

    /// Connects outputs and inputs, from the names alone.
    void wire() {
        wires_.resize(5);
        wires_[1] = {{links_[1].at("L_A1A2"), links_[0].output("", "L")}};
        const auto points = std::get<SetupTable>(entry("flange").setup.values.at("poses")).rows.size();
        for (int i = 1; i <= 3; ++i)
            for (const char axis : {'x', 'y', 'z'}) {
                const std::string number = std::to_string(i);
                wires_[2].push_back({links_[2].at("b_" + number + axis),
                                     links_[1].output("B" + number, std::string(1, axis))});
                for (std::size_t k = 1; k <= points; ++k)
                    wires_[2].push_back({links_[2].at("p_" + number + axis + "_" + std::to_string(k)),
                                         links_[1].output("P" + number + " in pose " + std::to_string(k),
                                                          std::string(1, axis))});
            }
        for (std::size_t k = 1; k <= points; ++k)
            for (const char* axis : {"x", "y", "z"})
                wires_[3].push_back({links_[3].at(axis + std::string("_") + std::to_string(k)),
                                     links_[2].output("pose " + std::to_string(k), axis)});
        for (std::size_t j = 0; j < links_[3].model->outputs().size(); ++j) {
            const OutputQuantity& found = links_[3].model->outputs()[j];
            if (found.group.starts_with("joint ")) wires_[4].push_back({links_[4].at(found.symbol), j});
        }
        for (const auto& list : wires_)
            for (const Wire& w : list) ASSERT_NE(w.input, InputSet::npos);
    }

    const AnalysisEntry& entry(const std::string& id) const { return *project_.find_analysis(id); }

    /// y of the tool; the parts' own quantities are `own` (their estimates plus deviations of components).
    std::vector<double> evaluate(const std::vector<std::vector<double>>& own) {
        std::vector<double> before, y;
        for (std::size_t p = 0; p < links_.size(); ++p) {
            links_[p].x = own[p];
            for (const Wire& w : wires_[p]) links_[p].x[w.input] = before[w.output];
            y.assign(links_[p].model->outputs().size(), 0.0);
            if (!links_[p].model->evaluate(links_[p].x, y)) return {};
            before = y;
        }
        return y;
    }

    std::vector<std::vector<double>> estimates() const {
        std::vector<std::vector<double>> own;
        for (const Link& link : links_) {
            own.emplace_back();
            for (std::size_t i = 0; i < link.inputs->quantities.size(); ++i)
                own.back().push_back(estimate_of(*link.inputs, i));
        }
        return own;
    }

    bool is_wired(std::size_t p, std::size_t input) const {
        return std::any_of(wires_[p].begin(), wires_[p].end(),
                           [&](const Wire& w) { return w.input == input; });
    }

    Project project_;
    std::shared_ptr<const PreparedAnalysis> analysis_;
    std::vector<Link> links_;
    std::vector<std::vector<Wire>> wires_;
};

TEST_F(ChainByHand, EstimatesAndUncertaintiesByTheLawOfPropagation) {
    const std::vector<double> y = evaluate(estimates());
    ASSERT_EQ(y.size(), 3u);
    // dy/dx of the tool with respect to the quantities of each part, from the end of the chain.
    Eigen::MatrixXd back = Eigen::MatrixXd::Identity(3, 3);
    Eigen::MatrixXd U = Eigen::Matrix3d::Zero();
    for (std::size_t p = 5; p-- > 0;) {
        Link& link = links_[p];
        ASSERT_TRUE(link.differentiate());
        const Eigen::MatrixXd c = back * link.J;
        // Independent quantities but for components that several share (stations, scales).
        Eigen::MatrixXd by_component =
            Eigen::MatrixXd::Zero(3, static_cast<Eigen::Index>(link.inputs->components.size()));
        for (std::size_t i = 0; i < link.inputs->quantities.size(); ++i) {
            if (is_wired(p, i)) continue;
            for (const Share& share : link.inputs->quantities[i].shares)
                by_component.col(static_cast<Eigen::Index>(share.component)) +=
                    c.col(static_cast<Eigen::Index>(i)) * share.factor *
                    link.inputs->components[share.component].distribution.standard_uncertainty();
        }
        EXPECT_TRUE(link.inputs->correlations.empty());
        U += by_component * by_component.transpose();
        if (p == 0) break;
        back = Eigen::MatrixXd::Zero(3, static_cast<Eigen::Index>(links_[p - 1].model->outputs().size()));
        for (const Wire& w : wires_[p])
            back.col(static_cast<Eigen::Index>(w.output)) += c.col(static_cast<Eigen::Index>(w.input));
    }
    PreparedAnalysis first_order = *analysis_;
    first_order.options.method = Method::first_order;
    const auto result = run_analysis(first_order);
    ASSERT_TRUE(result) << result.error().message.english();
    for (Eigen::Index j = 0; j < 3; ++j) {
        const auto& output = result->outputs[static_cast<std::size_t>(j)].first_order;
        EXPECT_NEAR(output.estimate, y[static_cast<std::size_t>(j)], 1e-9 * std::abs(output.estimate));
        EXPECT_NEAR(output.standard_uncertainty, std::sqrt(U(j, j)), 1e-9 * output.standard_uncertainty);
        EXPECT_GT(output.standard_uncertainty, 5e-6);
        EXPECT_LT(output.standard_uncertainty, 1e-3);
    }
}

TEST_F(ChainByHand, MonteCarloWithinFourStandardErrors) {
    constexpr std::size_t trials = 1500;
    std::mt19937_64 generator(11);
    std::uniform_real_distribution<double> uniform(1e-12, 1.0 - 1e-12);
    const auto nominal = estimates();
    Eigen::MatrixXd y(3, trials);
    for (Eigen::Index t = 0; t < y.cols(); ++t) {
        auto own = nominal;
        for (std::size_t p = 0; p < links_.size(); ++p) {
            const InputSet& inputs = *links_[p].inputs;
            std::vector<double> deviation;
            for (const UncertaintyComponent& component : inputs.components) {
                double u = uniform(generator), d = 0.0;
                drawn_distribution(component).quantiles(std::span<const double>(&u, 1),
                                                        std::span<double>(&d, 1));
                deviation.push_back(d - component.distribution.mean());
            }
            for (std::size_t i = 0; i < inputs.quantities.size(); ++i)
                for (const Share& share : inputs.quantities[i].shares)
                    own[p][i] += share.factor * deviation[share.component];
        }
        const std::vector<double> value = evaluate(own);
        ASSERT_EQ(value.size(), 3u) << t;
        for (Eigen::Index j = 0; j < 3; ++j) y(j, t) = value[static_cast<std::size_t>(j)];
    }
    PreparedAnalysis monte_carlo = *analysis_;
    monte_carlo.options.method = Method::monte_carlo;
    monte_carlo.options.trials = 5'000;
    const auto result = run_analysis(monte_carlo);
    ASSERT_TRUE(result) << result.error().message.english();
    EXPECT_EQ(result->failed_trials, 0u);
    for (Eigen::Index j = 0; j < 3; ++j) {
        const auto& output = *result->outputs[static_cast<std::size_t>(j)].monte_carlo;
        const Eigen::ArrayXd row = y.row(j).transpose().array();
        const double mean = row.mean(), s = std::sqrt((row - mean).square().sum() / (trials - 1.0));
        const double se = s / std::sqrt(double(trials));
        EXPECT_NEAR(output.mean, mean, 4.0 * std::hypot(se, output.standard_error_of_mean));
        EXPECT_NEAR(output.standard_uncertainty, s,
                    4.0 * std::hypot(se / std::sqrt(2.0), output.standard_error_of_uncertainty));
    }
}

TEST_F(ChainByHand, BudgetNamesTheCertificate) {
    PreparedAnalysis first_order = *analysis_;
    first_order.options.method = Method::first_order;
    const auto result = run_analysis(first_order);
    ASSERT_TRUE(result) << result.error().message.english();
    double of_certificate = 0.0, of_scale = 0.0;
    for (const BudgetRow& row : result->budget.rows.at(0)) {
        const BudgetComponent& c = result->budget.components[row.component];
        if (c.id == "bar:L_20.1") {
            of_certificate = row.share;
            EXPECT_EQ(c.origin, "calibration certificate of the scale bar");
        }
        if (c.id == "tracker-1.scale") of_scale = row.share;
    }
    EXPECT_GT(of_certificate, 0.0);
    EXPECT_GT(of_scale, 0.0);
    double sum = 0.0;
    for (const GroupContribution& g : contributions_by_group(result->budget, 0, "analysis")) sum += g.share;
    EXPECT_NEAR(sum, 1.0, 1e-9);
    EXPECT_EQ(analyses_used_by(project_, entry("tool")),
              (std::vector<std::string>{"bar", "network", "flange", "identification"}));
    EXPECT_EQ(analyses_using(project_, "tracker-2"),
              (std::vector<std::string>{"network", "flange", "identification", "tool"}));
    for (const OutputResult& output : result->outputs) EXPECT_LT(output.expanded_uncertainty, 0.5e-3);
}

TEST_F(ChainByHand, APointThatTheNetworkHasNotIsNamed) {
    Project project = project_;
    auto& rows = std::get<SetupTable>(project.analyses[1].setup.values.at("targets")).rows;
    rows.erase(rows.begin() + 4);  // P2 in pose 1
    Problems problems;
    EXPECT_EQ(made_analysis(project, "flange", problems), nullptr);
    ASSERT_FALSE(problems.items().empty());
    EXPECT_EQ(problems.items().front().path, "/analyses/2/setup/poses/rows/0");
    EXPECT_NE(problems.items().front().message.english().find("'P2 in pose 1'"), std::string::npos);
    // A set-up that refers to itself, and an analysis that offers nothing of the kind.
    project = project_;
    project.analyses[2].setup.values["base_asset"] = std::string("flange");
    problems = {};
    EXPECT_EQ(made_analysis(project, "flange", problems), nullptr);
    project.analyses[2].setup.values["base_asset"] = std::string("bar");
    problems = {};
    EXPECT_EQ(made_analysis(project, "flange", problems), nullptr);
    ASSERT_FALSE(problems.items().empty());
    EXPECT_NE(problems.items().front().message.english().find("does not offer"), std::string::npos);
}

/// Number of stated values that other analyses give, by the evaluation's note; 0: it has no such note.
std::size_t restated_links(const char* project, const char* analysis) {
    Problems problems;
    const auto made =
        made_analysis(load_project(data_directory() / "projects" / project).project, analysis, problems);
    for (const Problem& p : problems.items()) ADD_FAILURE() << p.path << ": " << p.message.english();
    if (!made) return 0;
    const std::vector<Table> tables = made->model->evaluation();
    if (tables.empty()) return 0;
    for (const Message& note : tables.front().notes) {
        const std::string words = note.english();
        const std::string before = "other analyses give (";
        if (const std::size_t at = words.find(before); at != std::string::npos)
            return std::stoul(words.substr(at + before.size()));
    }
    return 0;
}

// The set-up of the chain's network states a length of its own; that of the robot has what was identified.
TEST(LinkedEvaluation, SaysWhatTheSetUpStatesOtherwise) {
    EXPECT_GT(restated_links("chain.covaria", "tool"), 0u);
    EXPECT_EQ(restated_links("er10l-c10.covaria", "zero-pose-identified"), 0u);
    EXPECT_EQ(restated_links("er10l-c10.covaria", "zero-pose-from-poses"), 0u);
}

// Places of the flange that the robot is identified from: their ellipsoids are those of the analysis before.
TEST(ChainProject, LinkedPointsOfALayoutHaveTheirCovarianceMatrix) {
    const Project project = load_project(data_directory() / "projects/chain.covaria").project;
    Problems problems;
    const auto identification = made_analysis(project, "identification", problems);
    const auto flange = made_analysis(project, "flange", problems);
    ASSERT_TRUE(identification && flange);
    const auto result = evaluate_first_order(*flange->model, flange->inputs, {});
    ASSERT_TRUE(result);
    EXPECT_GE(identification->linked_points.size(), 6u);
    for (const LinkedPoint& point : identification->linked_points) {
        std::array<Eigen::Index, 3> rows{};
        for (std::size_t k = 0; k < 3; ++k) {
            const OutputQuantity& from = identification->linked.at(point.links[k]).output;
            const auto same = std::ranges::find_if(result->outputs, [&](const OutputResult& output) {
                return output.quantity.group == from.group && output.quantity.symbol == from.symbol;
            });
            ASSERT_NE(same, result->outputs.end());
            EXPECT_EQ(from.symbol, std::string(1, "xyz"[k]));
            rows[k] = same - result->outputs.begin();
        }
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) {
                const double expected = result->covariance(rows[i], rows[j]);
                const double scale =
                    std::sqrt(result->covariance(rows[i], rows[i]) * result->covariance(rows[j], rows[j]));
                EXPECT_GT(scale, 0.0);
                EXPECT_NEAR(point.covariance(Eigen::Index(i), Eigen::Index(j)), expected, 1e-9 * scale);
            }
    }
}

}  // namespace
}  // namespace covaria::chain_project_test
