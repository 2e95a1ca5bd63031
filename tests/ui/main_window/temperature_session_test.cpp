// Units through the real widgets: a temperature stays what it is, whatever is added to it and in whatever
// unit it is shown.
#include <QFile>
#include <QTableView>

#include "tests/ui/main_window/session_fixture.h"
#include "ui/forms/components_edit.h"
#include "ui/forms/distribution_edit.h"
#include "ui/models/roles.h"
#include "ui/pages/inputs_page.h"

namespace covaria::ui::temperature_session_test {
namespace {

constexpr const char* expansion = R"json({"format": "covaria", "schemaVersion": 1, "title": "", "assets": [],
 "analyses": [{"id": "a", "model": "measurement-equation", "setup": {
  "equations": ["y = alpha*(t - 20 [degC])"],
  "quantities": {
   "columns": ["symbol", "value", "unit", "statement", "a"],
   "rows": [["alpha", 1.15e-5, "1/K", "standard", 1e-6], ["t", 20.5, "degC", "standard", 0.1]]}},
  "options": {"method": "first-order"}}]})json";

class TemperatureSession : public Session {
protected:
    void open_expansion() {
        const QString path = folder_.filePath(QStringLiteral("expansion.covaria"));
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(expansion);
        file.close();
        open(path);
        select(SetupOwner::analysis, "a");
        ASSERT_TRUE(wait_for([this] { return status().prepared != nullptr; }));
        show_group(QStringLiteral("Inputs"));
        page_ = window_->properties().findChild<InputsPage*>();
        ASSERT_NE(page_, nullptr);
        auto* table = page_->findChild<QTableView*>();
        for (int row = 0; row < table->model()->rowCount(); ++row)
            if (table->model()->index(row, 0).data(id_role).toString() == QStringLiteral("t"))
                table->selectRow(row);
    }
    double estimate() {
        wait_until_idle();
        const InputSet& inputs = status().prepared->inputs;
        return estimate_of(inputs, inputs.find("t"));
    }
    double uncertainty() {
        const InputSet& inputs = status().prepared->inputs;
        return standard_uncertainty_of(inputs, inputs.find("t"));
    }
    InputsPage* page_ = nullptr;
};

TEST_F(TemperatureSession, AnAddedComponentAndEveryUnitLeaveTheEstimate) {
    open_expansion();
    EXPECT_NEAR(estimate(), 293.65, 1e-10);
    auto* components = page_->findChild<ComponentsEdit*>();
    ASSERT_NE(components, nullptr);
    for (QPushButton* button : components->findChildren<QPushButton*>())
        if (button->text() == QStringLiteral("Add")) button->click();
    ASSERT_EQ(window_->document().project().analyses[0].inputs.size(), 1u);
    ASSERT_EQ(window_->document().project().analyses[0].inputs[0].components->size(), 2u);
    EXPECT_NEAR(estimate(), 293.65, 1e-10) << "a component was added";
    EXPECT_NEAR(uncertainty(), 0.1, 1e-12);

    auto* unit = components->findChild<QComboBox*>(QStringLiteral("unit"));
    ASSERT_NE(unit, nullptr);
    EXPECT_EQ(unit->findData(QStringLiteral("degC")), -1) << "deviations are in K";
    for (const char* name : {"mK", "K"}) {
        choose_in(*unit, to_qt(Unit::of(name).display()));
        EXPECT_NEAR(estimate(), 293.65, 1e-10) << name;
    }
    auto* deviation = components->findChild<QLineEdit*>(QStringLiteral("standard_deviation"));
    ASSERT_NE(deviation, nullptr);
    deviation->setFocus();
    deviation->selectAll();
    type_keys(QStringLiteral("0.2 degC"));
    QTest::keyClick(deviation, Qt::Key_Return);
    EXPECT_NEAR(estimate(), 293.65, 1e-10) << "a deviation typed in degC";
    EXPECT_NEAR(uncertainty(), std::hypot(0.1, 0.2), 1e-12);
}

constexpr const char* pt100 = R"json({"format": "covaria", "schemaVersion": 1, "title": "", "assets": [],
 "analyses": [{"id": "a", "model": "measurement-equation", "setup": {
  "equations": ["R = R0*(1 + A*t + B*t^2)"],
  "quantities": {
   "columns": ["symbol", "value", "unit", "statement", "a", "stated_unit"],
   "rows": [["R0", 100, "ohm", "standard", 0.01, null], ["A", 0.0039083, "1/K", "constant", null, null],
    ["B", -5.775e-7, "1/K^2", "constant", null, null], ["t", 20, "degC", "standard", 0.1, "K"]]}},
  "options": {"method": "first-order"}}]})json";

// A temperature that is taken for a difference: the ways out stand beside the problem, a click takes one.
TEST_F(TemperatureSession, AClickOnAWayOutMendsTheProblem) {
    const QString path = folder_.filePath(QStringLiteral("pt100.covaria"));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(pt100);
    file.close();
    open(path);
    select(SetupOwner::analysis, "a");
    ASSERT_EQ(problems().size(), 3);
    auto* pane = window_->findChild<ProblemsPane*>();
    ASSERT_NE(pane, nullptr);
    pane->window()->findChild<QWidget*>(QStringLiteral("problems"))->raise();
    QStringList offered;
    for (int column = ProblemsModel::remedy_column; column < ProblemsModel::column_count; ++column) {
        EXPECT_FALSE(pane->isColumnHidden(column)) << column;
        offered << pane->model()->index(0, column).data().toString();
    }
    EXPECT_EQ(offered, QStringList({QStringLiteral("a difference: t in K"),
                                    QStringLiteral("its reading in degC: t - 0 [degC]"),
                                    QStringLiteral("a thermodynamic temperature: t in K")}));
    for (int way = 0; way < 2; ++way) {
        const QModelIndex link = pane->model()->index(0, ProblemsModel::remedy_column + way);
        pane->scrollTo(link);
        QTest::mouseClick(pane->viewport(), Qt::LeftButton, {}, pane->visualRect(link).center());
        EXPECT_TRUE(problems().isEmpty()) << problems().join(QLatin1Char('\n')).toStdString();
        EXPECT_TRUE(pane->isColumnHidden(ProblemsModel::remedy_column));
        ASSERT_TRUE(wait_for([this] { return status().prepared != nullptr; }));
        EXPECT_NEAR(status().prepared->propagated->propagation()->law.estimate(0), 107.7935, 1e-9) << way;
        window_->document().undo();
        ASSERT_EQ(problems().size(), 3) << "one step takes the way back";
    }
}

}  // namespace
}  // namespace covaria::ui::temperature_session_test
