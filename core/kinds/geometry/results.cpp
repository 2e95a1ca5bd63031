#include "core/kinds/geometry/results.h"

#include "core/base/name.h"

namespace covaria::geometry {

namespace {

Message words_of_place(const Feature& feature, const char* axis) {
    switch (feature.form()) {
        case Form::circle:
        case Form::circle_2d:
        case Form::sphere:
            return tell<"centre of %1, %2">(feature.name, axis);
        case Form::cylinder:
        case Form::cone:
            return tell<"point on the axis of %1, %2">(feature.name, axis);
        case Form::point:
            return tell<"place of %1, %2">(feature.name, axis);
        default:
            return tell<"point on %1, %2">(feature.name, axis);
    }
}

Message words_of_direction(const Feature& feature, const char* axis) {
    switch (feature.form()) {
        case Form::plane:
        case Form::circle:
            return tell<"normal of %1, %2">(feature.name, axis);
        case Form::cylinder:
        case Form::cone:
            return tell<"direction of the axis of %1, %2">(feature.name, axis);
        default:
            return tell<"direction of %1, %2">(feature.name, axis);
    }
}

/// Peak to valley by what drawings call it.
Message words_of_form(const Feature& feature) {
    switch (feature.form()) {
        case Form::plane:
            return tell<"flatness deviation of %1, peak to valley">(feature.name);
        case Form::line:
        case Form::line_2d:
            return tell<"straightness deviation of %1, peak to valley">(feature.name);
        case Form::circle:
        case Form::circle_2d:
            return tell<"roundness deviation of %1, peak to valley">(feature.name);
        case Form::cylinder:
            return tell<"cylindricity deviation of %1, peak to valley">(feature.name);
        default:
            return tell<"form deviation of %1, peak to valley">(feature.name);
    }
}

}  // namespace

std::vector<OutputQuantity> outputs_of(const Feature& feature) {
    const Unit mm = Unit::of("mm");
    const FormFacts facts = facts_of(feature.form());
    std::vector<OutputQuantity> outputs;
    const auto add = [&](const char* symbol, Message name, const Unit& unit, const Name& group) {
        outputs.push_back({.symbol = symbol, .name = std::move(name), .unit = unit, .group = group});
    };
    static constexpr const char* directions[] = {"n_x", "n_y", "n_z"};
    for (std::size_t c = 0; c < feature.coordinates(); ++c)
        add(along_axes[c], words_of_place(feature, along_axes[c]), mm, feature.name);
    for (std::size_t c = 0; facts.has_direction && c < feature.coordinates(); ++c)
        add(directions[c], words_of_direction(feature, along_axes[c]), {}, feature.name);
    if (facts.has_diameter)
        add("d",
            feature.form() == Form::cone ? tell<"diameter of %1 at its point">(feature.name)
                                         : tell<"diameter of %1">(feature.name),
            mm, feature.name);
    if (feature.form() == Form::cone)
        add("alpha", tell<"angle of %1">(feature.name), Unit::of("deg"), feature.name);
    if (feature.has_form) {
        add("f_t", words_of_form(feature), mm, feature.name);
        add("f_q", tell<"form deviation of %1, root mean square">(feature.name), mm, feature.name);
    }
    if (feature.form() == Form::cone)
        for (const char* axis : along_axes)
            add(axis, tell<"apex of %1, %2">(feature.name, axis), mm, own_name<"apex of %1">(feature.name));
    return outputs;
}

}  // namespace covaria::geometry
