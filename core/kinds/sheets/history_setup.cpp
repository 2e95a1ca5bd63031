// The fields of "history of an instrument", and the series of values that follows from them.
#include "core/kinds/sheets/history_setup.h"

namespace covaria::sheets {

namespace {

constexpr double days_of_year = 365.25;

Columns<HistoryRow> history_columns() {
    return Columns<HistoryRow>()
        .add(&HistoryRow::date, "date", "date", "Of the calibration: 2026-04-17. Earlier ones stand above.")
        .add(&HistoryRow::found, "found", "as found", "Value or deviation before an adjustment, in the unit.",
             {.observed = true})
        .add(&HistoryRow::left, "left", "as left", "After an adjustment, in the unit; empty: not adjusted.",
             {.optional = true})
        .add(&HistoryRow::u, "u", "u",
             "Standard uncertainty of this value alone, in the unit. Used, and needed, with stated "
             "uncertainties.",
             {.range = {.low = 0.0, .low_open = true}, .optional = true});
}

void add_values(Fields<StatedHistory>& fields) {
    fields.section("Quantity")
        .add(&StatedHistory::symbol, "symbol", "Symbol", "Of the value.", {.default_value = std::string("V")})
        .add(&StatedHistory::name, "name", "Name", "What the calibrations state.",
             {.default_value = std::string("value of the instrument")})
        .add(&StatedHistory::unit, "unit", "Unit", "In which the values are given.",
             {.default_value = std::string("1")})
        .section("Calibrations")
        .table(&StatedHistory::rows, "history", "Calibrations",
               "What each calibration found, typed, pasted or from a CSV file.", history_columns(),
               {.min_rows = 2, .measured = true})
        .choice(&StatedHistory::from_residuals, "uncertainty", "Uncertainty",
                "From the scatter about the line (three calibrations or more), or as stated for each value.",
                {{true, "residuals", "from the residuals"}, {false, "stated", "as stated"}}, true)
        .add(&StatedHistory::common_u, "common_u", "Common u",
             "Standard uncertainty of a deviation that all values share, as that of the laboratory's "
             "standard, in the unit. It is none of the drift.",
             {.range = {.low = 0.0}, .default_value = Quantity{0.0, Unit{}}});
}

void add_use(Fields<StatedHistory>& fields) {
    fields.section("Use")
        .add(&StatedHistory::used_on, "used_on", "Date of use",
             "The value and the drift on that day: 2026-11-28; empty: not asked.", {.optional = true})
        .section("Next calibration")
        .choice(&StatedHistory::rule, "rule", "Rule",
                "What must stay within the limit until the next calibration, with k times its u.",
                {{DueRule::none, "none", "none"},
                 {DueRule::drift, "drift", "the drift since the last calibration"},
                 {DueRule::deviation, "deviation", "the deviation from the nominal value"}},
                DueRule::none)
        .add(&StatedHistory::limit, "limit", "Limit", "In the unit.",
             {.range = {.low = 0.0}, .default_value = Quantity{0.0, Unit{}}})
        .add(&StatedHistory::nominal, "nominal", "Nominal value", "In the unit; 0 for deviations.",
             {.default_value = Quantity{0.0, Unit{}}})
        .add(&StatedHistory::factor, "factor", "k of the rule", "Multiple of u that is added.",
             {.range = {.low = 0.0}, .default_value = Quantity{2.0, Unit{}}})
        .add(
            &StatedHistory::longest_years, "longest", "Longest interval",
            "Years after which it is due in any case.",
            {.range = {.low = 0.0, .high = 100.0, .low_open = true}, .default_value = Quantity{10.0, Unit{}}})
        .shown_where(&StatedHistory::rule, {DueRule::deviation}, &StatedHistory::nominal)
        .shown_where(&StatedHistory::rule, {DueRule::drift, DueRule::deviation}, &StatedHistory::limit,
                     &StatedHistory::factor, &StatedHistory::longest_years);
}

/// The day of a row; nothing, and a problem, where it is none or not after the one before.
std::optional<Days> day_of(const StatedHistory& stated, std::size_t row, Problems& problems) {
    const std::string place = history_fields().place(&StatedHistory::rows, row, &HistoryRow::date);
    const auto day = date_of(stated.rows[row].date);
    if (!day)
        problems.error(place,
                       tell<"a date of the form 2026-04-17 is needed; it is '%1'">(stated.rows[row].date));
    else if (const auto before = row > 0 ? date_of(stated.rows[row - 1].date) : std::nullopt;
             before && *day <= *before)
        problems.error(place, tell<"the calibration in row %1 is not after the one before it">(row + 1));
    return day;
}

void take_values(HistorySetup& setup, Problems& problems) {
    const Unit& unit = setup.unit;
    setup.reference = setup.rows.empty() ? 0.0 : unit.to_si(setup.rows.front().found);
    for (std::size_t row = 0; row < setup.rows.size(); ++row) {
        const HistoryRow& one = setup.rows[row];
        const auto day = day_of(setup, row, problems);
        if (!setup.from_residuals && !one.u)
            problems.error(history_fields().place(&StatedHistory::rows, row, &HistoryRow::u),
                           tell<"row %1 needs the standard uncertainty of its value">(row + 1));
        if (!day) continue;
        const double found = unit.to_si(one.found) - setup.reference;
        setup.values.push_back({*day, found - setup.adjusted, unit.interval_to_si(one.u.value_or(0.0))});
        if (one.left) setup.adjusted += unit.interval_to_si(*one.left - one.found);
    }
    setup.common_u = unit.interval_to_si(setup.common_u);
}

void check_use(HistorySetup& setup, Problems& problems) {
    const auto& fields = history_fields();
    if (setup.from_residuals && setup.rows.size() < 3)
        problems.error(fields.place(&StatedHistory::rows),
                       tell<"two calibrations have no scatter about a line: state the uncertainty of each "
                            "value, or add a third">());
    if (setup.rule != DueRule::none && !(setup.limit > 0.0))
        problems.error(fields.place(&StatedHistory::limit), tell<"the rule needs a limit above zero">());
    for (const char* taken : {"D_a", "d"})
        if (setup.symbol == taken)
            problems.error(fields.place(&StatedHistory::symbol),
                           tell<"'%1' is the symbol of a drift: choose another one">(setup.symbol));
    if (setup.used_on.empty()) return;
    setup.use = date_of(setup.used_on);
    const std::string place = fields.place(&StatedHistory::used_on);
    if (!setup.use)
        problems.error(place, tell<"a date of the form 2026-04-17 is needed; it is '%1'">(setup.used_on));
    else if (!setup.values.empty() && *setup.use < setup.values.back().day)
        problems.error(place, tell<"the date of use is before the last calibration">());
}

}  // namespace

const Fields<StatedHistory>& history_fields() {
    static const Fields<StatedHistory> fields = [] {
        Fields<StatedHistory> made;
        add_values(made);
        add_use(made);
        return made;
    }();
    return fields;
}

std::optional<HistorySetup> read_history_setup(const SetupReader& reader, const AssetLibrary& assets,
                                               Problems& problems) {
    HistorySetup setup{history_fields().read(reader, assets, problems), {}, 0.0, 0.0, {}};
    take_values(setup, problems);
    check_use(setup, problems);
    if (problems.has_errors()) return std::nullopt;
    return setup;
}

double years_between(Days from, Days to) {
    return double((to - from).count()) / days_of_year;
}

}  // namespace covaria::sheets
