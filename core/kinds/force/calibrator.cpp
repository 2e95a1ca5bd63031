// A machine that loads a multi-axis force/moment sensor one axis after the other (Kim, Eq. 5).
#include "core/kinds/force/assets.h"
#include "core/kinds/force/force_sensor.h"

namespace covaria {

namespace {

std::vector<Choice> axis_choices() {
    std::vector<Choice> choices;
    for (const ForceAxis& axis : force_axes) choices.push_back({axis.key, axis.key});
    return choices;
}

SetupSchema calibrator_schema() {
    FieldSpec table{.key = "loads",
                    .title = "Uncertainty of its loads",
                    .kind = FieldKind::table,
                    .help =
                        "One row for each axis that the machine loads: the relative expanded uncertainty of "
                        "its certificate and the coverage factor.",
                    .min_rows = 1,
                    .section = "Certificate"};
    table.columns = {{.key = "axis",
                      .title = "axis",
                      .kind = FieldKind::choice,
                      .choices = axis_choices(),
                      .help = "Force or moment."},
                     {.key = "U",
                      .title = "U",
                      .unit = Unit::of("1"),
                      .range = {.low = 0.0, .high = 1.0},
                      .help = "Relative expanded uncertainty of the load: a ratio, not %."},
                     {.key = "k",
                      .title = "k",
                      .range = {.low = 0.0, .low_open = true},
                      .optional = true,
                      .help = "Coverage factor; empty: 2."}};
    return SetupSchema({table});
}

struct CertifiedLoad {
    double U = 0.0, k = 2.0;
};

class ForceCalibrator : public Asset, public ForceCalibratorSource {
public:
    explicit ForceCalibrator(std::array<std::optional<CertifiedLoad>, most_channels> loads) : loads_(loads) {
        offer(*this);
    }

    std::optional<double> relative_uncertainty(std::size_t axis) const override {
        if (!loads_[axis]) return {};
        return loads_[axis]->U / loads_[axis]->k;
    }

    std::vector<DataTable> evaluation() const override {
        DataTable table;
        table.id = "loads";
        table.title = "Relative uncertainty of the loads";
        table.columns = {{.header = "axis"},
                         {.header = "U", .is_symbol = true, .digits = 3},
                         {.header = "k", .is_symbol = true, .digits = 3},
                         {.header = "u", .unit = Unit::of("%"), .is_symbol = true, .digits = 3}};
        for (std::size_t axis = 0; axis < most_channels; ++axis)
            if (loads_[axis])
                table.rows.push_back({std::string(force_axes[axis].key), loads_[axis]->U, loads_[axis]->k,
                                      *relative_uncertainty(axis)});
        return {table};
    }

private:
    std::array<std::optional<CertifiedLoad>, most_channels> loads_;
};

std::unique_ptr<Asset> create_calibrator(const SetupReader& setup, const AssetLibrary&, Problems& problems) {
    std::array<std::optional<CertifiedLoad>, most_channels> loads;
    for (std::size_t row = 0; row < setup.rows("loads"); ++row) {
        const std::size_t axis = axis_index(setup.cell_text("loads", row, "axis"));
        if (loads[axis]) {
            problems.error("/loads/rows/" + std::to_string(row) + "/axis",
                           "axis " + std::string(force_axes[axis].key) + " is listed twice");
            return nullptr;
        }
        loads[axis] =
            CertifiedLoad{setup.cell_number("loads", row, "U"),
                          setup.cell_empty("loads", row, "k") ? 2.0 : setup.cell_number("loads", row, "k")};
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
    d.schema = calibrator_schema();
    d.create = create_calibrator;
    return d;
}

}  // namespace covaria
