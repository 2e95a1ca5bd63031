// Results as an Excel workbook: budgets with live formulas beside the values that Covaria computed.
#include <algorithm>
#include <cmath>

#include "core/quantity/input_quantity.h"
#include "core/result/representation.h"
#include "core/result/result_line.h"
#include "core/text/head_with_unit.h"
#include "core/text/numbers.h"
#include "core/writers/formats.h"
#include "core/writers/xlsx_book.h"

namespace covaria {

namespace {

using Look = XlsxBook::Look;

constexpr std::size_t most_budget_sheets = 250;
constexpr std::size_t most_bars = 40;  ///< of a chart that is still read on a page

enum BudgetSheetColumn {
    symbol = 1,
    name,
    estimate,
    unit,
    u,
    distribution,
    nu,
    c,
    contribution,
    square,
    fourth
};

/// A line of a budget sheet.
struct SheetLine {
    std::size_t component = 0;
    double sensitivity = 0.0;  ///< sensitivity in SI
    std::string symbol;
    double contribution = 0.0;  ///< in SI
};

std::string range(int column, int first, int last) {
    return cell_name(first, column) + ":" + cell_name(last, column);
}

/// Excel's format for numbers with these decimals; with a power of ten where they are of no ordinary size.
std::string format_of(double value, int decimals) {
    constexpr double large = 1e9;
    constexpr int most_decimals = 9;
    if (std::abs(value) < large && decimals >= 0 && decimals <= most_decimals)
        return decimals == 0 ? "0" : "0." + std::string(static_cast<std::size_t>(decimals), '0');
    const double exponent = value == 0.0 ? -decimals : std::floor(std::log10(std::abs(value)));
    const double behind = std::clamp(exponent + decimals, 0.0, 14.0);
    return (behind > 0.0 ? "0." + std::string(static_cast<std::size_t>(behind), '0') : std::string("0")) +
           "E+00";
}

/// The format of a number by itself, to so many significant digits.
std::string format_of_digits(double value, int digits) {
    constexpr double small = 1e-4;
    if (!std::isfinite(value) || value == 0.0) return {};
    if (std::abs(value) < small)
        return "0." + std::string(static_cast<std::size_t>(digits - 1), '0') + "E+00";
    return format_of(value, decimals_for(value, digits));
}

/// The format of a value that has an uncertainty, as results are rounded (JCGM 100 7.2.6).
std::string format_to_match_u(double value, double uncertainty, int digits) {
    if (!std::isfinite(value) || !std::isfinite(uncertainty) || uncertainty == 0.0) return {};
    return format_of(value, decimals_for(uncertainty, digits));
}

constexpr int digits_of_parts = 3;  ///< of uncertainties within a budget, one more than a result has
constexpr int digits_of_coefficients = 4;

/// Writes the heads in line 4. `y` is the unit of contributions.
void write_heads(XlsxBook& book, const Unit& y) {
    struct Head {
        std::string words;
        double width;
        Look look;
    };
    const Look words = Look::head, numbers = Look::head_of_numbers;
    const std::vector<Head> heads{{"Quantity", 12, words},
                                  {"Component", 42, words},
                                  {"Estimate", 16, numbers},
                                  {"Unit", 11, words},
                                  {"Standard uncertainty", 13, numbers},
                                  {"Distribution", 15, words},
                                  {"Degrees of freedom", 11, numbers},
                                  {"Sensitivity coefficient", 13, numbers},
                                  {to_unicode(head_with_unit("Contribution", y)), 16, numbers},
                                  {"Its square", 11, numbers},
                                  {"Its fourth power over nu", 14, numbers}};
    for (std::size_t i = 0; i < heads.size(); ++i) {
        book.text(4, static_cast<int>(i) + 1, heads[i].words, heads[i].look);
        book.set_width(static_cast<int>(i) + 1, heads[i].width);
    }
    book.freeze_heads(4, 1);
}

/// The lines in the order of the quantities; components of a quantity that have one sensitivity stand
/// together.
std::vector<SheetLine> lines_of(const UncertaintyBudget& budget, std::size_t output) {
    std::vector<SheetLine> lines;
    for (const BudgetRow& row : budget.rows[output]) {
        const BudgetComponent& component = budget.components[row.component];
        std::string label = component.quantities.size() == 1 ? component.quantities.front() : component.id;
        for (const SheetLine& other : lines)
            if (other.symbol == label && other.sensitivity != row.sensitivity) label = component.id;
        lines.push_back({row.component, row.sensitivity, label, row.contribution});
    }
    std::sort(lines.begin(), lines.end(),
              [](const SheetLine& a, const SheetLine& b) { return a.component < b.component; });
    // The order is stable by first appearance, and rows of one symbol are neighbours.
    std::vector<SheetLine> ordered;
    for (const SheetLine& line : lines) {
        if (std::any_of(ordered.begin(), ordered.end(),
                        [&](const SheetLine& o) { return o.symbol == line.symbol; }))
            continue;
        for (const SheetLine& other : lines)
            if (other.symbol == line.symbol) ordered.push_back(other);
    }
    return ordered;
}

/// Writes the results of the trials as values only, since trials cannot be formulas; returns the next row.
int write_trials(XlsxBook& book, int row, const OutputResult& output, std::uint64_t trials) {
    if (!output.monte_carlo) return row;
    book.text(row++, name, "Monte Carlo, " + std::to_string(trials) + " trials", Look::title);
    const Unit& unit_y = output.quantity.unit;
    const CoverageInterval& interval = output.monte_carlo->symmetric;
    const double u_y = unit_y.interval().interval_from_si(output.monte_carlo->standard_uncertainty);
    const auto value = [&](const char* label, double v) {
        book.text(row, name, label);
        book.number(row++, estimate, v, Look::stated, format_to_match_u(v, u_y, digits_of_parts));
    };
    value("Estimate", unit_y.from_si(output.monte_carlo->mean));
    value("Standard uncertainty", u_y);
    value("Coverage interval, low", unit_y.from_si(interval.low));
    value("Coverage interval, high", unit_y.from_si(interval.high));
    return row;
}

/// Writes each pair of correlated lines with its term of the variance, 2 r c_1 u_1 c_2 u_2, below heads in
/// `row`; returns how many there are. The lines stand from row 5 on, `y` is the unit of contributions.
int write_pairs(XlsxBook& book, const UncertaintyResult& result, const std::vector<SheetLine>& lines,
                const Unit& y, int row) {
    const auto all = resolved_correlations(result.inputs);
    if (!all || lines.empty()) return 0;
    constexpr int first_line = 5;
    const std::vector<BudgetComponent>& components = result.budget.components;
    std::vector<int> rows(components.size(), 0);
    for (std::size_t i = 0; i < lines.size(); ++i)
        rows[lines[i].component] = first_line + static_cast<int>(i);
    const auto share_of = [&](int at) {
        const SheetLine& line = lines[static_cast<std::size_t>(at - first_line)];
        return y.interval_from_si(line.sensitivity * components[line.component].standard_uncertainty);
    };
    int at = row + 2;
    for (const ComponentCorrelation& pair : *all) {
        const int a = rows.at(pair.first), b = rows.at(pair.second);
        if (a == 0 || b == 0 || pair.coefficient == 0.0) continue;
        book.text(at, symbol, components[pair.first].id);
        book.text(at, name, components[pair.second].id);
        book.number(at, c, pair.coefficient, Look::stated);
        const double term = 2.0 * pair.coefficient * share_of(a) * share_of(b);
        book.formula(
            at, square,
            "=2*" + cell_name(at, c) + "*" + cell_name(a, contribution) + "*" + cell_name(b, contribution),
            term, Look::plain, format_of_digits(term, digits_of_parts));
        ++at;
    }
    const int pairs = at - row - 2;
    if (pairs == 0) return 0;
    book.text(row, symbol, "Correlations", Look::title);
    book.text(row + 1, symbol, "Component", Look::head);
    book.text(row + 1, name, "and component", Look::head);
    book.text(row + 1, c, "Coefficient r", Look::head_of_numbers);
    book.text(row + 1, square, "Term of the variance", Look::head_of_numbers);
    return pairs;
}

/// The sheet of one output of one analysis.
class BudgetSheet {
public:
    BudgetSheet(XlsxBook& book, const EvaluatedAnalysis& evaluated, std::size_t output)
        : book_(book),
          result_(*evaluated.result),
          output_(result_.outputs[output]),
          y_(output_.quantity.unit.interval()),
          lines_(lines_of(result_.budget, output)) {
        title_ = output_.quantity.symbol + ": " + output_.quantity.name.english();
        analysis_ = evaluated.analysis->name;
    }

