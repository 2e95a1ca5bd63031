// Project tree, problems, input quantities and their correlations.
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <set>

#include "core/kinds/registries.h"
#include "core/text/symbol.h"
#include "tests/core/made.h"
#include "tests/ui/qt_application.h"
#include "ui/document/correlated_pair.h"
#include "ui/document/project_edits.h"
#include "ui/document/quantity_edits.h"
#include "ui/models/category_icon.h"
#include "ui/models/input_correlation_model.h"
#include "ui/models/input_quantities_model.h"
#include "ui/models/problems_model.h"
#include "ui/models/project_tree_model.h"
#include "ui/models/roles.h"
#include "ui/models/setup_table_model.h"
#include "ui/theme/icons.h"
#include "ui/theme/strings.h"

namespace covaria::ui::project_models_test {
namespace {

constexpr auto fatal = QAbstractItemModelTester::FailureReportingMode::Fatal;

struct ProjectModelsTest : testing::Test {
    void add_analysis_entry(const std::string& id) {
        document.apply("Add", [&](Project& project) {
            project.analyses.push_back({id, "model", "Analysis " + id, {}, {}, {}, {}, {}, {}});
        });
    }
    Problems found;
    Document document{[this](const MadeProject&) { return found; }, nullptr};
    AnalysisRunner runner{document.maker(), RunBackend{}, Execution::inline_execution};
};

TEST_F(ProjectModelsTest, TheTreeFollowsAddingMovingAndRemoving) {
    ProjectTreeModel tree(document, runner);
    QAbstractItemModelTester tester(&tree, fatal);
    ASSERT_EQ(tree.rowCount(), ProjectTreeModel::category_count);
    const QModelIndex analyses = tree.index_of(ProjectTreeModel::analyses);
    QSignalSpy reset(&tree, &QAbstractItemModel::modelReset);
    for (const char* id : {"a", "b", "c"}) add_analysis_entry(id);
    ASSERT_EQ(tree.rowCount(analyses), 3);
    const QPersistentModelIndex kept = tree.index_of({SetupOwner::analysis, "c"});
    EXPECT_EQ(kept.data().toString(), "Analysis c");
    EXPECT_EQ(kept.data(path_role).toString(), "/analyses/2");
    move_entry(document, {SetupOwner::analysis, "c"}, 0);
    EXPECT_EQ(kept.row(), 0);
    remove(document, {SetupOwner::analysis, "b"});
    EXPECT_EQ(tree.rowCount(analyses), 2);
    document.undo_stack().undo();
    document.undo_stack().undo();
    EXPECT_EQ(kept.row(), 2);
    EXPECT_EQ(reset.count(), 0);
    EXPECT_EQ(tree.address(kept), (SetupAddress{SetupOwner::analysis, "c"}));
    EXPECT_TRUE(tree.address(analyses).id.empty());
}

// A category that is added has its place in the tree, a title and an icon, as the others have.
TEST_F(ProjectModelsTest, EveryKindOfAssetStandsUnderATitleAndHasAnIcon) {
    ProjectTreeModel tree(document, runner);
    std::set<QString> titles;
    for (int row = ProjectTreeModel::artefacts; row < ProjectTreeModel::category_count; ++row)
        titles.insert(tree.index(row, 0).data().toString());
    EXPECT_EQ(titles.size(), std::size_t(ProjectTreeModel::category_count - 1));
    EXPECT_FALSE(titles.contains(QString()));
    EXPECT_EQ(tree.index_of(ProjectTreeModel::analyses).data().toString(), "Analyses");
    for (const AssetDescriptor& kind : asset_registry()) {
        const std::string id = add_asset(document, kind.kind);
        const QModelIndex entry = tree.index_of({SetupOwner::asset, id});
        ASSERT_TRUE(entry.isValid()) << kind.kind;
        EXPECT_NE(entry.parent().row(), int(ProjectTreeModel::analyses)) << kind.kind;
        EXPECT_FALSE(icon(category_icon(kind.category)).isNull()) << kind.kind;
    }
}

// A view that is left turns typed text into an edit: here while the tree follows another one.
TEST_F(ProjectModelsTest, TheTreeFollowsAChangeThatComesWhileItFollowsOne) {
    ProjectTreeModel tree(document, runner);
    QAbstractItemModelTester tester(&tree, fatal);
    for (const char* id : {"a", "b", "c"}) add_analysis_entry(id);
    const auto leave = [&] {
        if (document.project().find_analysis("a")) remove(document, {SetupOwner::analysis, "a"});
    };
    QObject::connect(&tree, &QAbstractItemModel::rowsAboutToBeRemoved, &tree, leave);
    document.apply("Remove", [&](Project& project) {
        project.analyses.erase(project.analyses.begin() + 1, project.analyses.end());
    });
    EXPECT_TRUE(document.project().analyses.empty());
    EXPECT_EQ(tree.rowCount(tree.index_of(ProjectTreeModel::analyses)), 0);
}

TEST_F(ProjectModelsTest, AssetsStandInTheirCategory) {
    ProjectTreeModel tree(document, runner);
    QAbstractItemModelTester tester(&tree, fatal);
    ASSERT_FALSE(asset_registry().empty());
    for (const AssetDescriptor& kind : asset_registry()) {
        const std::string id = add_asset(document, kind.kind);
        const QModelIndex index = tree.index_of({SetupOwner::asset, id});
        ASSERT_TRUE(index.isValid());
        EXPECT_EQ(index.parent().row(), ProjectTreeModel::artefacts + static_cast<int>(kind.category));
    }
}

TEST_F(ProjectModelsTest, RenamesInTheTree) {
    add_analysis_entry("a");
    ProjectTreeModel tree(document, runner);
    const QModelIndex index = tree.index_of({SetupOwner::analysis, "a"});
    EXPECT_TRUE(tree.setData(index, "Pose 7"));
    EXPECT_EQ(document.project().analyses[0].name, "Pose 7");
    EXPECT_FALSE(tree.setData(index, "  "));
    EXPECT_FALSE(tree.flags(tree.index_of(ProjectTreeModel::artefacts)) & Qt::ItemIsEditable);
}

TEST_F(ProjectModelsTest, TheFirstRowIsTheProject) {
    ProjectTreeModel tree(document, runner);
    QAbstractItemModelTester tester(&tree, fatal);
    const QModelIndex project = tree.index(0, 0);
    EXPECT_EQ(tree.address(project), project_address);
    EXPECT_EQ(tree.index_of(project_address), project);
    EXPECT_EQ(tree.rowCount(project), 0);
    EXPECT_EQ(project.data().toString(), "Untitled project");
    EXPECT_EQ(project.data(Qt::EditRole).toString(), "");
    QSignalSpy changed(&tree, &QAbstractItemModel::dataChanged);
    EXPECT_TRUE(tree.setData(project, "Gauge blocks"));
    EXPECT_EQ(document.project().title, "Gauge blocks");
    EXPECT_EQ(project.data().toString(), "Gauge blocks");
    EXPECT_GT(changed.count(), 0);
    document.undo_stack().undo();
    EXPECT_EQ(document.project().title, "");
}

TEST_F(ProjectModelsTest, TheProjectShowsItsOwnProblemsOnly) {
    add_analysis_entry("a");
    ProjectTreeModel tree(document, runner);
    const QModelIndex project = tree.index(0, 0);
    found.error("/analyses/0/setup/x", "of the analysis");
    document.check_now();
    EXPECT_EQ(project.data(problem_role).toString(), "");
    found.warning("/certificate/dates/issued", "issued too early");
    document.apply("Edit", [](Project& changed) { changed.notes = "n"; });
    document.check_now();
    EXPECT_EQ(project.data(problem_role).toString(), "issued too early");
    EXPECT_EQ(project.data(worst_role).toInt(), int(Severity::warning));
    EXPECT_EQ(ProblemsModel::place_words(document.project(), "/certificate/dates/issued"),
              "Project: certificate, Date of issue");
    EXPECT_EQ(address_of_path(document.project(), "/certificate/dates/issued"), project_address);
    EXPECT_TRUE(address_of_path(document.project(), "/analyses/7").id.empty());
    EXPECT_FALSE(exists(document.project(), address_of_path(document.project(), "/analyses/7")));
}

TEST_F(ProjectModelsTest, AProblemOfACertificateNamesIt) {
    AnalysisEntry budget{"budget", "measurement-equation", "Budget", {}, {}, {}, {}, {}, {}};
    budget.certificates = {{.number = "2026-114"}, {}};
    Project project;
    project.analyses = {budget};
    const auto words = [&](const char* path) { return ProblemsModel::place_words(project, path); };
    EXPECT_EQ(words("/analyses/0/certificates/0/issued"), "Budget: certificate 2026-114");
    EXPECT_EQ(words("/analyses/0/certificates/1/number"), "Budget: certificate 2");
    EXPECT_EQ(words("/analyses/0/measured"), "Budget: date of the measurement");
}

TEST_F(ProjectModelsTest, TheTreeShowsStatesAndProblems) {
    add_analysis_entry("a");
    ProjectTreeModel tree(document, runner);
    const QModelIndex index = tree.index_of({SetupOwner::analysis, "a"});
    EXPECT_EQ(index.siblingAtColumn(ProjectTreeModel::state_column).data().toString(), "out of date");
    found.error("/analyses/0/setup/x", "too small");
    document.check_now();
    EXPECT_EQ(index.data(problem_role).toString(), "too small");
}

/// The cell, and whose it is.
TEST_F(ProjectModelsTest, WhatIsMissingIsNamed) {
    AnalysisEntry budget{"budget", "measurement-equation", "Budget", {}, {}, {}, {}, {}, {}};
    budget.setup.values["equations"] = std::string("l = l_S + d");
    Project project;
    project.analyses = {budget};
    Document own;
    own.replace(project);
    SetupTableModel table(own, {SetupOwner::analysis, "budget"}, "quantities");
    const auto type = [&](int row, const char* column, const char* text) {
        table.setData(table.index(row, int(SetupSchema::column(*table.field(), column))), QString(text));
    };
    table.insertRows(0, 2);
    type(0, "symbol", "l_S");
    type(0, "value", "50 mm");
    type(1, "symbol", "d");
    own.check_now();
    EXPECT_EQ(ProblemsModel::missing_words(own, "budget"), "Quantities, row 2 (d), value");
    type(1, "value", "2 nm");
    own.check_now();
    EXPECT_EQ(ProblemsModel::missing_words(own, "budget"), QString());
}

TEST_F(ProjectModelsTest, PlacesInListsAreNamedByWhatTheyHold) {
    AnalysisEntry entry{"a", "measurement-equation", "Budget", {}, {}, {}, {}, {}, {}};
    entry.links = {{"l_S", {"b", "", "y"}}};
    entry.studies.push_back({.id = "s", .name = "Where is the limit?"});
    entry.requirements.push_back({"", "y"});
    Project project;
    project.analyses = {entry};
    const auto words = [&](const char* part) {
        return ProblemsModel::place_words(project, std::string("/analyses/0/") + part).toStdString();
    };
    EXPECT_EQ(words("links/0/analysis"), "Budget: link of l_S");
    EXPECT_EQ(words("studies/0/axes/1/target"), "Budget: study “Where is the limit?”");
    EXPECT_EQ(words("requirements/0/upperLimit"), "Budget: requirement on y");
}

TEST_F(ProjectModelsTest, EntriesThatShareANameAreCounted) {
    Project project;
    for (const char* id : {"a", "b", "c"})
        project.analyses.push_back({id, "measurement-equation", "Length", {}, {}, {}, {}, {}, {}});
    project.analyses[1].name = "Width";
    const auto words = [&](const char* place) {
        return ProblemsModel::place_words(project, place).toStdString();
    };
    EXPECT_EQ(words("/analyses/0"), "Length (1)");
    EXPECT_EQ(words("/analyses/1"), "Width");
    EXPECT_EQ(words("/analyses/2"), "Length (2)");
}

// A problem of a whole row marks one cell, where the row begins; a problem of a cell marks that cell.
TEST_F(ProjectModelsTest, OneProblemIsOneCell) {
    AnalysisEntry budget{"budget", "measurement-equation", "Budget", {}, {}, {}, {}, {}, {}};
    Project project;
    project.analyses = {budget};
    Problems problems;
    Document own([&problems](const MadeProject&) { return problems; }, nullptr);
    own.replace(project);
    SetupTableModel table(own, {SetupOwner::analysis, "budget"}, "quantities");
    table.insertRows(0, 3);
    for (const char* place :
         {"/analyses/0/setup/quantities/rows/1", "/analyses/0/setup/quantities/rows/1/2"}) {
        problems = {};
        problems.error(place, "wrong");
        own.check_now();
        int marked = 0;
        for (int row = 0; row < table.rowCount(); ++row)
            for (int column = 0; column < table.columnCount(); ++column)
                if (table.index(row, column).data(Qt::BackgroundRole).isValid()) {
                    ++marked;
                    EXPECT_EQ(row, 1);
                }
        EXPECT_EQ(marked, 1) << place;
    }
}

TEST_F(ProjectModelsTest, ProblemsComeWithTheirPlaceErrorsFirst) {
    add_analysis_entry("a");
    ProblemsModel model(document);
    QAbstractItemModelTester tester(&model, fatal);
    found.warning("/title", "no title");
    found.error("/analyses/0/options/trials", "too few trials");
    document.check_now();
    ASSERT_EQ(model.rowCount(), 2);
    EXPECT_EQ(model.errors(), 1);
    EXPECT_EQ(model.index(0, ProblemsModel::message_column).data().toString(), "too few trials");
    EXPECT_EQ(model.index(0, ProblemsModel::place_column).data().toString(),
              "Analysis a: evaluation, trials");
    EXPECT_EQ(ProblemsModel::place_words(document.project(), "/analyses/0/options/coverageProbability"),
              "Analysis a: evaluation, coverage probability");
    EXPECT_EQ(model.index(0, 0).data(path_role).toString(), "/analyses/0/options/trials");
    Problems of_file;
    of_file.add({Severity::error, "/format", "not a project", "x.covaria", 3});
    model.show(of_file);
    EXPECT_EQ(model.index(0, ProblemsModel::place_column).data().toString(), "x.covaria, line 3: /format");
}

/// Three quantities with a component each; the last one of another analysis, where one is named.
InputSet sample_inputs(const std::string& last_of = {}) {
    InputSet inputs;
    for (const char* symbol : {"b_1x", "b_1y", "b_1z"}) {
        UncertaintyComponent component;
        component.id = std::string(symbol) + ".calibration";
        component.name = "calibration";
        component.unit = Unit::of("um");
        component.distribution = Distribution::normal(2e-6);
        InputQuantity quantity;
        quantity.symbol = symbol;
        quantity.name = "base point 1";
        quantity.unit = Unit::of("mm");
        quantity.offset = 0.1;
        inputs.add(quantity, {component});
    }
    inputs.quantities.back().analysis = last_of;
    return inputs;
}

std::shared_ptr<const PreparedAnalysis> prepared() {
    return analysis_with("a", sample_inputs());
}

TEST_F(ProjectModelsTest, InputQuantitiesAreEditedAndReset) {
    add_analysis_entry("a");
    const Project before = document.project();
    InputQuantitiesModel model(document);
    QAbstractItemModelTester tester(&model, fatal);
    model.set_analysis(prepared());
    ASSERT_EQ(model.rowCount(), 3);
    const QModelIndex estimate = model.index(0, InputQuantitiesModel::estimate_column);
    EXPECT_EQ(estimate.data().toString(), "100");
    EXPECT_EQ(model.index(0, InputQuantitiesModel::uncertainty_column).data().toString(), "0.0020");
    EXPECT_TRUE(model.setData(estimate, "12 cm"));
    EXPECT_EQ(estimate.data().toString(), "120") << "shown at once, in the unit of the column";
    EXPECT_EQ(document.project().analyses[0].inputs.at(0).estimate->unit, Unit::of("cm"));
    EXPECT_TRUE(model.is_edited(0));
    EXPECT_FALSE(model.setData(estimate, "12 kg"));
    const QModelIndex held = model.index(1, InputQuantitiesModel::held_column);
    EXPECT_TRUE(model.setData(held, Qt::Checked, Qt::CheckStateRole));
    EXPECT_EQ(held.data(Qt::CheckStateRole).toInt(), Qt::Checked);
    EXPECT_TRUE(document.project().analyses[0].inputs.at(1).held);
    EXPECT_TRUE(model.setData(held, Qt::Unchecked, Qt::CheckStateRole));
    model.reset_edits(0);
    EXPECT_EQ(document.project(), before) << "edits that say nothing are removed";
    EXPECT_EQ(model.row_of("b_1z"), 2);
    EXPECT_EQ(model.row_of("b_2x"), -1);
}

TEST_F(ProjectModelsTest, LinkedQuantitiesAreShownWhereTheyComeFrom) {
    add_analysis_entry("a");
    // The last quantity is one of upstream: it is not edited here.
    auto chain = std::make_shared<PreparedAnalysis>(*analysis_with("a", sample_inputs("gauge")));
    LinkedInput linked;
    linked.symbol = "L_S";
    linked.name = "length";
    linked.unit = Unit::of("mm");
    linked.analysis = "gauge";
    linked.analysis_name = "End gauge";
    linked.output.symbol = "l";
    linked.estimate = 0.05;
    linked.standard_uncertainty = 25e-9;
    chain->linked = {linked};
    InputQuantitiesModel model(document);
    QAbstractItemModelTester tester(&model, fatal);
    model.set_analysis(chain);
    ASSERT_EQ(model.rowCount(), 3);
    EXPECT_EQ(model.row_of("b_1z"), -1);
    EXPECT_EQ(model.row_of("L_S"), 2);
    EXPECT_TRUE(model.is_linked(2));
    const QModelIndex estimate = model.index(2, InputQuantitiesModel::estimate_column);
    EXPECT_EQ(estimate.data().toString(), "50");
    EXPECT_FALSE(model.flags(estimate) & Qt::ItemIsEditable);
    EXPECT_FALSE(model.setData(estimate, "12 mm"));
    EXPECT_EQ(model.index(2, InputQuantitiesModel::uncertainty_column).data().toString(), "2.5×10⁻⁵");
    EXPECT_EQ(model.index(2, InputQuantitiesModel::components_column).data().toString(), "from End gauge: l");
}

TEST_F(ProjectModelsTest, ALinkIsOneUndoableEdit) {
    add_analysis_entry("a");
    change_input(document, "a", "b_1x", "edit", [](InputEdit& edit) { edit.held = true; });
    const Project before = document.project();
    const InputLink link{"b_1x", {"gauge", "", "l"}, false};
    set_link(document, "a", "b_1x", link);
    EXPECT_EQ(document.project().analyses[0].links, std::vector<InputLink>{link});
    EXPECT_TRUE(document.project().analyses[0].inputs.empty()) << "edits have no effect beside a link";
    EXPECT_EQ(find_link(document.project(), "a", "b_1x"), link);
    document.undo_stack().undo();
    EXPECT_EQ(document.project(), before);
    document.undo_stack().redo();
    set_link(document, "a", "b_1x", std::nullopt);
    EXPECT_TRUE(document.project().analyses[0].links.empty());
}

TEST_F(ProjectModelsTest, CorrelationsAreCheckedWhileTheyAreTyped) {
    add_analysis_entry("a");
    InputCorrelationModel model(document);
    QAbstractItemModelTester tester(&model, fatal);
    model.set_analysis(prepared());
    EXPECT_EQ(model.rowCount(), 0);
    for (const std::string& id : model.other_components()) model.add_component(id);
    ASSERT_EQ(model.rowCount(), 3);
    EXPECT_TRUE(model.setData(model.index(0, 1), "0.9"));
    EXPECT_EQ(model.index(1, 0).data().toString(), "0.9") << "symmetric";
    EXPECT_TRUE(model.setData(model.index(1, 2), "0.9"));
    EXPECT_FALSE(model.complaint().isEmpty()) << "0.9, 0.9 and 0 together are impossible";
    QSignalSpy changed(&model, &InputCorrelationModel::complaint_changed);
    EXPECT_TRUE(model.setData(model.index(2, 0), "0.8"));
    EXPECT_TRUE(model.complaint().isEmpty()) << model.complaint().toStdString();
    EXPECT_EQ(changed.count(), 1);
    EXPECT_TRUE(model.setData(model.index(0, 1), "1.5"));
    EXPECT_EQ(document.unread().all().size(), 1u)
        << "a text that is kept and holds the run, and no correlation";
    const Problem said = document.problems().items().front();
    const std::string first = to_std(model.headerData(0, Qt::Horizontal).toString()),
                      second = to_std(model.headerData(1, Qt::Horizontal).toString());
    EXPECT_NE(said.message.english().find("“1.5”"), std::string::npos) << said.message.english();
    const QString place = ProblemsModel::place_words(document.project(), said.path);
    for (const std::string& id : {first, second})
        EXPECT_TRUE(place.contains(to_qt(symbol_to_unicode(id)))) << "which pair: " << to_std(place);
    const auto pair =
        pair_in(document.project().analyses[0], said.path.substr(std::string("/analyses/0").size()));
    ASSERT_TRUE(pair);
    EXPECT_EQ(model.index_of(pair->first, pair->second).data().toString(), "1.5") << "and where it is";
    EXPECT_EQ(pair_in(document.project().analyses[0], "/correlations/1/coefficient"),
              CorrelatedPair(document.project().analyses[0].correlations[1].first,
                             document.project().analyses[0].correlations[1].second));
    EXPECT_EQ(document.project().analyses[0].correlations.size(), 3u);
    EXPECT_TRUE(model.setData(model.index(0, 1), "0.9"));
    EXPECT_TRUE(document.unread().all().empty());
    EXPECT_FALSE(model.setData(model.index(1, 1), "0.5"));
    EXPECT_EQ(document.project().analyses[0].correlations.size(), 3u);
    model.remove_component(0);
    EXPECT_EQ(document.project().analyses[0].correlations.size(), 1u);
}

}  // namespace
}  // namespace covaria::ui::project_models_test
