// A project made out of the state before equals one made of nothing: random edits of every shipped
// project.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <random>

#include "core/propagation/engine.h"
#include "tests/core/made.h"
#include "tests/core/shipped_projects.h"

namespace covaria::incremental_making_test {
namespace {

/// A project under somebody's hands: values, names, order, links, entries that come and go.
class Editor {
public:
    Editor(Project project, unsigned seed) : whole_(project), project_(std::move(project)), random_(seed) {}
    const Project& project() const { return project_; }

    void edit() {
        using Edit = void (Editor::*)();
        const Edit edits[] = {&Editor::change_a_value, &Editor::change_a_value, &Editor::change_a_value,
                              &Editor::rename,         &Editor::exchange,       &Editor::change_links,
                              &Editor::change_inputs,  &Editor::remove,         &Editor::bring_back};
        (this->*edits[below(std::size(edits))])();
    }

private:
    std::size_t below(std::size_t count) { return random_() % count; }
    Setup& some_setup() {
        const std::size_t i = below(project_.assets.size() + project_.analyses.size());
        return i < project_.assets.size() ? project_.assets[i].setup
                                          : project_.analyses[i - project_.assets.size()].setup;
    }
    double changed(double value) {
        return below(6) == 0 ? -value : value * (1.0 + 1e-3 * double(1 + below(9)));
    }
    void change_a_value() {
        if (empty()) return;
        Setup& setup = some_setup();
        if (setup.values.empty()) return;
        SetupValue& value =
            std::next(setup.values.begin(), std::ptrdiff_t(below(setup.values.size())))->second;
        if (auto* number = std::get_if<Quantity>(&value)) number->value = changed(number->value);
        if (auto* flag = std::get_if<bool>(&value)) *flag = !*flag;
        if (auto* pose = std::get_if<PoseValue>(&value)) pose->position[below(3)] += 0.5;
        if (auto* table = std::get_if<SetupTable>(&value); table && !table->rows.empty()) {
            auto& row = table->rows[below(table->rows.size())];
            SetupCell& cell = row[below(row.size())];
            if (auto* number = std::get_if<double>(&cell)) *number = changed(*number);
            if (auto* text = std::get_if<std::string>(&cell); text && below(3) == 0) *text += "x";
        }
    }
    void rename() {
        if (empty()) return;
        if (below(2) == 0 && !project_.assets.empty())
            project_.assets[below(project_.assets.size())].name += "'";
        else if (!project_.analyses.empty())
            project_.analyses[below(project_.analyses.size())].name += "'";
    }
    void exchange() {
        if (auto& a = project_.assets; a.size() > 1) std::swap(a[below(a.size())], a[below(a.size())]);
        if (auto& a = project_.analyses; a.size() > 1) std::swap(a[below(a.size())], a[below(a.size())]);
    }
    void change_links() {
        for (AnalysisEntry& analysis : project_.analyses)
            if (!analysis.links.empty() && below(2) == 0) {
                InputLink& link = analysis.links[below(analysis.links.size())];
                if (below(2) == 0)
                    link.linearised = !link.linearised;
                else
                    link.output.analysis = project_.analyses[below(project_.analyses.size())].id;
            }
    }
    void change_inputs() {
        if (project_.analyses.empty()) return;
        AnalysisEntry& analysis = project_.analyses[below(project_.analyses.size())];
        if (analysis.inputs.empty()) return;
        InputEdit& input = analysis.inputs[below(analysis.inputs.size())];
        if (input.estimate)
            input.estimate->value = changed(input.estimate->value);
        else
            input.held = !input.held;
    }
    void remove() {
        if (auto& a = project_.assets; !a.empty() && below(2) == 0)
            a.erase(a.begin() + std::ptrdiff_t(below(a.size())));
        else if (auto& b = project_.analyses; b.size() > 1)
            b.erase(b.begin() + std::ptrdiff_t(below(b.size())));
    }
    void bring_back() { project_ = whole_; }
    bool empty() const { return project_.assets.empty() && project_.analyses.empty(); }

    Project whole_, project_;
    std::mt19937 random_;
};

void expect_same(const PreparedAnalysis& now, const PreparedAnalysis& fresh) {
    EXPECT_EQ(now.name, fresh.name);
    EXPECT_EQ(now.fingerprint(), fresh.fingerprint());
    EXPECT_EQ(now.forecast, fresh.forecast);
    ASSERT_EQ(now.inputs.components.size(), fresh.inputs.components.size());
    for (std::size_t i = 0; i < now.inputs.components.size(); ++i) {
        EXPECT_EQ(now.inputs.components[i].id, fresh.inputs.components[i].id);
        EXPECT_EQ(now.inputs.components[i].name, fresh.inputs.components[i].name);
    }
    const auto a = evaluate_first_order(*now.propagated, now.options);
    const auto b = evaluate_first_order(*fresh.propagated, fresh.options);
    ASSERT_EQ(bool(a), bool(b));
    if (!a) return;
    ASSERT_EQ(a->outputs.size(), b->outputs.size());
    for (std::size_t j = 0; j < a->outputs.size(); ++j) {
        const FirstOrderOutput &x = a->outputs[j].first_order, &y = b->outputs[j].first_order;
        EXPECT_EQ(std::memcmp(&x.standard_uncertainty, &y.standard_uncertainty, sizeof(double)), 0) << j;
        EXPECT_EQ(a->outputs[j].quantity.symbol, b->outputs[j].quantity.symbol);
    }
}

class IncrementalMaking : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(IncrementalMaking, IsMakingAnew) {
    Editor editor(load_project(GetParam()).project, 20261122);
    MadeProject::Pointer made = MadeProject::make(editor.project());
    std::size_t compared = 0;
    for (int step = 0; step < 24; ++step) {
        SCOPED_TRACE(step);
        editor.edit();
        made = MadeProject::make(editor.project(), made);
        const auto fresh = MadeProject::make(editor.project());
        const Problems now = made->problems(), expected = fresh->problems();
        ASSERT_EQ(now.items().size(), expected.items().size());
        for (std::size_t i = 0; i < now.items().size(); ++i) {
            EXPECT_EQ(now.items()[i].path, expected.items()[i].path);
            EXPECT_EQ(now.items()[i].message.english(), expected.items()[i].message.english());
        }
        for (const AnalysisEntry& entry : editor.project().analyses) {
            SCOPED_TRACE(entry.id);
            EXPECT_EQ(made->assets_used_by(entry.id), fresh->assets_used_by(entry.id));
            const auto a = made->analysis(entry.id), b = fresh->analysis(entry.id);
            ASSERT_EQ(a != nullptr, b != nullptr);
            if (!a) continue;
            expect_same(*a, *b);
            ++compared;
        }
        if (HasFailure()) return;
    }
    EXPECT_GT(compared, 0u);
}

INSTANTIATE_TEST_SUITE_P(Projects, IncrementalMaking, testing::ValuesIn(shipped_projects()), test_name_of);

}  // namespace
}  // namespace covaria::incremental_making_test
