// What a figure from a data sheet means, as a distribution (JCGM 100 4.3).
#include "core/assets/specification.h"

namespace covaria {

namespace {

const std::vector<Choice>& meanings() {
    static const std::vector<Choice> choices{{"standard", "standard uncertainty (normal)"},
                                             {"expanded-k2", "expanded uncertainty, k = 2 (normal)"},
                                             {"limit-rectangular", "limit (MPE), rectangular: divided by √3"},
                                             {"limit-triangular", "limit (MPE), triangular: divided by √6"}};
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
    return Distribution::normal(figure);
}

std::string meaning_words(const std::string& meaning) {
    for (const Choice& choice : meanings())
        if (choice.key == meaning) return choice.title;
    return meaning;
}

}  // namespace covaria