    void write() {
        book_.text(1, 1, title_, Look::title);
        book_.text(2, 1,
                   "Analysis " + analysis_ +
                       ". White cells are formulas, blue ones are figures that Covaria wrote: change a "
                       "figure and the sheet computes anew.");
        write_heads(book_, y_);
        row_ = 5;
        for (const SheetLine& line : lines_) write_line(line);
        last_ = row_ - 1;
        write_result();
        first_pair_ = row_ + 2;
        pairs_ = write_pairs(book_, result_, lines_, y_, row_);
        if (pairs_ > 0) row_ = first_pair_ + pairs_ + 1;
        write_comparison();
        if (lines_.size() > 1 && lines_.size() <= most_bars)
            book_.bars(row_ + 1, name,
                       to_unicode(head_with_unit("Contributions to " + output_.quantity.symbol, y_)), symbol,
                       contribution, 5, last_);
    }

private:
    void write_line(const SheetLine& line) {
        const BudgetComponent& component = result_.budget.components[line.component];
        // Of many components together only the contribution is one figure.
        const Unit x = component.is_rest ? y_ : component.unit.interval();
        const double u_of_line = component.is_rest ? line.contribution : component.standard_uncertainty;
        book_.text(row_, symbol, component.is_rest ? "" : line.symbol);
        book_.text(row_, name, component.name.english());
        if (line.symbol != before_ && !component.is_rest) {
            const bool own = component.quantities.size() == 1 && component.quantity_unit.interval() == x;
            const double x_i = own ? component.quantity_unit.from_si(component.estimate) : 0.0;
            book_.number(
                row_, estimate, x_i, Look::stated,
                format_to_match_u(x_i, x.interval_from_si(component.standard_uncertainty), digits_of_parts));
        }
        before_ = line.symbol;
        const bool offset = component.quantity_unit.has_offset() && component.quantity_unit.interval() == x;
        book_.text(row_, unit, offset ? component.quantity_unit.display() : x.display(), Look::after_number);
        const double u_i = x.interval_from_si(u_of_line);
        book_.number(row_, u, u_i, Look::stated, format_of_digits(u_i, digits_of_parts));
        book_.text(row_, distribution, component.distribution, Look::after_number);
        const double degrees = component.degrees_of_freedom;
        if (std::isfinite(degrees))
            book_.number(row_, nu, degrees, Look::stated, degrees < 1e6 ? "0.##" : "0.0E+00");
        else
            book_.text(row_, nu, "∞", Look::stated);
        // The coefficient is in the unit of the result for one unit of the quantity.
        const double slope = y_.interval_from_si(x.interval_to_si(line.sensitivity));
        book_.number(row_, c, slope, Look::stated, format_of_digits(slope, digits_of_coefficients));
        const double share = slope * u_i;
        const std::string own = cell_name(row_, contribution);
        book_.formula(row_, contribution, "=" + cell_name(row_, u) + "*" + cell_name(row_, c), share,
                      Look::plain, format_to_match_u(share, first_order_u(), digits_of_parts));
        book_.formula(row_, square, "=" + own + "^2", share * share, Look::plain,
                      format_of_digits(share * share, digits_of_parts));
        if (std::isfinite(degrees)) {
            const double part = std::pow(share, 4) / degrees;
            book_.formula(row_, fourth, "=" + own + "^4/" + cell_name(row_, nu), part, Look::plain,
                          format_of_digits(part, digits_of_parts));
        }
        ++row_;
    }

