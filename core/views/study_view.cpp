#include "core/views/study_view.h"

#include <cmath>

#include "core/result/representation.h"

namespace covaria {

Table study_view(const StudyResult& study, const DocumentLanguage& in) {
    Table table{"study-" + study.id, study.name, study.points.size()};
    for (std::size_t i = 0; i < study.axes.size(); ++i) {
        const StudyAxisValues& axis = study.axes[i];
        table
            .add(axis.title.message().english(),
                 [&study, &axis, i](std::size_t row) -> Cell {
                     return Quantity{axis.values[study.indices_of(row)[i]], axis.unit};
                 })
            .window(axis.title.in(in))
            .typed()
            .in(axis.unit);
    }
    for (const StudyQuantity& quantity : study_quantities(study, in))
        table
            .add(quantity.id,
                 [&study, quantity](std::size_t row) -> Cell {
                     const double si = value_at(study, quantity, row);
                     if (!std::isfinite(si)) return {};
                     return Measured{si, Measured::Scale::interval, quantity.unit};
                 })
            .window(quantity.title)
            .figure(3)
            .in(quantity.unit);
    if (study.failed() > 0 || !not_representing(study).empty())
        table.add("remark", [&study](std::size_t row) -> Cell { return remark_on(study, row); });
    return table;
}

}  // namespace covaria
