#include "core/project/amendment_fields.h"

namespace covaria {

namespace {

JsonFields<ReplacedText> text_fields() {
    return JsonFields<ReplacedText>(tell<"a text of the replaced certificate">(), JsonWriter::Style::one_line)
        .required("field", &ReplacedText::field)
        .required("text", &ReplacedText::text);
}

JsonFields<ReplacedResult> result_fields() {
    using D = ReplacedDecision;
    return JsonFields<ReplacedResult>(tell<"a result of the replaced certificate">(),
                                      JsonWriter::Style::one_line)
        .required("analysis", &ReplacedResult::analysis)
        .add("group", &ReplacedResult::group)
        .required("symbol", &ReplacedResult::symbol)
        .required("estimate", &ReplacedResult::estimate)
        .required("U", &ReplacedResult::expanded_uncertainty)
        .required("unit", &ReplacedResult::unit)
        .add("decision", &ReplacedResult::decision, OneOf<D>{{{D::pass, "pass"}, {D::fail, "fail"}}});
}

}  // namespace

const JsonFields<Amendment>& amendment_fields() {
    static const auto fields = JsonFields<Amendment>(tell<"what the replaced certificate stated">())
                                   .add("texts", &Amendment::texts, ListOf{text_fields()})
                                   .add("results", &Amendment::results, ListOf{result_fields()});
    return fields;
}

}  // namespace covaria
