#include "core/model/has_layout.h"

namespace covaria {

bool has_layout(const MeasurementModel& model, const InputSet& inputs) {
    std::vector<double> x(inputs.quantities.size());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = estimate_of(inputs, i);
    const Layout layout = model.layout(x);
    return !(layout.frames.empty() && layout.points.empty() && layout.links.empty() &&
             layout.bodies.empty() && layout.vectors.empty());
}

}  // namespace covaria
