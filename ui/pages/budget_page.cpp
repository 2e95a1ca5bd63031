#include "ui/pages/budget_page.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <map>

#include "core/text/numbers.h"
#include "core/text/symbol.h"
#include "core/views/result_statement.h"
#include "ui/forms/budget_foot.h"
#include "ui/forms/budget_sheet_view.h"
#include "ui/forms/complaint.h"
#include "ui/forms/row_tools.h"
#include "ui/models/roles.h"
#include "ui/theme/document_language.h"
#include "ui/theme/follow_font.h"
#include "ui/theme/strings.h"

namespace covaria::ui {

namespace {

constexpr std::size_t most_lines = 6;  // results named in a remark

const FieldSpec* stating_table(const Project& project, const SetupAddress& address) {
    const SetupSchema* schema = find_schema(project, address);
    return schema ? schema->find(&FieldSpec::states_quantities) : nullptr;
}

/// Three decimals at the most.
std::string shown_coefficient(double r) {
    const std::string typed = format_typed(r), rounded = format_decimals(r, 3);
    return typed.size() <= rounded.size() ? typed : rounded;
}

}  // namespace

BudgetPage::BudgetPage(Document& document, AnalysisRunner& runner, Selection& selection, QWidget* parent)
    : QWidget(parent),
      document_(document),
      runner_(runner),
      selection_(selection),
      tools_(new QWidget(this)) {
    new QHBoxLayout(tools_);
    tools_->layout()->setContentsMargins(0, 0, 0, 0);
    pair_ = new PairCorrelation(document, this);
    column_ = new QVBoxLayout(this);
    column_->setContentsMargins(0, 4, 0, 8);  // the table has the whole stage
    column_->setSpacing(6);
    remark_ = new QLabel(this);
    remark_->setTextFormat(Qt::RichText);
    remark_->setWordWrap(true);
    auto* below = new QHBoxLayout;
    below->setContentsMargins(16, 0, 16, 0);
    below->addWidget(remark_, 1, Qt::AlignTop);
    below->addWidget(pair_, 0, Qt::AlignTop);
    column_->addLayout(below);
    column_->addStretch(1);
    connect(&selection_, &Selection::analysis_changed, this, &BudgetPage::show_analysis);
    connect(&selection_, &Selection::output_changed, this, &BudgetPage::take_result);
    const auto take_if_shown = [this](const QString& id) {
        if (id == analysis_) take_result();
    };
    connect(&runner_, &AnalysisRunner::result_changed, this, take_if_shown);
    connect(&runner_, &AnalysisRunner::state_changed, this, take_if_shown);
    connect(&document_, &Document::project_changed, this, [this] {
        if (model_ && !document_.project().find_analysis(to_std(analysis_))) start_over();
    });
    hide();
}

void BudgetPage::start_over() {
    analysis_.clear();
    clear();
    show_analysis();
}

void BudgetPage::clear() {
    pair_->follow(nullptr, nullptr);
    qDeleteAll(tools_->findChildren<RowTools*>());
    delete std::exchange(foot_, nullptr);
    delete std::exchange(view_, nullptr);
    model_.reset();
}

void BudgetPage::show_analysis() {
    if (model_ && selection_.analysis() == analysis_) return;
    analysis_ = selection_.analysis();
    clear();
    const SetupAddress address{SetupOwner::analysis, to_std(analysis_)};
    const FieldSpec* field = stating_table(document_.project(), address);
    setVisible(field != nullptr);
    if (!field) return;
    model_ = std::make_unique<BudgetSheetModel>(document_, address, *field);
    model_->set_units(units_);
    model_->set_digits(digits_);
    view_ = new BudgetSheetView(*model_, this);
    view_->setObjectName(QStringLiteral("budget"));
    view_->setAccessibleName(tr("Budget"));
    column_->insertWidget(0, view_, 100);
    tools_->layout()->addWidget(new RowTools(*view_, *view_));
    foot_ = new BudgetFoot(result_row_, *view_, this);
    foot_->setObjectName(QStringLiteral("budget_result"));
    foot_->setAccessibleName(tr("Result of the budget"));
    column_->insertWidget(1, foot_);
    pair_->follow(model_.get(), view_);
    connect(view_, &BudgetSheetView::quantity_asked, this, &BudgetPage::ask_for_quantity);
    auto* correlate = new QAction(tr("Correlation of Two Rows"), view_);
    correlate->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_R));
    correlate->setShortcutContext(Qt::WidgetShortcut);
    view_->addAction(correlate);
    connect(correlate, &QAction::triggered, pair_, &PairCorrelation::ask);
    setFocusProxy(view_);
    setTabOrder(view_, &correlation());
    take_result();
}

