#include "core/equation/evaluate.h"

#include "core/equation/kernels.h"
#include "core/equation/newton.h"

namespace covaria::equation {

double evaluated(Operation operation, double a, double b, double c, double value) {
    double y = 0.0;
    kernel<double>(operation)(&y, &a, &b, &c, value, 1);
    return y;
}

template <class Real>
void run_instructions(const Program& program, std::size_t first, std::size_t last, const Registers<Real>& r) {
    for (std::size_t i = first; i < last; ++i) {
        const Instruction& instruction = program.instructions[i];
        kernel<Real>(instruction.operation)(r.at(instruction.y), r.at(instruction.a), r.at(instruction.b),
                                            r.at(instruction.c), instruction.value, r.width);
    }
}

template <class Real>
void run(const Program& program, Real* registers, std::size_t width) {
    const Registers<Real> r{registers, width};
    for (const Step& step : program.steps) {
        if (step.system < 0) {
            run_instructions(program, step.first, step.last, r);
            continue;
        }
        const NewtonSystem& system = program.systems[static_cast<std::size_t>(step.system)];
        Newton<Real>(system, r).solve([&] { run_instructions(program, system.first, system.last, r); });
    }
}

template void run<double>(const Program&, double*, std::size_t);
template void run<Batch>(const Program&, Batch*, std::size_t);
template void run<Dual>(const Program&, Dual*, std::size_t);

}  // namespace covaria::equation
