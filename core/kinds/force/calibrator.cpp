// A machine that loads a multi-axis force/moment sensor one axis after the other (Kim, Eq. 5).
#include "core/kinds/force/assets.h"
#include "core/kinds/force/axis_fields.h"

namespace covaria {

namespace {

struct CertifiedLoad {
    std::size_t axis = 0;
    double U = 0.0, k = 2.0;
};

struct Certificate {
    std::vector<CertifiedLoad> loads;
};

const Fields<Certificate>& calibrator_fields() {
    static const auto fields =
        Fields<Certificate>()
            .section("Certificate")
            .table(&Certificate::loads, "loads", "Uncertainty of its loads",
                   "One row for each axis that the machine loads: the relative expanded uncertainty of its "
                   "certificate and the coverage factor.",
                   Columns<CertifiedLoad>()
                       .choice(&CertifiedLoad::axis, "axis", "axis", "Force or moment.", axis_choices())
                       .add(&CertifiedLoad::U, "U", "U, relative",
                            "Relative expanded uncertainty of the load: a ratio, not %.",
                            {.unit = Unit::of("1"), .range = {.low = 0.0, .high = 1.0}})
                       .add(&CertifiedLoad::k, "k", "k", "Coverage factor; empty: 2.",
                            {.range = {.low = 0.0, .low_open = true}, .optional = true}),
                   {.min_rows = 1});
    return fields;
}

class ForceCalibrator : public Asset, public ForceCalibratorSource {
public:
    explicit ForceCalibrator(std::array<std::optional<CertifiedLoad>, most_channels> loads) : loads_(loads) {
        offer(*this);
    }

    std::optional<double> relative_uncertainty(std::size_t axis) const override {
        if (!loads_[axis]) return {};
        return loads_[axis]->U / loads_[axis]->k;
    }

    std::vector<Table> evaluation() const override {
        Table table{"loads", "Relative uncertainty of the loads"};
        table.add("axis");
        table.add("U").in(Unit::of("%")).symbol().figure(3);
        table.add("k").symbol().figure(3);
        table.add("u").in(Unit::of("%")).symbol().figure(3);
        for (std::size_t axis = 0; axis < most_channels; ++axis)
            if (loads_[axis])
                table.row({std::string(force_axes[axis].key), loads_[axis]->U, loads_[axis]->k,
                           *relative_uncertainty(axis)});
        return {table};
    }

private:
    std::array<std::optional<CertifiedLoad>, most_channels> loads_;
};

std::unique_ptr<Asset> create_calibrator(const SetupReader& setup, const AssetLibrary& assets,
                                         Problems& problems) {
    const Certificate certificate = calibrator_fields().read(setup, assets, problems);
    std::array<std::optional<CertifiedLoad>, most_channels> loads;
    for (std::size_t row = 0; row < certificate.loads.size(); ++row) {
        const CertifiedLoad& load = certificate.loads[row];
        if (loads[load.axis]) {
            problems.error(calibrator_fields().place(&Certificate::loads, row, &CertifiedLoad::axis),
                           tell<"axis %1 is listed twice">(std::string(force_axes[load.axis].key)));
            return nullptr;
        }
        loads[load.axis] = load;
    }
    return std::make_unique<ForceCalibrator>(loads);
}

}  // namespace

AssetDescriptor force_calibrator_kind() {
    AssetDescriptor d;
    d.kind = "force-calibrator";
    d.title = "Force/moment calibration machine";
    d.category = AssetCategory::instrument;
    d.summary = "Loads a multi-axis force/moment sensor with one force or moment at a time.";
    d.references = {
        {"G.-S. Kim: Uncertainty evaluation of a multi-axis force/moment sensor, International "
         "Journal of the KSPE 3 (3), section 2.2.1"}};
    d.notes = {
        "The uncertainty of a load is common to all readings under loads on that axis: it does not average "
        "out in the calibration matrix."};
    d.capabilities = {ForceCalibratorSource::capability};
    d.schema = calibrator_fields().schema();
    d.create = create_calibrator;
    return d;
}

}  // namespace covaria
