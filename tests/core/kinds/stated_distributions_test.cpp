// A distribution may be stated wherever a standard uncertainty is typed: u stays, the draws have its shape.
// Over every schema: each such field or column offers the same choices, and the default is as before.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/resource_path.h"
#include "core/kinds/points/stated_figure.h"
#include "core/kinds/registries.h"
#include "tests/core/made.h"

namespace covaria::stated_distributions_test {
namespace {

const std::vector<std::string> shapes{"normal", "rectangular", "triangular", "arcsine"};

TEST(StatedDistributions, KeepTheStandardUncertainty) {
    for (const std::string& shape : shapes) {
        const Distribution d = distribution_of_shape(shape, 0.3);
        EXPECT_EQ(d.kind(), shape);
        EXPECT_NEAR(d.standard_uncertainty(), 0.3, 1e-15) << shape;
        EXPECT_EQ(d.mean(), 0.0);
    }
    EXPECT_EQ(distribution_of_shape("", 0.3), Distribution::normal(0.3));
    EXPECT_NEAR(specified_distribution("limit-arcsine", 1.0).standard_uncertainty(), std::sqrt(0.5), 1e-15);
}

/// Sets every field of shapes that the schema has; how many there are.
int state_shape(const SetupSchema& schema, const std::string& shape, Setup& setup) {
    int fields = 0;
    for (const FieldSpec& field : schema.fields()) {
        const std::string word = "distribution";
        if (field.kind != FieldKind::choice || field.choices.empty() || field.choices[0].key != "normal")
            continue;
        if (field.key.size() < word.size() || field.key.substr(field.key.size() - word.size()) != word)
            continue;
        EXPECT_EQ(std::get<std::string>(field.default_value), "normal") << field.key;
        EXPECT_EQ(field.choices.size(), shapes.size()) << field.key;
        setup.values[field.key] = shape;
        ++fields;
    }
    return fields;
}

/// First order is the same for any shape; no normal component is left among those that were stated so.
TEST(StatedDistributions, ReachTheComponentsOfShippedProjects) {
    int fields = 0;
    for (const char* name : {"tracker-pose", "stewart-platform", "ballbar-tcp", "lsm-network"}) {
        const Project shipped =
            load_project(data_directory() / "projects" / (std::string(name) + ".covaria")).project;
        for (const AnalysisEntry& analysis : shipped.analyses) {
            std::vector<double> usual;
            for (const std::string& shape : shapes) {
                Project project = shipped;
                for (AssetEntry& asset : project.assets)
                    fields += state_shape(find_asset_kind(asset.kind)->schema, shape, asset.setup);
                for (AnalysisEntry& entry : project.analyses) {
                    fields += state_shape(find_model(entry.model)->schema, shape, entry.setup);
                    entry.options.method = Method::first_order;
                    entry.inputs.clear();
                    entry.correlations.clear();
                }
                Problems problems;
                const auto prepared = made_analysis(project, analysis.id, problems);
                ASSERT_NE(prepared, nullptr) << name << ": " << problems.items().front().message.english();
                const auto result = run_analysis(*prepared, {});
                ASSERT_TRUE(result) << name;
                for (std::size_t j = 0; j < result->outputs.size(); ++j) {
                    const double u = result->outputs[j].first_order.standard_uncertainty;
                    if (shape == "normal") usual.push_back(u);
                    EXPECT_NEAR(u, usual[j], 1e-9 * usual[j]) << name << ", " << shape;
                }
                if (shape == "normal") continue;
                for (const UncertaintyComponent& c : prepared->inputs.components)
                    if (c.id.find(".station.") != std::string::npos) {
                        EXPECT_EQ(c.distribution.kind(), shape) << c.id;
                    }
            }
        }
    }
    EXPECT_GT(fields, 40);
}

}  // namespace
}  // namespace covaria::stated_distributions_test
