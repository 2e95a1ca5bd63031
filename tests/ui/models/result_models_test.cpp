// Tables of results, budget and correlation from a result made by hand.
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSortFilterProxyModel>
#include <algorithm>
#include <set>

#include "core/result_files/csv_writer.h"
#include "core/views/result_columns.h"
#include "tests/ui/qt_application.h"
#include "ui/models/budget_table_model.h"
#include "ui/models/cell_blocks.h"
#include "ui/models/correlation_table_model.h"
#include "ui/models/result_table_model.h"
#include "ui/models/roles.h"
#include "ui/theme/label_text.h"

namespace covaria::ui::result_models_test {
namespace {

OutputResult output(const char* symbol, const char* unit, const char* group, double estimate, double u) {
    OutputResult result;
    result.quantity = {symbol, std::string(symbol) + " of it", Unit::of(unit), group};
    result.first_order = {estimate, u, 9.4, 2.26, 2.26 * u};
    result.estimate = estimate;
    result.standard_uncertainty = u;
    result.coverage_factor = 2.26;
    result.expanded_uncertainty = 2.26 * u;
    return result;
}

std::shared_ptr<UncertaintyResult> sample_result() {
    auto result = std::make_shared<UncertaintyResult>();
    result->outputs = {output("x", "mm", "pose 1", 1.0234567, 4.4e-6),
                       output("alpha", "deg", "pose 1", 0.5, 1e-5),
                       output("x", "mm", "pose 2", -0.25, 1.5e-5)};
    MonteCarloOutput monte_carlo;
    monte_carlo.symmetric = {1.0234480, 1.0234654};
    monte_carlo.shortest = {1.0234470, 1.0234640};
    result->outputs[0].monte_carlo = monte_carlo;
    result->outputs[0].first_order.validation = FirstOrderOutput::Validation{5e-7, 0.0, 0.0, true};
    Eigen::MatrixXd covariance = Eigen::Vector3d(1.0, 4.0, 9.0).asDiagonal();
    covariance(0, 1) = covariance(1, 0) = -1.0;
    result->covariance = covariance;
    BudgetComponent scale;
    scale.id = "a.scale";
    scale.origin = "certificate";
    scale.unit = Unit::of("um");
    scale.type = EvaluationType::type_b;
    scale.standard_uncertainty = 2e-6;
    scale.quantities = {"L_1"};
    BudgetComponent noise = scale;
    noise.id = "a.noise";
    noise.type = EvaluationType::type_a;
    noise.standard_uncertainty = 1e-6;
    result->budget.components = {scale, noise};
    result->budget.rows = {{{0, 2.0, 4e-6, 0.8}, {1, -1.0, 1e-6, 0.2}}, {}, {}};
    return result;
}

int column(const QAbstractItemModel& model, const QString& head) {
    for (int i = 0; i < model.columnCount(); ++i)
        if (model.headerData(i, Qt::Horizontal).toString() == head) return i;
    ADD_FAILURE() << "no column " << head.toStdString();
    return 0;
}

QString cell(const QAbstractItemModel& model, int row, const QString& head) {
    return model.index(row, column(model, head)).data().toString();
}

TEST(ResultTableModel, RoundsByTheUncertaintyInTheUnitOfTheQuantity) {
    ResultTableModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    model.set_result(sample_result(), true);
    ASSERT_EQ(model.rowCount(), 3);
    EXPECT_EQ(cell(model, 0, "Estimate"), "1023.4567");
    EXPECT_EQ(cell(model, 0, "u"), "0.0044");
    EXPECT_EQ(cell(model, 0, "k"), "2.26");
    EXPECT_EQ(cell(model, 0, "U"), "0.0099");
    EXPECT_EQ(cell(model, 0, "Unit"), "mm");
    EXPECT_EQ(cell(model, 0, "95\u00a0% interval, low"), "1023.4480");
    EXPECT_EQ(cell(model, 1, "95\u00a0% interval, low"), "28.6466")
        << "0.5 rad - 2.26 u, by the law of propagation";
    EXPECT_EQ(cell(model, 0, "First order validated"), "yes");
    EXPECT_EQ(model.index(0, 0).data(group_role).toString(), "pose 1");
    model.set_interval(ResultTableModel::Interval::shortest);
    EXPECT_EQ(cell(model, 0, "95\u00a0% interval, low"), "1023.4470");
}

// y ± U would be another part of the distribution than the interval beside it.
TEST(ResultTableModel, OfASkewedResultUAndKStandBack) {
    auto result = std::make_shared<UncertaintyResult>(*sample_result());
    const double y = result->outputs[0].estimate, U = result->outputs[0].expanded_uncertainty;
    result->outputs[0].monte_carlo->symmetric = {y - 0.2 * U, y + 1.8 * U};
    ResultTableModel model;
    model.set_result(result, true);
    const auto pen = [&](int row, const char* head) {
        return model.index(row, column(model, QLatin1String(head))).data(Qt::ForegroundRole);
    };
    EXPECT_TRUE(pen(0, "U").isValid());
    EXPECT_TRUE(pen(0, "k").isValid());
    EXPECT_FALSE(pen(0, "u").isValid());
    EXPECT_FALSE(pen(1, "U").isValid()) << "symmetric";
    const auto tip = model.index(0, column(model, QStringLiteral("U"))).data(Qt::ToolTipRole).toString();
    EXPECT_TRUE(tip.contains(QLatin1String("not symmetric"))) << tip.toStdString();
}

TEST(ResultTableModel, UnitsDigitsAndGroupCanBeChosen) {
    ResultTableModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    model.set_result(sample_result(), true);
    DisplayUnits units;
    units.choose(Unit::of("um"));
    model.set_units(units);
    EXPECT_EQ(cell(model, 0, "u"), "4.4");
    EXPECT_EQ(cell(model, 0, "Unit"), QString::fromUtf8("µm"));
    EXPECT_EQ(cell(model, 1, "Unit"), QString::fromUtf8("°")) << "another dimension keeps its unit";
    model.set_digits(1);
    EXPECT_EQ(cell(model, 0, "u"), "4");
    model.set_group("pose 2");
    ASSERT_EQ(model.rowCount(), 1);
    EXPECT_EQ(model.output_of(0), 2u);
    EXPECT_EQ(model.row_of(2), 0);
    EXPECT_EQ(model.row_of(0), -1);
    EXPECT_EQ(cell(model, 0, "Estimate").at(0), QChar(0x2212)) << "a true minus sign";
}

TEST(ResultTableModel, SortsByNumbersAndMarksWhatIsOutOfDate) {
    ResultTableModel model;
    model.set_result(sample_result(), true);
    QSortFilterProxyModel sorted;
    sorted.setSourceModel(&model);
    sorted.setSortRole(sort_role);
    sorted.sort(column(model, "Estimate"), Qt::AscendingOrder);
    EXPECT_EQ(cell(sorted, 0, "Group"), "pose 2");
    EXPECT_FALSE(model.index(0, 4).data(Qt::ForegroundRole).isValid());
    QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
    model.set_result(sample_result(), false);
    EXPECT_EQ(reset.count(), 0) << "the same shape keeps the selection";
    EXPECT_TRUE(model.index(0, 4).data(Qt::ForegroundRole).isValid());
    model.set_result(nullptr, true);
    EXPECT_EQ(model.rowCount(), 0);
}

TEST(BudgetTableModel, ShowsComponentsAndContributions) {
    BudgetTableModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    model.set_result(sample_result(), 0, true);
    ASSERT_EQ(model.rowCount(), 2);
    EXPECT_EQ(cell(model, 0, "u"), "2.0");
    EXPECT_EQ(cell(model, 0, "Unit"), QString::fromUtf8("µm"));
    EXPECT_EQ(cell(model, 0, "Type"), "B");
    EXPECT_EQ(cell(model, 1, "Type"), "A");
    EXPECT_EQ(cell(model, 0, "Share / %"), "80.0");
    EXPECT_EQ(cell(model, 0, QString::fromUtf8("|c|·u / mm")), "0.0040");
    EXPECT_EQ(cell(model, 0, "c"), QString::fromUtf8("0.002\u202f00\u00a0mm/µm"));
    EXPECT_EQ(cell(model, 0, "Origin"), "certificate");
    model.set_result(sample_result(), 7, true);
    EXPECT_EQ(model.rowCount(), 0);
}

TEST(BudgetTableModel, SaysWhatASobolIndexIsWorth) {
    auto result = std::make_shared<UncertaintyResult>(*sample_result());
    result->sobol.assign(result->outputs.size(), {{"a", {0}, 0.802, 0.799, 0.0041, 0.0037}});
    BudgetTableModel model;
    model.set_result(result, 0, true);
    const auto tip_of = [&model](const char* head) {
        for (int c = 0; c < model.columnCount(); ++c)
            if (model.headerData(c, Qt::Horizontal).toString() == QLatin1String(head))
                return model.index(0, c).data(Qt::ToolTipRole).toString();
        return QString();
    };
    EXPECT_EQ(cell(model, 0, "S / %"), "80.2");
    EXPECT_TRUE(tip_of("S / %").contains("0.41")) << tip_of("S / %").toStdString();
    EXPECT_TRUE(tip_of("S total / %").contains("0.37")) << tip_of("S total / %").toStdString();
}

TEST(CorrelationTableModel, ShowsTheMatrixOfAGroup) {
    CorrelationTableModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    model.set_result(sample_result(), "pose 1", true);
    ASSERT_EQ(model.rowCount(), 2);
    ASSERT_EQ(model.columnCount(), 2);
    EXPECT_EQ(model.index(0, 0).data().toString(), "1.000");
    EXPECT_EQ(model.index(0, 1).data().toString(), QString(QChar(0x2212)) + "0.500");
    EXPECT_EQ(model.headerData(1, Qt::Vertical).toString(), QString::fromUtf8("α"));
    model.set_result(sample_result(), "", true);
    EXPECT_EQ(model.rowCount(), 3);
    EXPECT_EQ(model.headerData(2, Qt::Horizontal).toString(), "x, pose 2");
    model.set_result(nullptr, "", true);
    EXPECT_EQ(model.rowCount(), 0);
}

TEST(ResultTableModel, SymbolsAreGivenAsText) {
    ResultTableModel model;
    model.set_result(sample_result(), true);
    EXPECT_EQ(model.index(1, column(model, "Symbol")).data(typeset_role).value<Text>(), symbol_text("alpha"));
    const int nu = column(model, QString::fromUtf8("ν_eff"));
    EXPECT_EQ(model.headerData(nu, Qt::Horizontal, typeset_role).value<Text>(), symbol_text("nu_eff"));
}

TEST(ResultTableModel, ItsFileIsThatOfTheRun) {
    const auto result = sample_result();
    ResultTableModel model;
    model.set_result(result, true);
    const std::vector<int> columns = {column(model, "Symbol"), column(model, "Unit"),
                                      column(model, "Estimate"), column(model, "U")};
    const std::string text = to_csv(model.file_table({2, 0}, columns));
    Table of_run = results_table(*result, {2, 0});
    std::erase_if(of_run.columns, [](const Column& column) {
        return !std::set<std::string>{"symbol", "unit", "estimate", "U"}.contains(column.key);
    });
    EXPECT_EQ(text, to_csv(of_run));
    EXPECT_TRUE(text.starts_with("symbol,unit,estimate,U\r\nx,mm,-250,")) << text;
    DisplayUnits units;
    units.choose(Unit::of("um"));
    model.set_units(units);
    EXPECT_NE(to_csv(model.file_table({2}, columns), units).find("x,um,-250000,"), std::string::npos);
}

TEST(Clipboard, NumbersAreThoseOfASpreadsheetInTheUsersLocale) {
    ResultTableModel model;
    const QString exact = QString::fromStdString(format_exact(1.0234567 * 1000.0));
    for (const QLocale& locale : {QLocale(QLocale::German), QLocale::c()}) {
        QLocale::setDefault(locale);
        model.set_result(sample_result(), true);
        model.set_digits(1);
        const QModelIndexList cells{model.index(0, column(model, "Unit")),
                                    model.index(0, column(model, "Estimate"))};
        EXPECT_EQ(block_text(cells), "mm\t" + QString(exact).replace('.', locale.decimalPoint()) + '\n')
            << "all digits, not those shown";
        EXPECT_EQ(cells[1].data().toString().contains(','), locale.language() == QLocale::German);
    }
    QLocale::setDefault(QLocale::c());
}

TEST(DisplayUnits, OffersUnitsOfTheSameDimension) {
    const std::vector<Unit> choices = DisplayUnits::choices(Unit::of("mm"));
    EXPECT_EQ(choices, DisplayUnits::choices(Unit::of("um"))) << "the order does not change by choosing";
    EXPECT_EQ(DisplayUnits::choices(Unit::of("km")).front(), Unit::of("km"));
    EXPECT_NE(std::find(choices.begin(), choices.end(), Unit::of("um")), choices.end());
    EXPECT_EQ(std::count(choices.begin(), choices.end(), Unit::of("mm")), 1);
    for (const Unit& unit : choices) EXPECT_EQ(unit.dimension(), Unit::of("m").dimension());
}

}  // namespace
}  // namespace covaria::ui::result_models_test
