// Distribution that a figure from a data sheet stands for (JCGM 100 4.3).
#include "core/kinds/points/stated_figure.h"

#include <cmath>

namespace covaria {

namespace {

const std::vector<Choice>& meanings() {
    static const std::vector<Choice> choices{{"standard", "standard uncertainty (normal)"},
                                             {"expanded-k2", "expanded uncertainty, k = 2 (normal)"},
                                             {"limit-rectangular", "limit (MPE), rectangular: divided by √3"},
                                             {"limit-triangular", "limit (MPE), triangular: divided by √6"},
                                             {"limit-arcsine", "limit (MPE), arc sine: divided by √2"}};
    return choices;
}

const std::vector<Choice>& shapes() {
    static const std::vector<Choice> choices{{"normal", "normal"},
                                             {"rectangular", "rectangular: limits ± √3 u"},
                                             {"triangular", "triangular: limits ± √6 u"},
                                             {"arcsine", "arc sine: limits ± √2 u"}};
    return choices;
}

}  // namespace

FieldSpec meaning_field(const std::string& section) {
    return {.key = "meaning",
            .title = "The figures are",
            .kind = FieldKind::choice,
            .help =
                "What the data sheet states: a standard uncertainty, an expanded one, or a limit that is not "
                "exceeded (maximum permissible error).",
            .default_value = std::string("standard"),
            .choices = meanings(),
            .section = section};
}

Distribution specified_distribution(const std::string& meaning, double figure) {
    if (meaning == "expanded-k2") return Distribution::normal(figure / 2.0);
    if (meaning == "limit-rectangular") return Distribution::of(Rectangular{-figure, figure});
    if (meaning == "limit-triangular") return Distribution::of(Triangular{-figure, figure});
    if (meaning == "limit-arcsine") return Distribution::of(Arcsine{-figure, figure});
    return Distribution::normal(figure);
}

Message meaning_words(const std::string& meaning) {
    for (const Choice& choice : meanings())
        if (choice.key == meaning) return Message::declared(choice.title);
    return meaning;
}

FieldSpec distribution_field(const std::string& key, const std::string& of_what, const std::string& section) {
    return {.key = key,
            .title = "Their distribution",
            .kind = FieldKind::choice,
            .help = "The distribution of " + of_what +
                    "; what is stated is its standard uncertainty, whatever the shape.",
            .default_value = std::string("normal"),
            .choices = shapes(),
            .section = section};
}

ColumnSpec distribution_column() {
    return {.key = "distribution",
            .title = "distribution",
            .kind = FieldKind::choice,
            .optional = true,
            .choices = shapes(),
            .help = "The distribution that has the standard uncertainty u; empty: normal."};
}

Distribution distribution_of_shape(const std::string& shape, double u) {
    if (shape == "rectangular") return specified_distribution("limit-rectangular", std::sqrt(3.0) * u);
    if (shape == "triangular") return specified_distribution("limit-triangular", std::sqrt(6.0) * u);
    if (shape == "arcsine") return specified_distribution("limit-arcsine", std::sqrt(2.0) * u);
    return Distribution::normal(u);
}

}  // namespace covaria