    /// Whether components are independent of each other, where the formula of Welch and Satterthwaite is that
    /// of Covaria.
    bool independent() const {
        return result_.inputs->correlations.empty() && result_.inputs->variance_estimates.empty() &&
               result_.inputs->vectors.empty();
    }

    double first_order_u() const { return y_.interval_from_si(output_.first_order.standard_uncertainty); }

    void write_result() {
        result_row_ = row_;
        book_.text(row_, symbol, output_.quantity.symbol, Look::head);
        book_.text(row_, name, output_.quantity.name.english(), Look::head);
        const double y = output_.quantity.unit.from_si(output_.first_order.estimate);
        book_.number(row_, estimate, y, Look::head, format_to_match_u(y, first_order_u(), digits_of_parts));
        book_.name_cell("estimate", row_, estimate);
        book_.text(row_, unit, output_.quantity.unit.display(), Look::head);
        row_ += 2;
    }

    void write_comparison() {
        book_.text(row_, name, "Law of propagation", Look::title);
        ++row_;
        book_.text(row_, estimate, "live formula", Look::head_of_numbers);
        book_.text(row_, unit, "Covaria", Look::head_of_numbers);
        book_.text(row_, u, "do both agree?", Look::head);
        ++row_;
        const FirstOrderOutput& law = output_.first_order;
        const double u_y = first_order_u();
        const bool any = !lines_.empty();
        const std::string squares = any ? "SUM(" + range(square, 5, last_) + ")" : "0";
        const std::string pairs =
            pairs_ > 0 ? "+SUM(" + range(square, first_pair_, first_pair_ + pairs_ - 1) + ")" : "";
        const int variance =
            compare("Sum of squares" + std::string(pairs_ > 0 ? " and terms of correlation" : ""),
                    "=" + squares + pairs, u_y * u_y);
        const int row_u =
            compare("Standard uncertainty u", "=SQRT(" + cell_name(variance, estimate) + ")", u_y);
        book_.formula(result_row_, contribution, "=" + cell_name(row_u, estimate), u_y, Look::head,
                      format_of_digits(u_y, digits_of_parts));
        book_.name_cell("standard_uncertainty", row_u, estimate);
        const double degrees = law.effective_degrees_of_freedom;
        int row_nu = row_;
        if (independent() && any) {
            const std::string sum = "SUM(" + range(fourth, 5, last_) + ")";
            row_nu = compare(
                "Effective degrees of freedom",
                "=IF(" + sum + "=0,\"infinite\"," + cell_name(row_u, estimate) + "^4/" + sum + ")", degrees);
        } else {
            book_.text(row_, name,
                       "Effective degrees of freedom, as Covaria has them for dependent components");
            book_.number(row_, estimate, degrees, Look::stated, format_of_digits(degrees, digits_of_parts));
            ++row_;
        }
        book_.name_cell("effective_degrees_of_freedom", row_nu, estimate);
        const int row_p = row_;
        book_.text(row_, name, "Coverage probability");
        book_.name_cell("coverage_probability", row_, estimate);
        book_.number(row_++, estimate, result_.coverage_probability, Look::stated, "0.0###%");
        write_expanded(row_u, row_nu, row_p);
        row_ = write_trials(book_, row_ + 1, output_, result_.trials);
    }

