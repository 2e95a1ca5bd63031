// The promises of every measurement model, checked for each one in the registry with the analyses of its
// example.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>
#include <sstream>

#include "core/base/resource_path.h"
#include "core/kinds/registries.h"
#include "core/model/has_layout.h"
#include "core/project/project_file.h"
#include "core/propagation/engine.h"
#include "core/views/decisions.h"
#include "tests/core/kinds/allocation_counter.h"
#include "tests/core/made.h"

namespace covaria::contract_test {
namespace {

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::filesystem::path example_of(const ModelDescriptor& d) {
    return data_directory() / "projects" / d.example;
}

struct Analysis {
    Project project;
    AnalysisEntry entry;
    std::shared_ptr<const PreparedAnalysis> prepared;
    const MeasurementModel& model() const { return *prepared->model; }
    const InputSet& inputs() const { return prepared->inputs; }
};

// The analyses of the example that use the model.
std::vector<Analysis> analyses_of(const ModelDescriptor& d) {
    const LoadedProject loaded = load_project(example_of(d));
    for (const Problem& p : loaded.problems.items())
        ADD_FAILURE() << p.file << ":" << p.line << " " << p.message.english();
    Problems problems;
    std::vector<Analysis> all;
    for (const AnalysisEntry& entry : loaded.project.analyses) {
        if (entry.model != d.id) continue;
        auto prepared = made_analysis(loaded.project, entry.id, problems);
        if (prepared) all.push_back({loaded.project, entry, prepared});
    }
    for (const Problem& p : problems.items()) ADD_FAILURE() << p.path << " " << p.message.english();
    EXPECT_FALSE(all.empty()) << d.example << " has no analysis with " << d.id;
    return all;
}

std::vector<double> estimates(const InputSet& inputs) {
    std::vector<double> x;
    for (std::size_t i = 0; i < inputs.quantities.size(); ++i) x.push_back(estimate_of(inputs, i));
    return x;
}

// Trials around the estimates, as the engine lays them out.
class Block {
public:
    static constexpr std::size_t trials = 61, stride = 64;
    Block(const MeasurementModel& model, const InputSet& inputs)
        : n_in_(inputs.quantities.size()), in_(allocate(n_in_)), out_(allocate(model.outputs().size())) {
        for (std::size_t i = 0; i < n_in_; ++i)
            for (std::size_t t = 0; t < stride; ++t)
                in_.get()[i * stride + t] =
                    estimate_of(inputs, i) + 2.0 * standard_uncertainty_of(inputs, i) *
                                                 std::sin(1.0 + 12.9898 * double(i) + 78.233 * double(t));
        model.evaluate_block({in_.get(), out_.get(), valid, stride, trials});
    }
    std::vector<double> trial(std::size_t t) const {
        std::vector<double> x(n_in_);
        for (std::size_t i = 0; i < n_in_; ++i) x[i] = in_.get()[i * stride + t];
        return x;
    }
    double output(std::size_t j, std::size_t t) const { return out_.get()[j * stride + t]; }
    TrialBlock view() { return {in_.get(), out_.get(), valid, stride, trials}; }
    std::uint8_t valid[stride] = {};

private:
    struct Free {
        void operator()(double* p) const { std::free(p); }
    };
    static double* allocate(std::size_t rows) {
        return static_cast<double*>(std::aligned_alloc(64, rows * stride * sizeof(double)));
    }
    std::size_t n_in_;
    std::unique_ptr<double, Free> in_, out_;
};

// A t distribution, whose standard deviation is not the u of the law of propagation, becomes normal.
InputSet scaled(InputSet inputs, double factor) {
    for (UncertaintyComponent& c : inputs.components) {
        if (const auto* t = std::get_if<StudentT>(&c.distribution.parameters()))
            c.distribution = Distribution::of(Normal{t->mean, t->scale});
        c.normal_draws = true;
        const double mean = c.distribution.mean();
        c.distribution = c.distribution.shifted(-mean).scaled(factor).shifted(mean);
    }
    return inputs;
}

double turned(const OutputQuantity& output, double difference) {
    return output.periodic ? std::remainder(difference, 2.0 * std::numbers::pi) : difference;
}

class Contract : public testing::TestWithParam<const ModelDescriptor*> {
protected:
    const ModelDescriptor& descriptor() const { return *GetParam(); }
};

TEST_P(Contract, IsDescribed) {
    const ModelDescriptor& d = descriptor();
    EXPECT_FALSE(d.title.empty() || d.summary.empty());
    EXPECT_FALSE(d.references.empty());
    EXPECT_FALSE(d.notes.empty());
    EXPECT_FALSE(d.equations.empty());
    for (const ModelEquation& e : d.equations) EXPECT_FALSE(e.text.empty() || e.source.empty());
    EXPECT_GT(bytes_of(data_directory() / "resources" / "help" / d.help_page).size(), 1000u) << d.help_page;
}

TEST_P(Contract, EveryFieldHasHelpAndItsUnit) {
    std::set<std::string> keys;
    for (const FieldSpec& f : descriptor().schema.fields()) {
        EXPECT_TRUE(keys.insert(f.key).second) << f.key;
        EXPECT_FALSE(f.title.empty() || f.help.empty() || f.section.empty()) << f.key;
        if (const Quantity* q = std::get_if<Quantity>(&f.default_value)) {
            EXPECT_EQ(q->unit.dimension(), f.unit.dimension()) << f.key;
        }
        EXPECT_EQ(f.kind == FieldKind::table, !f.columns.empty()) << f.key;
        EXPECT_EQ(f.kind == FieldKind::choice, !f.choices.empty()) << f.key;
        for (const ColumnSpec& c : f.columns)
            EXPECT_FALSE(c.title.empty() || c.help.empty()) << f.key << c.key;
    }
}

TEST_P(Contract, ExampleLoadsAndIsWrittenByteForByte) {
    const LoadedProject loaded = load_project(example_of(descriptor()));
    for (const Problem& p : loaded.problems.items())
        ADD_FAILURE() << p.file << ":" << p.line << " " << p.message.english();
    EXPECT_EQ(project_text(loaded.project), bytes_of(example_of(descriptor())));
}

TEST_P(Contract, QuantitiesAreNamedOnce) {
    for (const Analysis& a : analyses_of(descriptor())) {
        std::set<std::string> symbols, ids, outputs;
        for (const InputQuantity& q : a.inputs().quantities) {
            EXPECT_TRUE(symbols.insert(q.symbol).second) << q.symbol;
            EXPECT_FALSE(q.name.empty());
        }
        for (const UncertaintyComponent& c : a.inputs().components) {
            EXPECT_TRUE(ids.insert(c.id).second) << c.id;
            EXPECT_FALSE(c.name.empty() || c.origin.empty()) << c.id;
        }
        for (const OutputQuantity& y : a.model().outputs()) {
            EXPECT_TRUE(outputs.insert(y.group + "/" + y.symbol).second) << y.group << y.symbol;
            EXPECT_FALSE(y.name.empty());
        }
    }
}

/// Names are put together from parts: none of them may be missing or there twice.
void expect_whole(const Message& name) {
    const std::string words = name.english();
    for (const char* wrong : {", ,", ",,", "  ", " ,", "coordinate , ", "%1"})
        EXPECT_EQ(words.find(wrong), std::string::npos) << words;
    EXPECT_TRUE(words.empty() || (words.back() != ' ' && words.back() != ',')) << words;
}

TEST_P(Contract, NamesAreWhole) {
    for (const Analysis& a : analyses_of(descriptor())) {
        for (const InputQuantity& q : a.inputs().quantities) expect_whole(q.name);
        for (const OutputQuantity& y : a.model().outputs()) expect_whole(y.name);
        for (const UncertaintyComponent& c : a.inputs().components) {
            expect_whole(c.name);
            expect_whole(c.origin);
        }
    }
}

TEST_P(Contract, EvaluatesFinitelyAndDeterministically) {
    for (const Analysis& a : analyses_of(descriptor())) {
        const std::vector<double> x = estimates(a.inputs());
        std::vector<double> y(a.model().outputs().size()), again(y.size(), 1.0);
        ASSERT_TRUE(a.model().evaluate(x, y));
        ASSERT_TRUE(a.model().evaluate(x, again));
        EXPECT_EQ(y, again);
        for (double v : y) EXPECT_TRUE(std::isfinite(v));
    }
}

TEST_P(Contract, ABlockEqualsItsTrialsToRounding) {
    for (const Analysis& a : analyses_of(descriptor())) {
        const Block block(a.model(), a.inputs());
        std::vector<double> y(a.model().outputs().size());
        for (std::size_t t = 0; t < Block::trials; ++t) {
            ASSERT_EQ(a.model().evaluate(block.trial(t), y), block.valid[t] == 1);
            for (std::size_t j = 0; j < y.size(); ++j)
                EXPECT_LE(std::abs(turned(a.model().outputs()[j], block.output(j, t) - y[j])),
                          1e-13 * std::max(1.0, std::abs(y[j])))
                    << a.model().outputs()[j].symbol;
        }
    }
}

TEST_P(Contract, ABlockAllocatesNothing) {
    if (!allocations_are_counted()) GTEST_SKIP() << "the sanitizer has an allocator of its own";
    for (const Analysis& a : analyses_of(descriptor())) {
        Block block(a.model(), a.inputs());  // has run once: buffers of the thread are there
        const std::size_t before = allocations_of_this_thread();
        a.model().evaluate_block(block.view());
        EXPECT_EQ(allocations_of_this_thread(), before);
        void* (*volatile allocate)(std::size_t) =
            std::malloc;  // volatile: the optimiser may not elide the pair
        std::free(allocate(1));
        EXPECT_GT(allocations_of_this_thread(), before) << "the counter does not count";
    }
}

TEST_P(Contract, JacobianEqualsCentralDifferences) {
    for (const Analysis& a : analyses_of(descriptor())) {
        const std::vector<double> x = estimates(a.inputs());
        Eigen::MatrixXd exact, differences;
        ASSERT_TRUE(a.model().jacobian(x, exact));
        ASSERT_TRUE(a.model().MeasurementModel::jacobian(x, differences));
        for (Eigen::Index j = 0; j < exact.rows(); ++j) {
            const double scale = exact.row(j).cwiseAbs().maxCoeff();
            EXPECT_GT(scale, 0.0) << "no input has an influence";
            EXPECT_LT((exact.row(j) - differences.row(j)).cwiseAbs().maxCoeff(), 1e-7 * scale);
        }
    }
}

TEST_P(Contract, SensitivitiesAreTheJacobianWithoutItsZeros) {
    for (const Analysis& a : analyses_of(descriptor())) {
        const std::vector<double> x = estimates(a.inputs());
        Eigen::MatrixXd exact;
        SensitivityRows rows;
        ASSERT_TRUE(a.model().jacobian(x, exact));
        ASSERT_TRUE(a.model().sensitivities(x, rows));
        ASSERT_EQ(rows.size(), a.model().outputs().size());
        for (std::size_t j = 0; j < rows.size(); ++j) {
            Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(exact.cols());
            for (const Sensitivity& s : rows[j]) row[static_cast<Eigen::Index>(s.input)] += s.coefficient;
            const auto of_matrix = exact.row(static_cast<Eigen::Index>(j));
            EXPECT_LE((row - of_matrix).cwiseAbs().maxCoeff(), 1e-9 * of_matrix.cwiseAbs().maxCoeff());
        }
    }
}

TEST_P(Contract, SensitivitiesRowByRowAreAllRows) {
    for (const Analysis& analysis : analyses_of(*GetParam())) {
        const std::vector<double> x = estimates(analysis.inputs());
        const auto source = analysis.model().sensitivity_source(x);
        if (!source) continue;
        SensitivityRows all;
        ASSERT_TRUE(analysis.model().sensitivities(x, all));
        std::vector<Sensitivity> row;
        for (std::size_t j = 0; j < all.size(); ++j) {
            ASSERT_TRUE(source->row(j, row));
            ASSERT_EQ(row.size(), all[j].size());
            for (std::size_t i = 0; i < row.size(); ++i) {
                EXPECT_EQ(row[i].input, all[j][i].input);
                EXPECT_EQ(row[i].coefficient, all[j][i].coefficient);
            }
        }
    }
}

TEST_P(Contract, VerdictsOfTablesAreDeclared) {
    bool any = false;
    for (const Analysis& analysis : analyses_of(*GetParam()))
        any = any || !decisions_in(analysis.model().evaluation()).empty();
    EXPECT_EQ(any, GetParam()->decides);
}

TEST_P(Contract, MonteCarloAgreesWithTheLawOfPropagationForSmallUncertainties) {
    for (const Analysis& a : analyses_of(descriptor())) {
        EvaluationOptions options;
        options.trials = 100'000;
        const UncertaintyResult r = evaluate(a.model(), scaled(a.inputs(), 1e-3), options).value();
        EXPECT_EQ(r.failed_trials, 0u);
        for (const OutputResult& y : r.outputs)
            EXPECT_NEAR(y.monte_carlo->standard_uncertainty, y.first_order.standard_uncertainty,
                        4.0 * y.monte_carlo->standard_error_of_uncertainty)
                << y.quantity.group << y.quantity.symbol;
    }
}

TEST_P(Contract, ZeroUncertaintyGivesZero) {
    for (const Analysis& a : analyses_of(descriptor())) {
        EvaluationOptions options;
        options.trials = 10'000;
        const UncertaintyResult r = evaluate(a.model(), scaled(a.inputs(), 0.0), options).value();
        for (const OutputResult& y : r.outputs) {
            EXPECT_EQ(y.first_order.standard_uncertainty, 0.0);
            EXPECT_LE(y.monte_carlo->standard_uncertainty, 1e-14 * std::max(1.0, std::abs(y.estimate)));
        }
    }
}

// "/poses/rows/3" must be a field of the set-up, or of that of an asset, and the row must be there.
void expect_source_exists(const std::string& path, const Analysis& a, const std::string& asset = {}) {
    if (path.empty()) return;
    const AssetEntry* entry = a.project.find_asset(asset);
    ASSERT_TRUE(asset.empty() || entry) << asset;
    const SetupSchema& schema = entry ? find_asset_kind(entry->kind)->schema : a.prepared->descriptor->schema;
    const std::string key = path.substr(1, path.find('/', 1) - 1);
    ASSERT_NE(schema.find(key), nullptr) << path;
    const std::size_t rows = path.find("/rows/");
    if (rows == std::string::npos) return;
    const covaria::Setup& setup = entry ? entry->setup : a.entry.setup;
    const auto* table = std::get_if<SetupTable>(&value_of(*schema.find(key), setup));
    ASSERT_NE(table, nullptr) << path;
    EXPECT_LT(std::stoul(path.substr(rows + 6)), table->rows.size()) << path;
}

TEST_P(Contract, LayoutRefersToWhatExists) {
    for (const Analysis& a : analyses_of(descriptor())) {
        const auto& outputs = a.model().outputs();
        std::set<std::string> groups{""};
        for (const OutputQuantity& y : outputs) groups.insert(y.group);
        const Layout layout = a.model().layout(estimates(a.inputs()));
        if (!has_layout(a.model(), a.inputs())) continue;  // quantities that are nowhere in space
        EXPECT_FALSE(layout.points.empty());
        for (const LayoutPoint& p : layout.points) {
            EXPECT_TRUE(p.p_W.allFinite()) << p.name;
            EXPECT_TRUE(groups.contains(p.group)) << p.group;
            expect_source_exists(p.source.path, a, p.source.asset);
            for (std::size_t i : p.inputs.value_or(std::array<std::size_t, 3>{}))
                EXPECT_LT(i, a.inputs().quantities.size());
            if (!p.outputs) continue;
            for (std::size_t j : *p.outputs) {
                ASSERT_LT(j, outputs.size());
                EXPECT_TRUE(p.group.empty() || p.group == outputs[j].group) << p.name;
            }
        }
        for (const LayoutFrame& f : layout.frames) {
            EXPECT_TRUE(groups.contains(f.group));
            EXPECT_LT((f.X_WF.linear().transpose() * f.X_WF.linear() - Eigen::Matrix3d::Identity()).norm(),
                      1e-12);
            expect_source_exists(f.source.path, a, f.source.asset);
        }
        for (const LayoutBody& b : layout.bodies) {
            EXPECT_TRUE(groups.contains(b.group));
            expect_source_exists(b.source.path, a, b.source.asset);
        }
        for (const LayoutLink& l : layout.links) EXPECT_TRUE(groups.contains(l.group));
    }
}

TEST_P(Contract, SourcesOfInputsExist) {
    for (const Analysis& a : analyses_of(descriptor()))
        for (const InputQuantity& q : a.inputs().quantities) expect_source_exists(q.source, a);
}

std::vector<const ModelDescriptor*> all_models() {
    std::vector<const ModelDescriptor*> models;
    for (const ModelDescriptor& d : model_registry()) models.push_back(&d);
    return models;
}

std::string name_of(const testing::TestParamInfo<const ModelDescriptor*>& info) {
    std::string name = info.param->id;
    for (char& c : name)
        if (c == '-') c = '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Models, Contract, testing::ValuesIn(all_models()), name_of);

}  // namespace
}  // namespace covaria::contract_test
