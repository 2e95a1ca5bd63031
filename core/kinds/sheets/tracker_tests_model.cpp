// Measurement model "two-face and length tests of a tracker": the model class and its descriptor.
#include "core/kinds/sheets/tracker_tests_model.h"

#include "core/kinds/sheets/tracker_tests_setup.h"
#include "core/model/equation_model.h"

namespace covaria {

namespace {

using sheets::TrackerTest;
using sheets::TrackerTestKind;
using sheets::TrackerTestsSetup;

const std::vector<ModelEquation>& tracker_tests_equations() {
    static const std::vector<ModelEquation> all{
        {"E_i = d_i", tell<"two-face: distance of both readings across the beam">()},
        {"E_i = L_i − (1 + a) L_ref,i", tell<"length; a: scale of the references">()},
        {"P(|E_i| ≤ MPE_i) ≥ p", tell<"decision, ISO 14253-1">()}};
    return all;
}

class TrackerTests : public EquationModel<TrackerTests> {
public:
    explicit TrackerTests(TrackerTestsSetup setup) : setup_(std::move(setup)) {
        for (std::size_t i = 0; i < setup_.tests.size(); ++i) add_test(i);
        inputs_.add({.symbol = "a",
                     .name = tell<"scale of the reference lengths">(),
                     .unit = Unit::of("ppm"),
                     .group = own_name<"references">()},
                    {of_test("a.stated", Unit::of("ppm"), setup_.u_reference_scale)});
    }

    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    std::vector<Table> evaluation() const override { return sheets::tracker_tests_tables(setup_); }

    Layout layout(std::span<const double>) const override {
        Layout layout;
        const Name tracker = own_name<"tracker">();
        layout.bodies.push_back({.name = tracker, .kind = BodyKind::instrument, .glyph = "tracker"});
        for (const TrackerTest& t : setup_.tests) {
            layout.points.push_back({.name = t.position, .kind = PointKind::target, .p_W = t.place()});
            layout.links.push_back(
                {t.position, LinkKind::sight_line, Eigen::Vector3d::Zero(), t.place(), {}});
        }
        return layout;
    }

    template <class Real>
    mask_of<Real> equations(const Inputs<Real>& x, Outputs<Real>& y) const {
        const Real scale = x[setup_.tests.size()];
        for (std::size_t i = 0; i < setup_.tests.size(); ++i) {
            const TrackerTest& t = setup_.tests[i];
            const Real error = x[i];
            if (t.kind == TrackerTestKind::two_face)
                y.set(i, error);
            else
                y.set(i, error - (Real(1.0) + scale) * Real(t.reference));
        }
        return Real(0.0) == Real(0.0);
    }

private:
    static UncertaintyComponent of_test(std::string id, const Unit& unit, double u) {
        UncertaintyComponent component;
        component.id = std::move(id);
        component.name = tell<"uncertainty of the test">();
        component.unit = unit;
        component.distribution = Distribution::normal(u);
        component.origin = tell<"uncertainty of the test values">();
        return component;
    }

    void add_test(std::size_t i) {
        const TrackerTest& t = setup_.tests[i];
        const bool is_length = t.kind == TrackerTestKind::length;
        const std::string number = std::to_string(i + 1), symbol = (is_length ? "L_" : "d_") + number;
        const Name group = is_length ? own_name<"lengths">() : own_name<"two-face">();
        inputs_.add({.symbol = symbol,
                     .name = is_length ? tell<"measured length at position %1">(t.position)
                                       : tell<"distance of both faces at position %1">(t.position),
                     .unit = Unit::of("mm"),
                     .offset = t.value,
                     .group = group,
                     .source = sheets::tracker_tests_fields().place(&TrackerTestsSetup::tests, i,
                                                                    &TrackerTest::value)},
                    {of_test(symbol + ".test", Unit::of("um"), setup_.u_own(t))});
        outputs_.push_back({.symbol = "E_" + number,
                            .name = tell<"error at position %1">(t.position),
                            .unit = Unit::of("um"),
                            .group = group});
    }

    TrackerTestsSetup setup_;
    InputSet inputs_;
    std::vector<OutputQuantity> outputs_;
};

std::unique_ptr<MeasurementModel> create_tracker_tests(const SetupReader& reader, const AssetLibrary& assets,
                                                       Problems& problems) {
    auto setup = sheets::read_tracker_tests_setup(reader, assets, problems);
    if (!setup) return nullptr;
    return std::make_unique<TrackerTests>(std::move(*setup));
}

}  // namespace

ModelDescriptor tracker_tests_model() {
    ModelDescriptor d;
    d.id = "tracker-tests";
    d.title = "Two-face and length tests of a tracker";
    d.summary =
        "Errors of a laser tracker at the positions of its acceptance test, with the uncertainty of the "
        "test, "
        "and the decision whether they are within the maximum permissible errors.";
    d.references = {{"ISO 10360-10:2021"}, {"ASME B89.4.19"}, {"ISO 14253-1:2017"}};
    d.equations = tracker_tests_equations();
    d.notes = {
        "Positions, numbers of repetitions and limits are those that are entered: none of a standard is "
        "built "
        "in.",
        "The uncertainty of a test value is what the test adds, not the scatter of the tracker: that is what "
        "is tested."};
    d.help_page = "tracker-tests.md";
    d.example = "tracker-test.covaria";
    d.decides = true;
    d.schema = sheets::tracker_tests_fields().schema();
    d.create = create_tracker_tests;
    return d;
}

}  // namespace covaria