    void write_expanded(int row_u, int row_nu, int row_p) {
        const FirstOrderOutput& law = output_.first_order;
        int row_k = row_;
        if (result_.fixed_coverage_factor) {
            book_.text(row_, name, "Coverage factor k, fixed");
            book_.number(row_++, estimate, *result_.fixed_coverage_factor, Look::stated, "0.00##");
        } else {
            // Student's t for any real number of degrees of freedom follows from the beta distribution.
            const std::string p = cell_name(row_p, estimate), n = cell_name(row_nu, estimate),
                              beta = "BETAINV(" + p + ",0.5," + n + "/2)";
            row_k = compare("Coverage factor k",
                            "=IF(ISNUMBER(" + n + "),IF(" + n + "<1E6,SQRT(" + n + "*" + beta + "/(1-" +
                                beta + ")),NORMSINV((1+" + p + ")/2)),NORMSINV((1+" + p + ")/2))",
                            law.coverage_factor);
        }
        book_.name_cell("coverage_factor", row_k, estimate);
        const int row_U = compare("Expanded uncertainty U",
                                  "=" + cell_name(row_k, estimate) + "*" + cell_name(row_u, estimate),
                                  y_.interval_from_si(law.expanded_uncertainty));
        book_.name_cell("expanded_uncertainty", row_U, estimate);
    }

    /// Writes label, formula, Covaria's value and whether both agree to 1e-6; returns their row.
    int compare(const std::string& label, const std::string& formula, double covaria) {
        book_.text(row_, name, label);
        const std::string format = format_of_digits(covaria, digits_of_parts);
        book_.formula(row_, estimate, formula, covaria, Look::plain, format);
        book_.number(row_, unit, covaria, Look::stated, format);
        const std::string live = cell_name(row_, estimate), stated = cell_name(row_, unit);
        book_.text_formula(row_, u,
                           "=IF(ISNUMBER(" + stated + "),IF(ABS(" + live + "-" + stated + ")<=1E-6*ABS(" +
                               stated + "),\"yes\",\"NO\"),IF(" + live + "=" + stated + ",\"yes\",\"NO\"))",
                           "yes");
        return row_++;
    }

