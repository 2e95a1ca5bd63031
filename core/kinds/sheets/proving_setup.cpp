// Reading of "force-proving instrument": checks, and deflections from indications.
#include "core/kinds/sheets/proving_setup.h"

#include <algorithm>
#include <cmath>

#include "core/text/numbers.h"

namespace covaria::sheets {

namespace {

constexpr std::size_t most_forces = 200;

/// Deflections from indications: less the one without load before the series.
void take_off_unloaded(ProvingSetup& setup) {
    for (const UnloadedReadings& u : setup.unloaded)
        for (ForceStep& step : setup.steps) {
            step.rising[std::size_t(u.series)] -= u.before;
            if (u.series == ProvingSeries::turned && step.falling_3) *step.falling_3 -= u.before;
            if (u.series == ProvingSeries::turned_again && step.falling_5) *step.falling_5 -= u.before;
        }
}

void check_unloaded(const ProvingSetup& setup, Problems& problems) {
    if (setup.unloaded.empty()) return;
    const std::string table = proving_fields().place(&ProvingSetup::unloaded);
    for (std::size_t i = 0; i < proving_series; ++i) {
        const auto rows = std::ranges::count(setup.unloaded, ProvingSeries(i), &UnloadedReadings::series);
        if (rows == 0)
            problems.error(table,
                           tell<"series %1 has no indication without load">(std::string(series_symbols[i])));
        if (rows > 1)
            problems.error(table,
                           tell<"series %1 has two rows without load">(std::string(series_symbols[i])));
    }
}

/// Problems come in the order of the rows.
void check_steps(const ProvingSetup& setup, Problems& problems) {
    const auto& fields = proving_fields();
    for (std::size_t row = 0; row < setup.steps.size(); ++row) {
        const ForceStep& step = setup.steps[row];
        const std::string place = fields.place(&ProvingSetup::steps, row, &ForceStep::force);
        if (std::ranges::count(setup.steps, step.force, &ForceStep::force) > 1)
            problems.error(place, tell<"the force of %1 is there twice: readings of a force are one row">(
                                      setup.label(step)));
        if (!step.machine_U && !setup.machine)
            problems.error(fields.place(&ProvingSetup::steps, row, &ForceStep::machine_U),
                           tell<"nothing says the uncertainty of the force of %1: it needs a calibration "
                                "machine or a U of its own">(setup.label(step)));
    }
    const std::string table = fields.place(&ProvingSetup::steps);
    if (setup.steps.size() > most_forces)
        problems.error(table, tell<"%1 forces are more than the most, %2">(setup.steps.size(), most_forces));
    if (!(setup.degrees_of_freedom() > 0.0))
        problems.error(
            table, tell<"%1 forces leave nothing that would tell how well a polynomial of %2 coefficients "
                        "fits: calibrate more forces or lower the degree">(setup.steps.size(),
                                                                           setup.coefficients()));
    if (!(double(setup.steps.size()) > double(setup.uncertainty_degree)))
        problems.error(fields.place(&ProvingSetup::uncertainty_degree),
                       tell<"%1 forces do not determine a polynomial of degree %2">(
                           setup.steps.size(), setup.uncertainty_degree));
    if (setup.machine && !setup.machine->relative_uncertainty(setup.axis))
        problems.error(fields.place(&ProvingSetup::axis),
                       tell<"'%1' states no uncertainty of %2">(setup.machine.name,
                                                                std::string(force_axes[setup.axis].key)));
    if (setup.creep_30.has_value() != setup.creep_300.has_value())
        problems.error(fields.place(&ProvingSetup::creep_300),
                       tell<"creep needs the indications after 30 s and after 300 s">());
}

/// Deflections grow with the force, in every series.
void check_growth(const ProvingSetup& setup, Problems& problems) {
    const double sign = setup.largest_deflection() < 0.0 ? -1.0 : 1.0;
    for (std::size_t i = 0; i < proving_series; ++i)
        for (std::size_t k = 0; k < setup.steps.size(); ++k) {
            const double before = k == 0 ? 0.0 : setup.steps[k - 1].rising[i];
            if (!(sign * (setup.steps[k].rising[i] - before) > 0.0))
                problems.error(proving_fields().place(&ProvingSetup::steps),
                               tell<"the deflection of series %1 does not grow up to %2: check the "
                                    "indications, and those without load">(std::string(series_symbols[i]),
                                                                           setup.label(setup.steps[k])));
        }
}

/// The largest force is where increasing and decreasing forces meet.
void check_decreasing(const ProvingSetup& setup, Problems& problems) {
    for (std::size_t k = 0; k + 1 < setup.steps.size() && setup.decreasing; ++k)
        if (!setup.steps[k].falling_3 && !setup.steps[k].falling_5)
            problems.error(
                proving_fields().place(&ProvingSetup::decreasing),
                tell<"for use with decreasing forces an indication X4′ or X6′ has to be read at %1">(
                    setup.label(setup.steps[k])));
}

}  // namespace

double ProvingSetup::u_machine(const ForceStep& step) const {
    return step.machine_U ? 0.5 * *step.machine_U : *machine->relative_uncertainty(axis);
}

std::string ProvingSetup::label(const ForceStep& step) const {
    return format_short(force_unit.from_si(step.force), 6) + " " + force_unit.display();
}

std::optional<ProvingSetup> read_proving_setup(const SetupReader& reader, const AssetLibrary& assets,
                                               Problems& problems) {
    const auto& fields = proving_fields();
    ProvingSetup setup = fields.read(reader, assets, problems);
    const FieldSpec& steps = *reader.schema().find(fields.key(&ProvingSetup::steps));
    setup.force_unit = std::get<SetupTable>(value_of(steps, reader.setup())).units.front();
    check_unloaded(setup, problems);
    if (!problems.has_errors()) check_steps(setup, problems);
    if (problems.has_errors()) return std::nullopt;
    std::ranges::sort(setup.steps, {}, &ForceStep::force);
    take_off_unloaded(setup);
    check_growth(setup, problems);
    check_decreasing(setup, problems);
    if (problems.has_errors()) return std::nullopt;
    return setup;
}

}  // namespace covaria::sheets
