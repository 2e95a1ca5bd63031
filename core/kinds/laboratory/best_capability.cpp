// Calibration and measurement capabilities (CMC) of one quantity, by ranges: no certificate of the laboratory
// may state a smaller expanded uncertainty (ILAC-P14).
#include "core/model/best_capability.h"

#include <algorithm>
#include <cmath>

#include "core/kinds/laboratory/assets.h"
#include "core/setup/fields.h"

namespace covaria {

namespace {

/// A range, in the unit of the quantity that decides; the fixed part of U is in the unit of the results.
struct StatedRange {
    double from = 0.0, to = 0.0;
    double absolute = 0.0, relative = 0.0;
};

struct StatedCapability {
    std::string symbols, over;
    Unit unit, unit_of_range;
    std::vector<StatedRange> ranges;
    bool in_quadrature = false, raises = true;
};

Columns<StatedRange> range_columns() {
    return Columns<StatedRange>()
        .add(&StatedRange::from, "from", "from", "Smallest value of the range, in the unit of the range.")
        .add(&StatedRange::to, "to", "to", "Largest value of the range; it belongs to it.")
        .add(&StatedRange::absolute, "absolute", "U, fixed part",
             "The part of U that does not depend on the value (a of a + b L), in the unit of the results.",
             {.range = {.low = 0.0}})
        .add(&StatedRange::relative, "relative", "U, relative part",
             "The part of U in proportion to the value (b of a + b L): 0.5e-6 is 0.5 um in a metre.",
             {.range = {.low = 0.0}, .default_value = Quantity{0.0, Unit{}}});
}

const Fields<StatedCapability>& capability_fields() {
    using S = StatedCapability;
    static const auto fields = [] {
        Fields<S> made;
        made.section("Results")
            .add(&S::unit, "unit", "Unit", "Of the results that it is for, and of the fixed part of U.",
                 {.default_value = std::string("mm")})
            .add(&S::symbols, "symbols", "Symbols",
                 "Of the results that it is for, with blanks between; empty: all results of that kind of "
                 "unit.",
                 {.default_value = std::string()})
            .section("Ranges")
            .add(&S::over, "over", "Value of",
                 "Symbol of the quantity that the ranges and the relative part refer to, as that of the "
                 "nominal length where the result is a deviation; empty: the result itself.",
                 {.default_value = std::string()})
            .add(&S::unit_of_range, "range_unit", "Unit of the range", "In which the ranges are given.",
                 {.default_value = std::string("mm")})
            .table(&S::ranges, "ranges", "Ranges",
                   "Expanded uncertainties (k = 2) that the accreditation states, by ranges; the first range "
                   "that has the value counts.",
                   range_columns(), {.min_rows = 1})
            .choice(&S::in_quadrature, "parts", "Parts of U", "Fixed and relative part of U.",
                    {{false, "sum", "are added: a + b L"}, {true, "root", "in quadrature: Q[a; b L]"}}, false)
            .section("Smaller U")
            .choice(&S::raises, "below", "A smaller U",
                    "What certificates state where the evaluated U is smaller.",
                    {{true, "raised", "is raised to it"}, {false, "refused", "is not stated"}}, true);
        return made;
    }();
    return fields;
}

class StatedBestCapability : public Asset, public BestCapability {
public:
    explicit StatedBestCapability(StatedCapability stated) : stated_(std::move(stated)) { offer(*this); }

    bool is_about(const OutputQuantity& output) const override {
        if (output.unit.dimension() != stated_.unit.dimension()) return false;
        if (stated_.symbols.find_first_not_of(' ') == std::string::npos) return true;
        return (' ' + stated_.symbols + ' ').find(' ' + output.symbol + ' ') != std::string::npos;
    }
    const std::string& over() const override { return stated_.over; }
    bool raises() const override { return stated_.raises; }

    std::optional<double> smallest(double value) const override {
        const double size = stated_.unit_of_range.from_si(value);
        const auto range = std::ranges::find_if(
            stated_.ranges, [&](const StatedRange& one) { return one.from <= size && size <= one.to; });
        if (range == stated_.ranges.end()) return std::nullopt;
        const double fixed = stated_.unit.interval_to_si(range->absolute);
        const double relative = range->relative * stated_.unit_of_range.interval_to_si(std::abs(size));
        return stated_.in_quadrature ? std::hypot(fixed, relative) : fixed + relative;
    }

private:
    StatedCapability stated_;
};

std::unique_ptr<Asset> create_capability(const SetupReader& setup, const AssetLibrary& assets,
                                         Problems& problems) {
    const auto& fields = capability_fields();
    StatedCapability stated = fields.read(setup, assets, problems);
    for (std::size_t row = 0; row < stated.ranges.size(); ++row) {
        const StatedRange& range = stated.ranges[row];
        if (range.from > range.to)
            problems.error(fields.place(&StatedCapability::ranges, row, &StatedRange::to),
                           tell<"the range ends below its beginning">());
        if (range.absolute == 0.0 && range.relative == 0.0)
            problems.error(fields.place(&StatedCapability::ranges, row, &StatedRange::absolute),
                           tell<"the range has no U">());
        if (range.relative != 0.0 && stated.unit.dimension() != stated.unit_of_range.dimension())
            problems.error(
                fields.place(&StatedCapability::ranges, row, &StatedRange::relative),
                tell<"a relative part of U needs ranges of the same kind of unit as the results">());
    }
    if (problems.has_errors()) return nullptr;
    return std::make_unique<StatedBestCapability>(std::move(stated));
}

}  // namespace

AssetDescriptor best_capability_kind() {
    AssetDescriptor d;
    d.kind = "best-capability";
    d.title = "Best measurement capability";
    d.category = AssetCategory::laboratory;
    d.summary =
        "The smallest expanded uncertainties that a laboratory may state for a quantity (CMC), by ranges of "
        "its value. Certificates never state a smaller one.";
    d.references = {{"ILAC-P14:09/2020, Policy for measurement uncertainty in calibration"}};
    d.notes = {
        "It is for U of about 95 %. No evaluation depends on it: results and reports state what was "
        "evaluated, certificates what may be stated.",
        "A result for which the laboratory has no capability is outside its scope: certificates say "
        "so, and \"covaria check\" ends with status 3."};
    d.capabilities = {BestCapability::capability};
    d.schema = capability_fields().schema();
    d.create = create_capability;
    return d;
}

}  // namespace covaria
