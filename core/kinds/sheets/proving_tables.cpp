// Tables and charts of the sheet of a force-proving instrument: errors, budget of W, curves, classes.
#include <algorithm>
#include <cmath>

#include "core/kinds/sheets/proving_figures.h"
#include "core/text/numbers.h"

namespace covaria::sheets {

namespace {

const Unit sheet_ratio = Unit::of("mV/V"), sheet_percent = Unit::of("%");

Cell cell_of(const std::optional<double>& si) {
    return si ? Cell(*si) : Cell();
}

Quantity in_percent(double si) {
    return {sheet_percent.interval_from_si(si), sheet_percent};
}

Table errors_table(const ProvingSetup& setup, const ProvingFigures& figures) {
    Table table{"errors", "Errors after ISO 376"};
    table.add("force").in(setup.force_unit);
    table.add("mean deflection").in(sheet_ratio).fixed(6);
    for (const char* symbol : {"b", "b'", "f_c", "v"}) table.add(symbol).in(sheet_percent).symbol().fixed(4);
    if (!setup.classes.empty()) table.add("class");
    for (std::size_t i = 0; i < setup.steps.size(); ++i) {
        const StepFigures& step = figures.steps[i];
        table.row(
            {setup.steps[i].force, step.mean, step.b, step.b_same, step.f_c, cell_of(step.v),
             step.first_class() ? Cell(setup.classes[*step.first_class()].name) : Cell(tell<"none">())});
    }
    if (setup.classes.empty())
        table.notes.push_back(tell<"No limits of classes are entered: no class is found.">());
    return table;
}

Table figures_table(const ProvingSetup& setup, const ProvingFigures& figures) {
    Table table{"sheet", "Sheet"};
    table.add("quantity");
    table.add("value").figure(4);
    const auto ratio = [](double si) { return Quantity{sheet_ratio.interval_from_si(si), sheet_ratio}; };
    table.row({tell<"largest force">(),
               Quantity{setup.force_unit.from_si(setup.largest_force()), setup.force_unit}});
    table.row({tell<"deflection at the largest force">(), ratio(setup.largest_deflection())});
    if (figures.f_0)
        table.row({tell<"zero error f_0, the largest of the series">(), in_percent(*figures.f_0)});
    if (figures.c) table.row({tell<"creep error c">(), in_percent(*figures.c)});
    table.row({tell<"standard deviation of the residuals">(), ratio(figures.s_fit)});
    table.row({tell<"degrees of freedom of the interpolation">(), setup.degrees_of_freedom()});
    if (!figures.f_0) table.notes.push_back(tell<"Without indications at zero there is no zero error.">());
    if (!figures.c) table.notes.push_back(tell<"Creep was not measured: the budget has none of it.">());
    return table;
}

/// The steps from which up every one is within the limits of the class itself: one row of limits need not be
/// stricter than the next.
Table classes_table(const ProvingSetup& setup, const ProvingFigures& figures) {
    Table table{"classes", "Classes by the limits entered"};
    table.add("class");
    table.add("from").in(setup.force_unit);
    table.add("to").in(setup.force_unit);
    table.add("verdict");
    for (std::size_t k = 0; k < setup.classes.size(); ++k) {
        std::size_t first = setup.steps.size();
        while (first > 0 && figures.steps[first - 1].is_of_class[k]) --first;
        const bool holds = first < setup.steps.size();
        table.row({setup.classes[k].name, holds ? Cell(setup.steps[first].force) : Cell(),
                   holds ? Cell(setup.largest_force()) : Cell(),
                   holds ? tell<"conforms">() : tell<"does not conform">()});
    }
    const auto limited = [&](std::optional<double> ClassLimits::*limit) {
        return std::ranges::any_of(setup.classes, [&](const auto& one) { return (one.*limit).has_value(); });
    };
    if (limited(&ClassLimits::f_0) && !figures.f_0)
        table.notes.push_back(tell<"The zero error was not measured and is held against no limit.">());
    if (limited(&ClassLimits::c) && !figures.c)
        table.notes.push_back(tell<"The creep error was not measured and is held against no limit.">());
    if (limited(&ClassLimits::v) &&
        std::ranges::any_of(figures.steps, [](const auto& step) { return !step.v.has_value(); }))
        table.notes.push_back(tell<"The reversibility error was not measured at every step; where it was "
                                   "not, it is held against no limit.">());
    return table;
}

Table parts_table(const ProvingSetup& setup, const ProvingFigures& figures) {
    Table table{"parts", "Relative standard uncertainties and W"};
    table.add("force").in(setup.force_unit);
    for (const std::string& head :
         {known_text<"machine">(), known_text<"reproducibility">(), known_text<"repeatability">(),
          known_text<"resolution">(), known_text<"creep">(), known_text<"zero">(),
          known_text<"temperature">(), known_text<"interpolation">(), known_text<"reversibility">()})
        table.add(head).in(sheet_percent).fixed(4);
    table.add("w").in(sheet_percent).symbol().fixed(4);
    table.add("W").in(sheet_percent).symbol().fixed(3);
    for (std::size_t i = 0; i < setup.steps.size(); ++i) {
        const StepFigures& step = figures.steps[i];
        std::vector<Cell> cells{setup.steps[i].force};
        for (const double u : step.parts) cells.emplace_back(u);
        cells.emplace_back(step.combined());
        cells.emplace_back(setup.k * step.combined());
        table.row(std::move(cells));
    }
    return table;
}

Table curves_table(const ProvingSetup& setup, const ProvingFigures& figures) {
    Table table{"curves", "Curves over the force"};
    table.add("curve");
    table.add("power of the force");
    table.add("coefficient").figure(7);
    const auto rows = [&](const Message& name, const Eigen::VectorXd& coefficients, std::size_t first,
                          const char* unit) {
        for (Eigen::Index k = 0; k < coefficients.size(); ++k) {
            const std::size_t power = first + std::size_t(k);
            const Unit per = per_force(unit, setup.force_unit, power);
            table.row({name, double(power),
                       Quantity{per.interval_from_si(coefficients[k] /
                                                     std::pow(setup.largest_force(), double(power))),
                                per}});
        }
    };
    rows(tell<"deflection">(), figures.coefficients, setup.first_power(), "mV/V");
    rows(tell<"W, relative expanded uncertainty">(), figures.uncertainty_curve, 0, "%");
    table.notes.push_back(
        tell<"The curve of W is a fit to the steps, raised by %1 % so that no step lies above it.">(
            Message::number(format_short(in_percent(figures.raised).value, 2))));
    return table;
}

PlotSpecification plot_over_force(const ProvingSetup& setup, const char* id, const char* title,
                                  const char* what) {
    PlotSpecification plot;
    plot.id = id;
    plot.title = title;
    plot.x.title = "force";
    plot.x.unit = setup.force_unit.display();
    plot.y.title = what;
    plot.y.unit = "%";
    return plot;
}

template <class Figure>
PlotSeries series_over_force(const ProvingSetup& setup, const ProvingFigures& figures, std::string name,
                             SeriesRole role, Figure figure) {
    PlotSeries series{std::move(name), SeriesKind::points, role, {}, {}, {}, 0.0};
    for (std::size_t i = 0; i < setup.steps.size(); ++i) {
        const std::optional<double> y = figure(figures.steps[i]);
        if (!y) continue;
        series.x.push_back(setup.force_unit.from_si(setup.steps[i].force));
        series.y.push_back(100.0 * *y);
    }
    return series;
}

}  // namespace

Unit per_force(const std::string& unit, const Unit& force, std::size_t power) {
    const bool is_product = force.text().find_first_of("*/^") != std::string::npos;
    const std::string per = is_product ? "(" + force.text() + ")" : force.text();
    const std::string exponent = power == 1 ? "" : "^" + std::to_string(power);
    return Unit::parse(power == 0 ? unit : unit + "/" + per + exponent).value_or(Unit{});
}

std::vector<Table> proving_tables(const ProvingSetup& setup, const ProvingFigures& figures) {
    std::vector<Table> tables{figures_table(setup, figures), errors_table(setup, figures)};
    if (!setup.classes.empty()) tables.push_back(classes_table(setup, figures));
    tables.push_back(parts_table(setup, figures));
    tables.push_back(curves_table(setup, figures));
    return tables;
}

std::vector<PlotSpecification> proving_plots(const ProvingSetup& setup, const ProvingFigures& figures) {
    using Step = StepFigures;
    using Figure = std::optional<double>;
    PlotSpecification errors = plot_over_force(setup, "errors", "Errors over the force", "relative error");
    const auto add = [&](const char* name, SeriesRole role, auto figure) {
        errors.series.push_back(series_over_force(setup, figures, name, role, figure));
    };
    add("b", SeriesRole::family_1, [](const Step& s) { return Figure(s.b); });
    add("b′", SeriesRole::family_2, [](const Step& s) { return Figure(s.b_same); });
    add("f_c", SeriesRole::family_3, [](const Step& s) { return Figure(s.f_c); });
    if (std::ranges::any_of(figures.steps, [](const Step& s) { return s.v.has_value(); }))
        add("v", SeriesRole::family_4, [](const Step& s) { return s.v; });
    PlotSpecification w =
        plot_over_force(setup, "uncertainty", "Relative expanded uncertainty over the force", "W");
    w.series.push_back(series_over_force(setup, figures, known_text<"steps">(), SeriesRole::data,
                                         [&](const Step& s) { return Figure(setup.k * s.combined()); }));
    PlotSeries curve{known_text<"curve">(), SeriesKind::line, SeriesRole::fit, {}, {}, {}, 0.0};
    const double low = setup.steps.front().force / setup.largest_force();
    for (int i = 0; i <= 60; ++i) {
        const double t = low + (1.0 - low) * double(i) / 60.0;
        curve.x.push_back(setup.force_unit.from_si(t * setup.largest_force()));
        curve.y.push_back(100.0 * polynomial_at(figures.uncertainty_curve, 0, t));
    }
    w.series.push_back(std::move(curve));
    return {errors, w};
}

}  // namespace covaria::sheets
