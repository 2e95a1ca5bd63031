// Measurement model "measurement equation": the model class and its descriptor.
#include "core/kinds/equation/model.h"

#include <algorithm>
#include <cmath>

#include "core/equation/evaluate.h"
#include "core/equation/typeset.h"
#include "core/kinds/equation/setup.h"
#include "core/quantity/input_quantity.h"

namespace covaria {

namespace {

using equation::Program;

/// Registers of one thread, kept between blocks: the hot loop allocates nothing.
class Workspace {
public:
    /// Room for at least `count` batches.
    Batch* batches(std::size_t count) {
        if (batches_.size() < count) batches_.resize(count);
        return batches_.data();
    }

private:
    std::vector<Batch, xsimd::aligned_allocator<Batch, 64>> batches_;
};

class EquationsOfUser : public MeasurementModel {
public:
    explicit EquationsOfUser(equation_model::EquationSetup setup) : setup_(std::move(setup)) {
        // A strip's registers should stay in the processor's first cache.
        const std::size_t bytes = std::max<std::size_t>(program().registers, 1) * sizeof(Batch);
        width_ = std::clamp<std::size_t>(cache_bytes / bytes, 1, widest);
    }

    const InputSet& inputs() const override { return setup_.inputs; }
    const std::vector<OutputQuantity>& outputs() const override { return setup_.outputs; }
    Layout layout(std::span<const double>) const override { return {}; }

    std::vector<Table> evaluation() const override {
        return equation_model::observation_tables(setup_.observed);
    }
    std::vector<PlotSpecification> figures() const override {
        return equation_model::observation_figures(setup_.observed);
    }

    std::vector<ModelEquation> formulas() const override {
        std::vector<ModelEquation> all;
        for (Formula& f : equation::formulas(setup_.parsed)) all.push_back({to_unicode(f), {}, std::move(f)});
        return all;
    }

    bool evaluate(std::span<const double> x, std::span<double> y) const override {
        std::vector<double> registers(program().registers);
        put_constants(program(), registers.data(), 1);
        for (const Program::Input& input : program().inputs) at(registers, input.at) = x[input.quantity];
        equation::run(program(), registers.data(), 1);
        bool finite = true;
        for (std::size_t j = 0; j < y.size(); ++j) {
            y[j] = at(registers, program().outputs[j]);
            finite = finite && std::isfinite(y[j]);
        }
        return finite;
    }

    void evaluate_block(const TrialBlock& block) const override {
        thread_local Workspace workspace;
        Batch* registers = workspace.batches(program().registers * width_);
        put_constants(program(), registers, width_);
        const std::size_t strip = width_ * Batch::size;
        for (std::size_t t = 0; t < block.trials; t += strip) run_strip(block, t, registers);
    }

    bool jacobian(std::span<const double> x, Eigen::MatrixXd& jacobian) const override {
        jacobian.resize(static_cast<Eigen::Index>(outputs().size()), static_cast<Eigen::Index>(x.size()));
        std::vector<Dual> registers(program().registers);
        for (std::size_t first = 0; first < x.size(); first += Dual::size) {
            put_constants(program(), registers.data(), 1);
            for (const Program::Input& input : program().inputs) {
                const std::size_t i = input.quantity;
                at(registers, input.at) =
                    i >= first && i < first + Dual::size ? Dual::variable(x[i], i - first) : Dual(x[i]);
            }
            equation::run(program(), registers.data(), 1);
            if (!put_columns(registers, first, jacobian)) return false;
        }
        return true;
    }

private:
    static constexpr std::size_t cache_bytes = 24 * 1024;
    static constexpr std::size_t widest = 16;

    const Program& program() const { return setup_.program; }
    template <class Real>
    static Real& at(std::vector<Real>& registers, int index) {
        return registers[static_cast<std::size_t>(index)];
    }

    /// Trials t ... of a block; the last strip may be shorter: what lies behind the block is not touched.
    void run_strip(const TrialBlock& block, std::size_t t, Batch* registers) const {
        const std::size_t left = (block.trials - t + Batch::size - 1) / Batch::size;
        const std::size_t used = std::min(width_, left);
        const auto load = [&](std::size_t i, std::size_t batch) {
            return Batch::load_aligned(block.inputs + i * block.stride + t +
                                       std::min(batch, used - 1) * Batch::size);
        };
        for (const Program::Input& input : program().inputs)
            for (std::size_t k = 0; k < width_; ++k)
                registers[static_cast<std::size_t>(input.at) * width_ + k] = load(input.quantity, k);
        equation::run(program(), registers, width_);
        for (std::size_t k = 0; k < used; ++k) store(block, t + k * Batch::size, registers + k);
    }

    void store(const TrialBlock& block, std::size_t t, const Batch* registers) const {
        Batch residue(0.0);
        for (std::size_t j = 0; j < program().outputs.size(); ++j) {
            const Batch& y = registers[static_cast<std::size_t>(program().outputs[j]) * width_];
            y.store_aligned(block.outputs + j * block.stride + t);
            residue += y - y;
        }
        bool valid[Batch::size];
        (residue == Batch(0.0)).store_unaligned(valid);
        for (std::size_t lane = 0; lane < Batch::size && t + lane < block.trials; ++lane)
            block.valid[t + lane] = valid[lane] ? 1 : 0;
    }