/// Sets the tab order from `before` on anew: a widget moved in it leaves its old successors behind.
void BudgetPage::follow_in_tab_order(QWidget& before) {
    if (!view_) return;
    setTabOrder(&before, view_);
    setTabOrder(view_, &correlation());
}

void BudgetPage::ask_for_quantity(int row) {
    const std::string symbol = model_->symbol_of(row);
    if (symbol.empty()) return;
    const std::string entry = entry_path(document_.project(), {SetupOwner::analysis, to_std(analysis_)});
    emit quantity_asked(to_qt(entry + "/inputs/" + symbol));
}

void BudgetPage::set_units(const DisplayUnits& units) {
    units_ = units;
    if (model_) model_->set_units(units_);
    take_result();
}

void BudgetPage::set_digits(int digits) {
    digits_ = digits;
    if (model_) model_->set_digits(digits_);
    take_result();
}

void BudgetPage::take_result() {
    if (!model_) return;
    const AnalysisStatus& status = runner_.status(analysis_);
    const auto output = static_cast<std::size_t>(std::max(0, selection_.output()));
    model_->set_result(status.result, output, status.is_of_present());
    result_row_.set_result(status.result, output, status.is_of_present(), units_, digits_);
    pair_->set_analysis(status.prepared);
    if (!status.result) return remark_->clear();
    const QString correlated = status.prepared ? correlation_words(*status.prepared) : QString();
    const QString first_order = first_order_words(*status.result);
    QString words = correlated;
    if (!words.isEmpty() && !first_order.isEmpty()) words += QStringLiteral("<br>");
    words += first_order;
    // A label breaks a number between its groups, but at no such space.
    words.replace(QChar(0x202f), QChar(QChar::Nbsp));
    remark_->setText(words.replace(QStringLiteral(" = "), QStringLiteral("\u00a0=\u00a0")));
}

QString BudgetPage::correlation_words(const PreparedAnalysis& analysis) const {
    std::map<std::string, QString> symbols;  // by id of the component
    for (int row = 0; row < model_->rowCount(); ++row)
        if (const std::string id = model_->component_of(row); !id.empty())
            symbols[id] = to_qt(to_html(symbol_text(model_->symbol_of(row))));
    QStringList words;
    const InputSet& inputs = analysis.inputs;
    for (const ComponentCorrelation& c : inputs.correlations) {
        const auto a = symbols.find(inputs.components[c.first].id),
                   b = symbols.find(inputs.components[c.second].id);
        if (a == symbols.end() || b == symbols.end() || c.coefficient == 0.0) continue;
        if (static_cast<std::size_t>(words.size()) == most_lines) {
            words << QStringLiteral("…");
            break;
        }
        words << QStringLiteral("<i>r</i>(%1,\u00a0%2)\u00a0=\u00a0%3")
                     .arg(a->second, b->second,
                          to_qt(typeset_number(shown_coefficient(c.coefficient),
                                               language_of_window().numbers())));
    }
    return words.join(QStringLiteral("; "));
}

/// Results for which the columns of the law of propagation are about another u: "63 % (Y₁)".
QString BudgetPage::first_order_words(const UncertaintyResult& result) const {
    QStringList parts;
    for (const OutputResult& output : result.outputs) {
        const auto part = part_of_first_order(output);
        if (output.quantity.role != OutputRole::measurand || !part) continue;
        if (static_cast<std::size_t>(parts.size()) == most_lines) {
            parts << QStringLiteral("…");
            break;
        }
        parts << to_qt(percent_text(*part, language_of_window().numbers()) + " (" +
                       to_html(symbol_text(output.quantity.symbol)) + ")");
    }
    if (parts.isEmpty()) return {};
    return tr("c and share by the law of propagation, whose u is %1 of that by Monte Carlo")
        .toHtmlEscaped()
        .arg(parts.join(language_of_window().numbers().decimal == "," ? QStringLiteral("; ")
                                                                      : QStringLiteral(", ")));
}

}  // namespace covaria::ui
