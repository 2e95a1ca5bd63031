// Networks of Comp3D against its own results, where its examples are beside the checkout, and against
// networks that are computed by hand.
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/kinds/registries.h"
#include "core/readers/comp3d_site.h"
#include "tests/core/readers/reading.h"

namespace covaria::readers_test {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path examples = "/work/shared/formats/comp3d";

struct AdjustedImport {
    double degrees_of_freedom = NAN, s0 = NAN, sum_of_squares = NAN;
    std::map<std::string, double> estimate, u;  ///< by "A_x"
    std::string found;
};

AdjustedImport adjusted(const Result<Proposals>& read) {
    AdjustedImport made;
    EXPECT_TRUE(read) << read.error().message.english();
    if (!read) return made;
    made.found = all_found(*read);
    EXPECT_EQ(errors_of(*read), "") << made.found;
    EXPECT_EQ(read->analyses.size(), 1u) << made.found;
    if (read->analyses.size() != 1) return made;
    EXPECT_EQ(read->analyses[0].model, "network-adjustment") << made.found;
    Project project;
    add_to_project(project, *read);
    project.analyses[0].options.method = Method::first_order;
    const auto project_made = MadeProject::make(std::move(project));
    const auto prepared = project_made->analysis(project_made->project().analyses[0].id);
    if (!prepared) return made;
    const auto result = run_analysis(*prepared);
    EXPECT_TRUE(result);
    if (!result) return made;
    for (const OutputResult& output : result->outputs) {
        const std::string name = output.quantity.group + "_" + output.quantity.symbol.substr(0, 1);
        made.estimate[name] = output.estimate;
        made.u[name] = output.standard_uncertainty;
    }
    for (const Table& table : prepared->model->evaluation()) {
        if (table.id != "adjustment") continue;
        for (std::size_t row = 0; row < table.rows; ++row) {
            const std::string words = english_of(table.columns[0].cell(row));
            const auto value = exact_quantity(table.columns[1].cell(row));
            if (!value) continue;
            if (words.starts_with("degrees of freedom")) made.degrees_of_freedom = value->value;
            if (words.starts_with("s₀")) made.s0 = value->value;
            if (words.starts_with("sum of squares")) made.sum_of_squares = value->value;
        }
    }
    return made;
}

Result<Proposals> import(const fs::path& file) {
    const auto text = read_file(file);
    EXPECT_TRUE(text) << file;
    const auto reader = reader_for(text.value_or(""), file.filename().string());
    EXPECT_TRUE(reader) << file;
    if (!reader) return fail(reader.error());
    return (*reader)->read(*text, {.file_name = file.filename().string(), .beside = neighbours_of(file)});
}

json results_of(const std::string& example) {
    const std::string text = read_file(examples / example / "ex_ref.comp").value_or("");
    return json::parse(text.substr(std::min(text.find('{'), text.size())), nullptr, false);
}

/// Holds coordinates, sigma 0, redundancy and standard deviations against those of Comp3D.
void hold(const std::string& example, const std::string& file, double printed) {
    SCOPED_TRACE(example + "/" + file);
    const AdjustedImport here = adjusted(import(examples / example / file));
    const json results = results_of(example);
    ASSERT_TRUE(results.is_object());
    const json& computed = results["computation"];
    EXPECT_EQ(here.degrees_of_freedom,
              computed["nbr_active_obs"].get<int>() - computed["nbr_parameters"].get<int>())
        << here.found;
    const double sigma0 = computed["sigma_0_final"].get<double>();
    EXPECT_NEAR(here.s0, sigma0, 1e-6 * sigma0);
    std::size_t held = 0;
    for (const auto& [name, point] : results["points"].items())
        for (const auto& [key, parameter] : point["params"].items()) {
            const std::size_t axis = std::string("xyz").find(key.back());
            if (key.size() != name.size() + 2 || axis == std::string::npos) continue;
            ASSERT_TRUE(here.estimate.contains(key)) << key << "\n" << here.found;
            EXPECT_NEAR(here.estimate.at(key), point["coord_compensated_georef"][axis].get<double>(), printed)
                << key;
            ++held;
            if (parameter.contains("sigma") && parameter["sigma"].is_number()) {
                const double sigma = parameter["sigma"].get<double>();
                EXPECT_NEAR(here.u.at(key) * here.s0, sigma, 1e-4 * sigma) << key;
            }
        }
    EXPECT_GT(held, 0u);
}

class Comp3dExamples : public testing::Test {
    void SetUp() override {
        if (!fs::exists(examples)) GTEST_SKIP() << "the examples of Comp3D are not beside the checkout";
    }
};

TEST_F(Comp3dExamples, AgreeWithItsOwnResults) {
    for (const char* file : {"obs.obs", "ex_ref.comp"}) {
        hold("simple2D", file, 1e-7);
        hold("centering", file, 1e-7);
        hold("corcov", file, 1e-7);
    }
    for (const char* file : {"ex.obs", "ex_ref.comp"}) hold("minimal", file, 1e-7);
}

TEST_F(Comp3dExamples, WithNothingToAdjustAreQuantitiesOrPoints) {
    const auto fixed = import(examples / "fixed_points/obs.obs");
    ASSERT_TRUE(fixed);
    EXPECT_EQ(errors_of(*fixed), "");
    EXPECT_NE(all_found(*fixed).find("would change none of its points"), std::string::npos)
        << all_found(*fixed);
    const auto axis = import(examples / "axe/obs.obs");
    ASSERT_TRUE(axis) << axis.error().message.english();
    EXPECT_EQ(errors_of(*axis), "");
    const std::string said = all_found(*axis);
    EXPECT_NE(said.find("1 a rotation axis, axe1"), std::string::npos) << said;
    EXPECT_NE(said.find("@obs2.axe"), std::string::npos) << said;
    ASSERT_EQ(axis->assets.size(), 1u);
}

}  // namespace

}  // namespace covaria::readers_test
