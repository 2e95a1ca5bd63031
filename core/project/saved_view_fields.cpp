#include "core/project/saved_view_fields.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/base/in_quotes.h"

namespace covaria {
namespace {

/// Reads the unit of centre, width and height, which stand before it; they are written in m.
void read_length_unit(ObjectReader& reader, const std::string& key, SavedView& view) {
    Unit unit = Unit::of("m");
    JsonValue<Unit>::read(reader, key, true, unit);
    if (unit.dimension() != Unit::of("m").dimension())
        return reader.problems().error(
            reader.path_of(key), tell<"a unit of length is needed here, not %1">(in_quotes(unit.text())));
    for (double& x : view.centre) x = unit.interval_to_si(x);
    view.width = unit.interval_to_si(view.width);
    view.height = unit.interval_to_si(view.height);
}

void check(const SavedView& view, const std::string& path, Problems& problems) {
    const auto place = [&](auto member) { return path + saved_view_fields().place(member); };
    for (const auto size : {&SavedView::width, &SavedView::height})
        if (!(view.*size > 0.0))
            problems.error(place(size), tell<"the size of a view must be greater than zero">());
    const Eigen::Map<const Eigen::Vector3d> direction(view.direction.data()), up(view.up.data());
    if (!(direction.cross(up).norm() > 1e-6 * direction.norm() * up.norm()))
        problems.error(place(&SavedView::up),
                       tell<"'direction' and 'up' must be two different directions, not of length zero">());
}

}  // namespace

const JsonFields<SavedView>& saved_view_fields() {
    static const auto fields = JsonFields<SavedView>(tell<"a view">())
                                   .required("name", &SavedView::name)
                                   .required("direction", &SavedView::direction)
                                   .required("up", &SavedView::up)
                                   .required("centre", &SavedView::centre)
                                   .required("width", &SavedView::width)
                                   .required("height", &SavedView::height)
                                   .by_hand("lengthUnit", &SavedView::width, read_length_unit,
                                            [](JsonWriter& out, const SavedView&) { out.text("m"); })
                                   .add("perspective", &SavedView::perspective)
                                   .add("hidden", &SavedView::hidden)
                                   .add("only", &SavedView::only);
    return fields;
}

void SavedViewList::read(ObjectReader& reader, const std::string& key, bool required,
                         std::vector<SavedView>& member) const {
    const std::size_t before = reader.problems().items().size();
    ListOf{saved_view_fields()}.read(reader, key, required, member);
    if (reader.problems().items().size() > before) return;
    const auto& taken = standard_view_names();
    for (std::size_t i = 0; i < member.size(); ++i) {
        const std::string path = reader.path_of(key) + "/" + std::to_string(i), &name = member[i].name;
        check(member[i], path, reader.problems());
        if (std::ranges::find(taken, name) != taken.end())
            reader.problems().error(path + saved_view_fields().place(&SavedView::name),
                                    tell<"%1 is the name of a standard view">(in_quotes(name)));
        else if (find_view(member, name) != &member[i])
            reader.problems().error(path + saved_view_fields().place(&SavedView::name),
                                    tell<"the name %1 is used twice">(in_quotes(name)));
    }
}

void SavedViewList::write(JsonWriter& out, const std::vector<SavedView>& member) const {
    ListOf{saved_view_fields()}.write(out, member);
}

}  // namespace covaria