    bool put_columns(std::vector<Dual>& registers, std::size_t first, Eigen::MatrixXd& jacobian) const {
        bool finite = true;
        for (std::size_t j = 0; j < program().outputs.size(); ++j) {
            const Dual& y = at(registers, program().outputs[j]);
            finite = finite && std::isfinite(y.value());
            for (std::size_t k = 0; k < Dual::size && first + k < std::size_t(jacobian.cols()); ++k) {
                const double partial = y.partials()[k];
                jacobian(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(first + k)) = partial;
                finite = finite && std::isfinite(partial);
            }
        }
        return finite;
    }

    equation_model::EquationSetup setup_;
    std::size_t width_ = 1;
};

/// Error for what has no value at the estimates: the first operation whose result is not a number, or the
/// system it is part of.
equation::TextProblem no_value(const Program& program, std::size_t instruction) {
    for (const equation::NewtonSystem& system : program.systems) {
        if (instruction < system.first || instruction >= system.last) continue;
        equation::Place place = program.places[instruction];
        for (std::size_t i = system.first; i < system.last; ++i)
            if (program.instructions[i].y == system.residuals.front()) place = program.places[i];
        return {place,
                tell<"Newton's method finds no solution of this equation from the starting value, at the "
                     "estimates of the quantities">()};
    }
    return {program.places[instruction],
            tell<"this operation has no value at the estimates of the quantities (division by zero, root or "
                 "logarithm of a negative number, or a number too large)">()};
}

void check_value(const equation_model::EquationSetup& setup, Problems& problems) {
    const Program& program = setup.program;
    std::vector<double> registers(program.registers);
    put_constants(program, registers.data(), 1);
    for (const Program::Input& input : program.inputs)
        registers[static_cast<std::size_t>(input.at)] = estimate_of(setup.inputs, input.quantity);
    equation::run(program, registers.data(), 1);
    const auto is_finite = [&](int r) { return std::isfinite(registers[static_cast<std::size_t>(r)]); };
    if (std::all_of(program.outputs.begin(), program.outputs.end(), is_finite)) return;
    for (std::size_t i = 0; i < program.instructions.size(); ++i)
        if (!is_finite(program.instructions[i].y))
            return equation_model::report({no_value(program, i)}, problems);
}

std::unique_ptr<MeasurementModel> create_equation_model(const SetupReader& reader, const AssetLibrary& assets,
                                                        Problems& problems) {
    auto setup = equation_model::read_equation_setup(reader, assets, problems);
    if (!setup) return nullptr;
    check_value(*setup, problems);
    if (problems.has_errors()) return nullptr;
    return std::make_unique<EquationsOfUser>(std::move(*setup));
}

std::vector<std::string> equation_notes() {
    return {
        "Dimensions are checked where the equations are read; plane angle counts as a number, because the "
        "radian is "
        "one in the SI. A temperature in °C is taken in kelvin only where two make a ratio; a difference of "
        "temperatures is given in K.",
        "Angles that inverse functions give or that were read, their sums and whole multiples are on the "
        "circle where "
        "the result is given in a unit of angle.",
        "Sensitivity coefficients are exact (automatic differentiation); those of unknowns that equations "
        "define "
        "implicitly follow JCGM 102 6.3.",
        "A mean of n observations is drawn from a t distribution with n − 1 degrees of freedom (JCGM 101 "
        "6.4.9). Means "
        "of simultaneous observations are drawn from one multivariate t distribution with these n − 1 "
        "degrees "
        "of freedom; with the n − N of JCGM 102 5.3.2 no mean would keep its own distribution.",
        "JCGM 100 H.1, H.2 and JCGM 101 9.2 to 9.5, JCGM 102 9.2 to 9.4 are examples in projects/gum: "
        "covaria verify "
        "holds them against their published values."};
}

}  // namespace

ModelDescriptor measurement_equation_model() {
    ModelDescriptor d;
    d.id = "measurement-equation";
    d.title = "Measurement equation";
    d.summary =
        "Any measurement equation with what is known about its quantities: several results, intermediate "
        "definitions, conditions, and equations that are solved in every trial.";
    d.references = {{"JCGM 100:2008 (GUM)"}, {"JCGM 101:2008, JCGM 102:2011"}, {"EA-4/02 M:2022"}};
    d.equations = {{"Y = f(X₁, …, X_N)", tell<"JCGM 100, Eq 1">()}, {"h(Y, X₁, …, X_N) = 0", "JCGM 102 6.3"}};
    d.notes = equation_notes();
    d.help_page = "equation.md";
    d.example = "gum/h1-end-gauge.covaria";
    d.schema = equation_model::equation_fields().schema();
    d.create = create_equation_model;
    d.completed = equation_model::with_rows_for_names;
    return d;
}

}  // namespace covaria
