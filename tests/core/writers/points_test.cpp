// Point lists for SpatialAnalyzer: read in again they are the same to the last digit, whatever points are
// called.
#include <cmath>
#include <sstream>

#include "core/base/resource_path.h"
#include "core/kinds/registries.h"
#include "core/model/measurement_model.h"
#include "core/readers/readers.h"
#include "core/text/numbers.h"
#include "tests/core/shipped_projects.h"
#include "tests/core/writers/evaluated.h"

namespace covaria::writers_test {

namespace {

/// Points whose coordinates are the inputs.
class PointModel : public MeasurementModel {
public:
    explicit PointModel(const std::vector<std::string>& names) : names_(names) {
        for (std::size_t i = 0; i < 3 * names.size(); ++i) {
            const std::string symbol = "q_" + std::to_string(i);
            UncertaintyComponent component;
            component.id = symbol;
            component.distribution = Distribution::normal(1e-6 * static_cast<double>(i + 1));
            component.unit = Unit::of("mm");
            InputQuantity quantity;
            quantity.symbol = symbol;
            quantity.unit = Unit::of("mm");
            quantity.offset = 0.1 * static_cast<double>(i) + 1.0 / 3.0;
            inputs_.add(quantity, {component});
            outputs_.push_back({.symbol = symbol, .unit = Unit::of("mm"), .group = names[i / 3]});
        }
    }
    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    bool evaluate(std::span<const double> x, std::span<double> y) const override {
        std::copy(x.begin(), x.end(), y.begin());
        return true;
    }
    Layout layout(std::span<const double> x) const override {
        Layout layout;
        for (std::size_t i = 0; i < names_.size(); ++i) {
            LayoutPoint point{.name = names_[i], .p_W = {x[3 * i], x[3 * i + 1], x[3 * i + 2]}};
            point.outputs = {{3 * i, 3 * i + 1, 3 * i + 2}};
            if (turned && i + 1 == names_.size())
                point.R_WQ = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()).toRotationMatrix();
            layout.points.push_back(point);
        }
        return layout;
    }
    bool turned = false;  ///< the axes of the last point

private:
    std::vector<std::string> names_;
    InputSet inputs_;
    std::vector<OutputQuantity> outputs_;
};

EvaluatedAnalysis analysis_of(const std::string& id, const std::string& name,
                              const std::vector<std::string>& points, bool turned = false) {
    auto model = std::make_shared<PointModel>(points);
    model->turned = turned;
    const auto propagated =
        std::make_shared<const PropagatedModel>(nullptr, std::make_shared<const InputSet>(model->inputs()));
    UncertaintyResult result;
    for (std::size_t i = 0; i < model->outputs().size(); ++i) {
        OutputResult output;
        output.quantity = model->outputs()[i];
        output.estimate = estimate_of(model->inputs(), i);
        output.standard_uncertainty = 1e-6 * static_cast<double>(i + 1) / 7.0;
        result.outputs.push_back(output);
    }
    const auto prepared =
        std::make_shared<const PreparedAnalysis>(PreparedAnalysis{.id = id,
                                                                  .name = name,
                                                                  .descriptor = nullptr,
                                                                  .assets = {},
                                                                  .propagated = propagated,
                                                                  .model = model,
                                                                  .inputs = propagated->inputs(),
                                                                  .options = {},
                                                                  .numbers = nullptr});
    return {prepared, std::make_shared<const UncertaintyResult>(std::move(result)), {}, {}};
}

/// x y z Ux Uy Uz as they were read; names with their group.
struct ReadPoint {
    std::string name;
    std::vector<double> figures;
};

/// The points of "Points as stated", the analysis that `covaria import` makes.
std::vector<ReadPoint> points_back(const std::string& text) {
    const auto read = find_reader("spatialanalyzer")->read(text, {.file_name = "points.txt", .chosen = true});
    EXPECT_TRUE(read) << read.error().message.english() << "\n" << text;
    if (!read || read->analyses.empty()) return {};
    const AnalysisEntry& analysis = read->analyses.at(0);
    const SetupSchema& schema = find_model(analysis.model)->schema;
    const auto& rows = std::get<SetupTable>(analysis.setup.values.at("quantities")).rows;
    const auto column = [&](const char* key) { return SetupSchema::column(*schema.find("quantities"), key); };
    std::vector<ReadPoint> points;
    for (std::size_t i = 0; i + 2 < rows.size(); i += 3) {
        ReadPoint point{std::get<std::string>(rows[i].at(column("name"))), {}};
        for (const char* key : {"value", "a"})
            for (std::size_t axis = 0; axis < 3; ++axis)
                point.figures.push_back(std::get<double>(rows[i + axis].at(column(key))));
        points.push_back(std::move(point));
    }
    return points;
}

std::vector<double> figures_mm(const UncertaintyResult& result, std::size_t first) {
    const Unit mm = Unit::of("mm");
    std::vector<double> figures;
    for (std::size_t axis = 0; axis < 3; ++axis)
        figures.push_back(mm.interval_from_si(result.outputs[first + axis].estimate));
    for (std::size_t axis = 0; axis < 3; ++axis)
        figures.push_back(mm.interval_from_si(result.outputs[first + axis].standard_uncertainty));
    return figures;
}

TEST(WritePoints, ComeBackToTheLastDigitWhateverTheyAreCalled) {
    const std::vector<std::string> names{
        "A 1",         "=SUM(A1)", "+7",           "@x",       "-1",  "a,b;c\td", "say \"hi\"",
        "line\nbreak", "",         "# no comment", "//",       "42",  "1e3",      "A 1",
        "nan",         "Öse 5",    "'x",           "\x01\x02", "7 8", "5 5 5",    "\xff bad"};
    for (const std::string group : {"Group", "Run 2 b 3", "12", "=x", "", "#", "1 2 3", "a;b", "nan"}) {
        const std::vector<EvaluatedAnalysis> analyses{analysis_of("id", group, names)};
        const auto written = write_as("points", {*MadeProject::make(Project{}), analyses});
        ASSERT_TRUE(written) << written.error().message.english();
        const auto points = points_back(written->bytes);
        ASSERT_EQ(points.size(), names.size()) << group << "\n" << written->bytes;
        for (std::size_t i = 0; i < points.size(); ++i)
            EXPECT_EQ(points[i].figures, figures_mm(*analyses[0].result, 3 * i)) << group << ": " << names[i];
        std::istringstream lines(written->bytes);
        for (std::string line; std::getline(lines, line);) {
            EXPECT_EQ(std::count(line.begin(), line.end(), ','), 7) << line;
            EXPECT_EQ(line.find_first_of("\"\t;\r"), std::string::npos) << line;
            for (const std::string& cell : {line, line.substr(line.find(',') + 1)})
                EXPECT_EQ(std::string_view("=+-@#/'").find(cell.front()), std::string_view::npos) << line;
        }
    }
}

TEST(WritePoints, AnalysesAndFramesAreGroupsOfTheirOwn) {
    const std::vector<EvaluatedAnalysis> analyses{analysis_of("a", "Jig", {"P", "Q"}),
                                                  analysis_of("b", "Jig", {"P"}),
                                                  analysis_of("c", "Tool", {"P", "TCP"}, true)};
    const auto written = write_as("points", {*MadeProject::make(Project{}), analyses});
    ASSERT_TRUE(written);
    std::vector<std::string> names;
    std::istringstream lines(written->bytes);
    for (std::string line; std::getline(lines, line);)
        names.push_back(line.substr(0, line.find(',', line.find(',') + 1)));
    EXPECT_EQ(names, (std::vector<std::string>{"Jig,P", "Jig,Q", "Jig (2),P", "Tool,P", "Tool TCP,TCP"}));
    ASSERT_EQ(written->said.size(), 2u);
    EXPECT_NE(written->said[1].find("in other axes"), std::string::npos);
}

TEST(WritePoints, WhatIsNotFiniteOrNoPointIsSaid) {
    EvaluatedAnalysis lost = analysis_of("a", "Jig", {"P", "Q"});
    UncertaintyResult result = *lost.result;
    result.outputs[1].standard_uncertainty = infinity;
    lost.result = std::make_shared<const UncertaintyResult>(result);
    const auto written = write_as("points", {*MadeProject::make(Project{}), {lost}});
    ASSERT_TRUE(written);
    EXPECT_EQ(written->bytes.substr(0, 6), "Jig,Q,");
    EXPECT_NE(written->said.back().find("point P of analysis a"), std::string::npos) << written->said.back();
    result.trials = 100;
    result.failed_trials = 50;
    lost.result = std::make_shared<const UncertaintyResult>(result);
    EXPECT_FALSE(write_as("points", {*MadeProject::make(Project{}), {lost}}));
    EXPECT_FALSE(write_as("points", {*MadeProject::make(Project{}), {}}));
}

TEST(WritePoints, OfShippedProjectsComeBack) {
    std::size_t with_points = 0;
    for (const char* name : {"lsm-network", "ballbar-tcp", "stewart-platform"}) {
        const Evaluated evaluated =
            evaluate(loaded(data_directory() / "projects" / (std::string(name) + ".covaria")));
        const auto written = write_as("points", evaluated.source());
        ASSERT_TRUE(written) << name << ": " << written.error().message.english();
        EXPECT_EQ(written->bytes, write_as("points", evaluated.source())->bytes);
        const auto points = points_back(written->bytes);
        std::istringstream lines(written->bytes);
        std::size_t i = 0;
        for (std::string line; std::getline(lines, line) && i < points.size(); ++i) {
            std::string figures;
            for (const double figure : points[i].figures) figures += "," + format_exact(figure);
            EXPECT_TRUE(line.ends_with(figures)) << name << ": " << line << " against " << figures;
        }
        EXPECT_GT(i, 3u) << name;
        with_points += i;
    }
    EXPECT_GT(with_points, 20u);
}

}  // namespace

}  // namespace covaria::writers_test