    XlsxBook& book_;
    const UncertaintyResult& result_;
    const OutputResult& output_;
    Unit y_;  ///< unit of uncertainties of the output
    std::string title_, analysis_, before_;
    std::vector<SheetLine> lines_;
    int row_ = 1, last_ = 4, result_row_ = 0, first_pair_ = 0, pairs_ = 0;
};

void write_results_sheet(XlsxBook& book, const WriterSource& source, std::vector<std::string>& said) {
    book.add_sheet("Results");
    book.text(1, 1, source.made.project().title, Look::title);
    const std::vector<std::pair<const char*, double>> heads{{"Analysis", 24},
                                                            {"Output", 10},
                                                            {"Measurand", 34},
                                                            {"Unit", 10},
                                                            {"y", 18},
                                                            {"u", 14},
                                                            {"nu_eff", 10},
                                                            {"k", 10},
                                                            {"U", 14},
                                                            {"Interval low", 18},
                                                            {"Interval high", 18},
                                                            {"By", 18}};
    for (std::size_t i = 0; i < heads.size(); ++i) {
        const bool of_number = i >= 4 && i <= 10;
        book.text(3, static_cast<int>(i) + 1, heads[i].first, of_number ? Look::head_of_numbers : Look::head);
        book.set_width(static_cast<int>(i) + 1, heads[i].second);
    }
    book.freeze_heads(3, 2);
    int row = 4;
    for (const EvaluatedAnalysis& evaluated : source.analyses) {
        const UncertaintyResult& result = *evaluated.result;
        const int digits = evaluated.analysis->style.digits.value_or(2);
        if (!represents_measurand(result)) {
            said.push_back("not written: analysis " + evaluated.analysis->id + ", whose result " +
                           does_not_represent);
            continue;
        }
        for (const OutputResult& output : result.outputs) {
            const Unit unit = output.quantity.unit, interval = unit.interval();
            const CoverageInterval covered = coverage_interval_of(output, result);
            book.text(row, 1, evaluated.analysis->name);
            book.text(row, 2, output.quantity.symbol);
            book.text(row, 3, output.quantity.name.english());
            book.text(row, 4, unit.display());
            const double y = unit.from_si(output.estimate), low = unit.from_si(covered.low),
                         high = unit.from_si(covered.high);
            const double u_y = interval.interval_from_si(output.standard_uncertainty),
                         U = interval.interval_from_si(output.expanded_uncertainty);
            const double degrees = output.first_order.effective_degrees_of_freedom;
            const auto number = [&](int column, double value, const std::string& format) {
                book.number(row, column, value, Look::stated, format);
            };
            number(5, y, format_to_match_u(y, U, digits));
            number(6, u_y, format_of_digits(u_y, digits));
            number(7, degrees, degrees < 1e6 ? "0.0" : "0.0E+00");
            number(8, output.coverage_factor, "0.00");
            number(9, U, format_of_digits(U, digits));
            number(10, low, format_to_match_u(low, U, digits));
            number(11, high, format_to_match_u(high, U, digits));
            book.text(row, 12, output.monte_carlo ? "Monte Carlo" : "law of propagation", Look::after_number);
            ++row;
        }
    }
}

Result<WrittenFile> write_xlsx(const WriterSource& source) {
    if (source.analyses.empty()) return fail(ErrorCode::bad_input, tell<"there are no results to write">());
    WrittenFile file;
    XlsxBook book;
    write_results_sheet(book, source, file.said);
    std::size_t budgets = 0, beyond = 0;
    for (const EvaluatedAnalysis& evaluated : source.analyses) {
        if (!represents_measurand(*evaluated.result)) continue;
        for (std::size_t j = 0; j < evaluated.result->outputs.size(); ++j) {
            if (budgets == most_budget_sheets) {
                ++beyond;
                continue;
            }
            const OutputQuantity& quantity = evaluated.result->outputs[j].quantity;
            book.add_sheet(quantity.symbol + (quantity.group.empty() ? "" : " " + quantity.group));
            BudgetSheet(book, evaluated, j).write();
            ++budgets;
        }
    }
    auto bytes = book.finish();
    if (!bytes) return fail(bytes.error());
    file.bytes = std::move(*bytes);
    file.said.insert(file.said.begin(), "sheet Results and " + std::to_string(budgets) +
                                            " budgets with live formulas, which say whether they agree with "
                                            "Covaria to 1e-6");
    if (beyond > 0) file.said.push_back("without a sheet: " + std::to_string(beyond) + " more budgets");
    return file;
}

}  // namespace

Writer xlsx_writer() {
    return {.name = "xlsx",
            .title = "Excel workbook",
            .ending = ".xlsx",
            .writes =
                "results, and the budget of every output with live formulas (contributions, u, nu_eff, k, U) "
                "beside Covaria's values",
            .write = write_xlsx};
}

}  // namespace covaria
