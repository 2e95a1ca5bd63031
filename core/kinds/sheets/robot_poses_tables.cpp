// Tables of the sheet of a robot beside its results: figures as the standard defines them, what few cycles
// do to them, decisions.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/kinds/sheets/robot_poses_figures.h"
#include "core/kinds/sheets/verdict.h"
#include "core/math/special_quantiles.h"

namespace covaria::sheets {

namespace {

const Unit table_mm = Unit::of("mm"), table_percent = Unit::of("%");
constexpr double most_cycles = 100000.0;

Table poses_table(const RobotPosesSetup& setup, const RobotPosesFigures& figures) {
    Table table{"sheet", "Accuracy and repeatability, from the cycles as they are"};
    table.add("pose");
    table.add("cycles");
    table.add("AP").in(table_mm).symbol().figure(3);
    table.add(known_text<"AP by scatter alone">()).in(table_mm).uncertainty();
    table.add("RP").in(table_mm).symbol().figure(3);
    table.add(known_text<"RP, few cycles allowed for">()).in(table_mm).figure(3);
    table.add(known_text<"u of it">()).in(table_mm).uncertainty();
    bool is_floor = false;
    for (std::size_t k = 0; k < setup.series.size(); ++k) {
        const PoseSeries& series = setup.series[k];
        const SeriesFigures& f = figures.series[k];
        table.row({label_of(series), double(series.cycles()), f.ap(series), f.floor_of_ap(series), f.rp,
                   f.best_rp(), f.u_rp()});
        is_floor = is_floor || f.ap(series) < 2.0 * f.floor_of_ap(series);
    }
    if (is_floor)
        table.notes.push_back(
            tell<"Where AP is not twice what the scatter of the cycles alone makes of it, it "
                 "says little about the robot.">());
    return table;
}

Table laws_table(const RobotPosesSetup& setup, const RobotPosesFigures& figures) {
    Table table{"cycles", "What few cycles do to RP"};
    table.add("pose");
    table.add(known_text<"largest s of an axis">()).in(table_mm).uncertainty();
    table.add(known_text<"middle">()).in(table_mm).uncertainty();
    table.add(known_text<"smallest">()).in(table_mm).uncertainty();
    table.add(known_text<"mean RP over that of many cycles">()).figure(3);
    table.add(known_text<"relative u of RP">()).in(table_percent).uncertainty();
    for (std::size_t k = 0; k < setup.series.size(); ++k) {
        const Eigen::Vector3d s = principal_deviations(setup.series[k].points);
        table.row({label_of(setup.series[k]), s[2], s[1], s[0], figures.series[k].law.bias,
                   figures.series[k].law.relative_u});
    }
    return table;
}

/// P(figure of the robot <= rated) and how many cycles would tell.
struct Conformity {
    double figure = 0.0, u = 0.0, rated = 0.0, probability = 0.0;
    double lasting_u = 0.0;  ///< part of u that more cycles do not make smaller
    int cycles = 0;
};

/// Empty: no number that anybody runs.
std::optional<double> deciding_cycles(const Conformity& c, double wanted) {
    const double k = t_quantile(wanted, infinity);
    const double room = std::pow((c.rated - c.figure) / k, 2) - c.lasting_u * c.lasting_u;
    if (!(room > 0.0)) return std::nullopt;
    const double shrinking = c.u * c.u - c.lasting_u * c.lasting_u;
    const double cycles = std::ceil(1.0 + double(c.cycles - 1) * shrinking / room);
    return cycles <= most_cycles ? std::optional(std::max(cycles, 3.0)) : std::nullopt;
}

void add_conformity(Table& table, Message what, const Conformity& c, double wanted) {
    const Decision decision(c.probability, wanted);
    Cell cycles;
    if (!decision.conforms && !decision.fails) {
        if (const auto number = deciding_cycles(c, wanted))
            cycles = Measured(double(*number));
        else
            cycles = tell<"none">();
    }
    table.row({std::move(what), c.figure, c.u, c.rated, c.probability, decision.verdict(),
               decision.conforms ? Cell(1.0 - c.probability)
               : decision.fails  ? Cell(c.probability)
                                 : Cell(),
               std::move(cycles)});
}

/// P(RP_R <= rated), RP_R^2 = RP^2 - RP_I^2, RP above zero: over the law of RP and, cell by cell, over that
/// of RP_I.
double probability_of_robot(const SeenRepeatability& f, const SeenRepeatability& instrument, double rated) {
    const std::vector<double>& edges = instrument.law.quantiles;
    double sum = 0.0;
    for (std::size_t cell = 1; cell < edges.size(); ++cell) {
        const double own = 0.5 * (edges[cell - 1] + edges[cell]) * instrument.rp;
        sum += f.law.probability_below(std::hypot(rated, own) / f.rp);
    }
    return edges.size() < 2 ? f.law.probability_below(rated / f.rp) : sum / double(edges.size() - 1);
}

/// The robot's own repeatability, which a series leaves beside that of the instrument, against the rated one.
Conformity conformity_of_robot(const SeenRepeatability& whole, const SeenRepeatability& instrument,
                               double rated, int cycles) {
    const double rp = std::sqrt(std::pow(whole.best_rp(), 2) - std::pow(instrument.best_rp(), 2));
    const double of_instrument = instrument.best_rp() * instrument.u_rp() / rp;
    return {rp,
            std::hypot(whole.best_rp() * whole.u_rp() / rp, of_instrument),
            rated,
            probability_of_robot(whole, instrument, rated),
            of_instrument,
            cycles};
}

Table conformity_table(const RobotPosesSetup& setup, const RobotPosesFigures& figures) {
    Table table{"conformity", "Conformity with the maker's figures"};
    table.add("figure");
    table.add("value").in(table_mm).figure(3);
    table.add("u").in(table_mm).symbol().uncertainty();
    table.add(known_text<"rated">()).in(table_mm).figure(3);
    table.add(known_text<"probability of conformity">()).in(table_percent).figure(3);
    table.add("decision");
    table.add(known_text<"risk that it is wrong">()).in(table_percent).uncertainty();
    table.add(known_text<"cycles that would decide">());
    for (std::size_t k = 0; k < setup.series.size(); ++k) {
        const PoseSeries& series = setup.series[k];
        const SeriesFigures& f = figures.series[k];
        if (setup.rated_ap) {
            Conformity c{f.ap(series),    std::hypot(f.u_ap(series), setup.u_place),
                         *setup.rated_ap, 0.0,
                         setup.u_place,   series.cycles()};
            const double nu = double(series.cycles() - 1) * std::pow(c.u / f.u_ap(series), 4);
            c.probability = c.u > 0.0 ? t_distribution_function((c.rated - c.figure) / c.u, nu)
                                      : double(c.figure <= c.rated);
            add_conformity(table, tell<"AP of %1">(label_of(series)), c, setup.probability);
        }
        if (!setup.rated_rp) continue;
        if (!figures.instrument) {
            const double probability = f.rp > 0.0 ? f.law.probability_below(*setup.rated_rp / f.rp) : 1.0;
            add_conformity(table, tell<"RP of %1">(label_of(series)),
                           {f.best_rp(), f.u_rp(), *setup.rated_rp, probability, 0.0, series.cycles()},
                           setup.probability);
        } else if (figures.is_split[k]) {
            add_conformity(table, tell<"RP_R of %1">(label_of(series)),
                           conformity_of_robot(f, *figures.instrument, *setup.rated_rp, series.cycles()),
                           setup.probability);
        } else {
            table.row({tell<"RP_R of %1">(label_of(series)), Cell(), Cell(), *setup.rated_rp, Cell(),
                       TestVerdict{TestVerdict::Is::open, tell<"not decided">()}, Cell(), Cell()});
        }
    }
    return table;
}

Table rule_table(const RobotPosesSetup& setup, const RobotPosesFigures& figures) {
    Table table = table_of_tests("instrument-rule", "Is the instrument good enough");
    for (std::size_t k = 0; k < setup.series.size(); ++k) {
        const PoseSeries& series = setup.series[k];
        const SeriesFigures& f = figures.series[k];
        const auto add = [&](Message question, double figure) {
            if (figure > 0.0)
                add_test(table, {.question = std::move(question),
                                 .figure = *setup.expanded_u / figure,
                                 .high = *setup.largest_ratio,
                                 .unit = table_percent});
        };
        add(tell<"U of the instrument over AP of %1">(label_of(series)), f.ap(series));
        add(tell<"U of the instrument over RP of %1">(label_of(series)), f.rp);
    }
    return table;
}

/// AP over all poses, and its quantile with the pose of the sample that bounds it (distribution-free).
Table over_poses_table(const RobotPosesSetup& setup, const RobotPosesFigures& figures) {
    Table table{"over-poses", "AP over the poses"};
    table.add("quantity");
    table.add("value").figure(3);
    std::vector<double> ap;
    for (std::size_t k = 0; k < setup.series.size(); ++k) ap.push_back(figures.series[k].ap(setup.series[k]));
    std::ranges::sort(ap);
    const double n = double(ap.size()), p = setup.probability;
    const auto length = [&](Message what, double si) {
        table.row({std::move(what), Quantity{table_mm.from_si(si), table_mm}});
    };
    table.row({tell<"poses">(), n});
    length(tell<"mean AP">(), std::accumulate(ap.begin(), ap.end(), 0.0) / n);
    length(tell<"largest AP">(), ap.back());
    const double place = p * (n - 1.0);
    const auto below = std::min(std::size_t(place), ap.size() - 1),
               above = std::min(below + 1, ap.size() - 1);
    length(tell<"quantile of AP for the probability of a decision">(),
           ap[below] + (place - double(below)) * (ap[above] - ap[below]));
    if (std::pow(p, n) > 1.0 - p)
        table.notes.push_back(
            tell<"%1 poses are too few to bound this quantile: the largest of %2 poses does, with the same "
                 "probability.">(ap.size(),
                                 static_cast<long long>(std::ceil(std::log(1.0 - p) / std::log(p)))));
    return table;
}

}  // namespace

std::vector<Table> robot_poses_tables(const RobotPosesSetup& setup, const RobotPosesFigures& figures) {
    std::vector<Table> tables{poses_table(setup, figures), laws_table(setup, figures)};
    if (setup.rated_ap || setup.rated_rp) tables.push_back(conformity_table(setup, figures));
    if (setup.expanded_u) tables.push_back(rule_table(setup, figures));
    if (setup.series.size() > 1) tables.push_back(over_poses_table(setup, figures));
    return tables;
}

std::vector<PlotSpecification> robot_poses_plots(const RobotPosesSetup& setup,
                                                 const RobotPosesFigures& figures) {
    PlotSpecification plot;
    plot.id = "accuracy-and-repeatability";
    plot.title = "Accuracy and repeatability of the poses";
    plot.y.title = "AP, RP";
    plot.y.unit = "mm";
    PlotSeries ap{"AP", SeriesKind::points, SeriesRole::family_1, {}, {}, {}, 0.0}, rp = ap;
    rp.name = "RP";
    rp.role = SeriesRole::family_2;
    for (std::size_t k = 0; k < setup.series.size(); ++k) {
        plot.x.categories.push_back(label_of(setup.series[k]));
        ap.x.push_back(double(k));
        rp.x.push_back(double(k));
        ap.y.push_back(table_mm.from_si(figures.series[k].ap(setup.series[k])));
        rp.y.push_back(table_mm.from_si(figures.series[k].rp));
    }
    plot.series = {std::move(ap), std::move(rp)};
    if (setup.rated_ap)
        plot.marks.push_back({"rated AP", table_mm.from_si(*setup.rated_ap), true, SeriesRole::reference});
    if (setup.rated_rp)
        plot.marks.push_back({"rated RP", table_mm.from_si(*setup.rated_rp), true, SeriesRole::reference});
    return {plot};
}

}  // namespace covaria::sheets
