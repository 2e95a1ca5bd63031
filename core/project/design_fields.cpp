#include "core/project/design_fields.h"

#include "core/project/options_json.h"
#include "core/project/study_fields.h"

namespace covaria {

namespace {

using Style = JsonWriter::Style;

/// A seed as a text, because all of its 64 bits count.
struct SeedText {
    void read(ObjectReader& reader, const std::string& key, bool, std::uint64_t& member) const {
        const std::string text = reader.text(key);
        if (const auto number = seed_from(text))
            member = *number;
        else if (!text.empty())
            reader.problems().error(reader.path_of(key),
                                    tell<"'%1' must be %2; it is '%3'">(key, seed_words(), text));
    }
    void write(JsonWriter& out, std::uint64_t member) const { out.text(std::to_string(member)); }
};

OneOf<DesignObjective> objectives() {
    return {{{DesignObjective::largest, "largest"},
             {DesignObjective::mean, "mean"},
             {DesignObjective::root_mean_square, "root-mean-square"},
             {DesignObjective::cost, "cost"}}};
}

OneOf<PriceLaw> price_laws() {
    return {{{PriceLaw::inverse, "inverse"},
             {PriceLaw::repeats, "repeats"},
             {PriceLaw::logarithmic, "logarithmic"}}};
}

}  // namespace

const char* objective_words(DesignObjective objective, bool targets) {
    switch (objective) {
        case DesignObjective::mean:
            return targets ? "mean U/target" : "mean U relative to the present design";
        case DesignObjective::root_mean_square:
            return targets ? "root mean square of U/target"
                           : "root mean square of U relative to the present design";
        case DesignObjective::largest:
        case DesignObjective::cost:
            break;
    }
    return targets ? "largest U/target" : "largest U relative to the present design";
}

const JsonFields<DesignVariable>& variable_fields() {
    static const auto fields = JsonFields<DesignVariable>(tell<"a variable of a design">(), Style::one_line)
                                   .part(&DesignVariable::number, varied_number_fields())
                                   .add("tolerance", &DesignVariable::tolerance);
    return fields;
}

const JsonFields<StudyAxis>& reduced_number_fields() {
    static const auto fields = JsonFields<StudyAxis>(tell<"a number that is reduced">(), Style::one_line)
                                   .add("asset", &StudyAxis::asset)
                                   .required("target", &StudyAxis::target)
                                   .written("least", &StudyAxis::from);
    return fields;
}

const JsonFields<DesignReduction>& reduction_fields() {
    static const auto fields = JsonFields<DesignReduction>(tell<"a reduction of a design">(), Style::one_line)
                                   .part(&DesignReduction::number, reduced_number_fields())
                                   .required("price", &DesignReduction::price)
                                   .add("law", &DesignReduction::law, price_laws());
    return fields;
}

const JsonFields<DesignChoice>& choice_fields() {
    static const auto fields = JsonFields<DesignChoice>(tell<"the choice of a design">(), Style::one_line)
                                   .add("asset", &DesignChoice::asset)
                                   .required("table", &DesignChoice::table)
                                   .required("keep", &DesignChoice::keep)
                                   .add("fixed", &DesignChoice::fixed)
                                   .add("candidates", &DesignChoice::candidates)
                                   .add("prices", &DesignChoice::prices);
    return fields;
}

const JsonFields<DesignBox>& box_fields() {
    static const auto fields = JsonFields<DesignBox>(tell<"a box of a design">(), Style::one_line)
                                   .add("name", &DesignBox::name)
                                   .required("from", &DesignBox::from)
                                   .required("to", &DesignBox::to)
                                   .required("unit", &DesignBox::unit);
    return fields;
}

const JsonFields<Design>& design_fields() {
    static const auto fields = JsonFields<Design>(tell<"a design">())
                                   .required("id", &Design::id)
                                   .add("name", &Design::name)
                                   .add("variables", &Design::variables, ListOf{variable_fields()})
                                   .add("choose", &Design::choose, Optional{ObjectOf{choice_fields()}})
                                   .add("reductions", &Design::reductions, ListOf{reduction_fields()})
                                   .add("outputs", &Design::outputs, ListOf{study_output_fields()})
                                   .add("objective", &Design::objective, objectives())
                                   .add("leastDistance", &Design::least_distance)
                                   .add("keepOut", &Design::keep_out, ListOf{box_fields()})
                                   .add("hiddenBy", &Design::hidden_by, ListOf{box_fields()})
                                   .add("starts", &Design::starts)
                                   .add("seed", &Design::seed, SeedText{})
                                   .add("mostEvaluations", &Design::most_evaluations)
                                   .add("trials", &Design::trials);
    return fields;
}

}  // namespace covaria
