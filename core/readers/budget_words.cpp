#include "core/readers/budget_words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <span>
#include <string_view>
#include <utility>

namespace covaria {

namespace {

using Column = BudgetColumn;

constexpr BudgetSymbol known_symbols[] = {{Column::quantity, "Xi"},
                                          {Column::value, "xi"},
                                          {Column::standard, "u"},
                                          {Column::standard, "u(xi)"},
                                          {Column::standard, "ui"},
                                          {Column::standard, "u(Xi)"},
                                          {Column::expanded, "U"},
                                          {Column::expanded, "U(xi)"},
                                          {Column::expanded, "Ui"},
                                          {Column::limits, "±"},
                                          {Column::limits, "+/-"},
                                          {Column::limits, "a"},
                                          {Column::limits, "ai"},
                                          {Column::divisor, "k"},
                                          {Column::divisor, "ki"},
                                          {Column::c, "c"},
                                          {Column::c, "ci"},
                                          {Column::nu, "ν"},
                                          {Column::nu, "νi"},
                                          {Column::nu, "νeff"},
                                          {Column::nu, "nu"},
                                          {Column::nu, "nui"},
                                          {Column::nu, "vi"},
                                          {Column::nu, "veff"},
                                          {Column::nu, "dof"},
                                          {Column::nu, "DoF"},
                                          {Column::nu, "DOF"},
                                          {Column::nu, "df"},
                                          {Column::nu, "nueff"},
                                          {Column::contribution, "ui(y)"},
                                          {Column::contribution, "ciu(xi)"},
                                          {Column::contribution, "ciui"},
                                          {Column::unread, "ui2(y)"},
                                          {Column::unread, "ui²(y)"},
                                          {Column::unread, "%"},
                                          {Column::unread, "#"},
                                          {Column::unread, "(ciu(xi))²"}};

constexpr BudgetWord known_words[] = {
    {Column::quantity, "en", "symbol"},
    {Column::quantity, "en", "quantity", true},
    {Column::quantity, "en", "influence quantity", true},
    {Column::quantity, "de", "größe", true},
    {Column::quantity, "de", "eingangsgröße", true},
    {Column::quantity, "de", "einflussgröße", true},
    {Column::quantity, "de", "messgröße", true},
    {Column::quantity, "de", "formelzeichen"},
    {Column::quantity, "de", "zeichen"},
    {Column::quantity, "fr", "grandeur", true},
    {Column::quantity, "fr", "grandeur d'influence", true},
    {Column::quantity, "fr", "symbole"},
    {Column::quantity, "es", "magnitud", true},
    {Column::quantity, "es", "magnitud de influencia", true},
    {Column::quantity, "es", "símbolo"},
    {Column::quantity, "it", "grandezza", true},
    {Column::quantity, "it", "grandezza d'influenza", true},
    {Column::quantity, "it", "simbolo"},
    {Column::quantity, "pt", "grandeza", true},
    {Column::quantity, "pt", "grandeza de influência", true},
    {Column::name, "en", "source of uncertainty"},
    {Column::name, "en", "uncertainty source"},
    {Column::name, "en", "uncertainty component"},
    {Column::name, "en", "component of uncertainty"},
    {Column::name, "en", "component", true},
    {Column::name, "en", "contributor", true},
    {Column::name, "en", "description", true},
    {Column::name, "en", "designation", true},
    {Column::name, "en", "name", true},
    {Column::name, "de", "bezeichnung", true},
    {Column::name, "de", "benennung", true},
    {Column::name, "de", "beschreibung", true},
    {Column::name, "de", "komponente", true},
    {Column::name, "de", "unsicherheitskomponente"},
    {Column::name, "de", "unsicherheitsquelle"},
    {Column::name, "de", "quelle der unsicherheit"},
    {Column::name, "de", "quelle der messunsicherheit"},
    {Column::name, "de", "einfluss", true},
    {Column::name, "fr", "désignation", true},
    {Column::name, "fr", "composante", true},
    {Column::name, "fr", "composante d'incertitude"},
    {Column::name, "fr", "source d'incertitude"},
    {Column::name, "fr", "nom", true},
    {Column::name, "fr", "libellé", true},
    {Column::name, "es", "descripción", true},
    {Column::name, "es", "denominación", true},
    {Column::name, "es", "componente", true},
    {Column::name, "es", "componente de incertidumbre"},
    {Column::name, "es", "fuente de incertidumbre"},
    {Column::name, "es", "nombre", true},
    {Column::name, "it", "descrizione", true},
    {Column::name, "it", "denominazione", true},
    {Column::name, "it", "componente di incertezza"},
    {Column::name, "it", "fonte di incertezza"},
    {Column::name, "it", "sorgente di incertezza"},
    {Column::name, "it", "causa di incertezza"},
    {Column::name, "it", "nome", true},
    {Column::name, "pt", "descrição", true},
    {Column::name, "pt", "designação", true},
    {Column::name, "pt", "componente de incerteza"},
    {Column::name, "pt", "fonte de incerteza"},
    {Column::value, "en", "estimate"},
    {Column::value, "en", "best estimate"},
    {Column::value, "en", "mean value"},
    {Column::value, "en", "value", true},
    {Column::value, "de", "schätzwert"},
    {Column::value, "de", "messwert"},
    {Column::value, "de", "mittelwert"},
    {Column::value, "de", "wert", true},
    {Column::value, "fr", "estimation"},
    {Column::value, "fr", "valeur estimée"},
    {Column::value, "fr", "valeur", true},
    {Column::value, "es", "estimación"},
    {Column::value, "es", "estimado"},
    {Column::value, "es", "valor estimado"},
    {Column::value, "es", "valor", true},
    {Column::value, "it", "stima"},
    {Column::value, "it", "valore stimato"},
    {Column::value, "it", "valore", true},
    {Column::value, "pt", "estimativa"},
    {Column::value, "pt", "estimação"},
    {Column::unit, "en", "unit"},
    {Column::unit, "en", "unit of measurement"},
    {Column::unit, "de", "einheit"},
    {Column::unit, "de", "maßeinheit"},
    {Column::unit, "fr", "unité"},
    {Column::unit, "fr", "unité de mesure"},
    {Column::unit, "es", "unidad"},
    {Column::unit, "es", "unidades"},
    {Column::unit, "es", "unidad de medida"},
    {Column::unit, "it", "unità"},
    {Column::unit, "it", "unità di misura"},
    {Column::unit, "pt", "unidade"},
    {Column::unit, "pt", "unidade de medida"},
    {Column::standard, "en", "standard uncertainty"},
    {Column::standard, "en", "standard measurement uncertainty"},
    {Column::standard, "en", "std uncertainty"},
    {Column::standard, "en", "std uncert"},
    {Column::standard, "en", "stand uncertainty"},
    {Column::standard, "de", "standardunsicherheit"},
    {Column::standard, "de", "standard unsicherheit"},
    {Column::standard, "de", "standardmessunsicherheit"},
    {Column::standard, "de", "standard messunsicherheit"},
    {Column::standard, "fr", "incertitude type"},
    {Column::standard, "fr", "incertitude standard"},
    {Column::standard, "es", "incertidumbre típica"},
    {Column::standard, "es", "incertidumbre estándar"},
    {Column::standard, "es", "incertidumbre tipo"},
    {Column::standard, "it", "incertezza tipo"},
    {Column::standard, "it", "incertezza standard"},
    {Column::standard, "it", "scarto tipo"},
    {Column::standard, "pt", "incerteza padrão"},
    {Column::standard, "pt", "incerteza típica"},
    {Column::standard, "pt", "incerteza tipo"},
    {Column::expanded, "en", "expanded uncertainty"},
    {Column::expanded, "en", "expanded measurement uncertainty"},
    {Column::expanded, "en", "uncertainty", true},
    {Column::expanded, "en", "measurement uncertainty", true},
    {Column::expanded, "de", "erweiterte unsicherheit"},
    {Column::expanded, "de", "erweiterte messunsicherheit"},
    {Column::expanded, "de", "unsicherheit", true},
    {Column::expanded, "de", "messunsicherheit", true},
    {Column::expanded, "fr", "incertitude élargie"},
    {Column::expanded, "fr", "incertitude", true},
    {Column::expanded, "es", "incertidumbre expandida"},
    {Column::expanded, "es", "incertidumbre", true},
    {Column::expanded, "it", "incertezza estesa"},
    {Column::expanded, "it", "incertezza", true},
    {Column::expanded, "pt", "incerteza expandida"},
    {Column::expanded, "pt", "incerteza", true},
    {Column::limits, "en", "half width"},
    {Column::limits, "en", "halfwidth"},
    {Column::limits, "en", "half range"},
    {Column::limits, "en", "semi range"},
    {Column::limits, "en", "limit"},
    {Column::limits, "en", "limits of error"},
    {Column::limits, "en", "maximum permissible error"},
    {Column::limits, "en", "plus minus"},
    {Column::limits, "de", "halbbreite"},
    {Column::limits, "de", "halbe breite"},
    {Column::limits, "de", "halbweite"},
    {Column::limits, "de", "grenze"},
    {Column::limits, "de", "grenzen"},
    {Column::limits, "de", "fehlergrenze"},
    {Column::limits, "de", "fehlergrenzen"},
    {Column::limits, "de", "grenzabweichung"},
    {Column::limits, "fr", "demi largeur"},
    {Column::limits, "fr", "demi étendue"},
    {Column::limits, "fr", "demi intervalle"},
    {Column::limits, "fr", "limite"},
    {Column::limits, "fr", "erreur maximale tolérée"},
    {Column::limits, "es", "semiamplitud"},
    {Column::limits, "es", "semirrango"},
    {Column::limits, "es", "semiancho"},
    {Column::limits, "es", "límite"},
    {Column::limits, "it", "semiampiezza"},
    {Column::limits, "it", "semilarghezza"},
    {Column::limits, "it", "semintervallo"},
    {Column::limits, "it", "semi intervallo"},
    {Column::limits, "pt", "semiamplitude"},
    {Column::limits, "pt", "semi amplitude"},
    {Column::limits, "pt", "semi intervalo"},
    {Column::limits, "pt", "semilargura"},
    {Column::divisor, "en", "divisor"},
    {Column::divisor, "en", "coverage factor"},
    {Column::divisor, "en", "k factor"},
    {Column::divisor, "en", "k value"},
    {Column::divisor, "de", "teiler"},
    {Column::divisor, "de", "erweiterungsfaktor"},
    {Column::divisor, "de", "überdeckungsfaktor"},
    {Column::divisor, "de", "k faktor"},
    {Column::divisor, "fr", "diviseur"},
    {Column::divisor, "fr", "facteur d'élargissement"},
    {Column::divisor, "fr", "facteur k"},
    {Column::divisor, "es", "factor de cobertura"},
    {Column::divisor, "es", "factor k"},
    {Column::divisor, "it", "divisore"},
    {Column::divisor, "it", "fattore di copertura"},
    {Column::divisor, "it", "fattore k"},
    {Column::divisor, "pt", "fator de abrangência"},
    {Column::divisor, "pt", "factor de expansão"},
    {Column::divisor, "pt", "fator de expansão"},
    {Column::divisor, "pt", "factor de abrangência"},
    {Column::divisor, "pt", "fator k"},
    {Column::distribution, "en", "distribution"},
    {Column::distribution, "en", "probability distribution"},
    {Column::distribution, "en", "prob distribution"},
    {Column::distribution, "en", "prob dist"},
    {Column::distribution, "en", "dist"},
    {Column::distribution, "en", "distr"},
    {Column::distribution, "en", "type of distribution"},
    {Column::distribution, "en", "distribution type"},
    {Column::distribution, "en", "probability density function"},
    {Column::distribution, "en", "pdf"},
    {Column::distribution, "de", "verteilung"},
    {Column::distribution, "de", "wahrscheinlichkeitsverteilung"},
    {Column::distribution, "de", "verteilungsfunktion"},
    {Column::distribution, "de", "verteilungsform"},
    {Column::distribution, "de", "art der verteilung"},
    {Column::distribution, "fr", "loi de probabilité"},
    {Column::distribution, "fr", "loi"},
    {Column::distribution, "fr", "distribution de probabilité"},
    {Column::distribution, "es", "distribución"},
    {Column::distribution, "es", "distribución de probabilidad"},
    {Column::distribution, "es", "tipo de distribución"},
    {Column::distribution, "it", "distribuzione"},
    {Column::distribution, "it", "distribuzione di probabilità"},
    {Column::distribution, "it", "tipo di distribuzione"},
    {Column::distribution, "pt", "distribuição"},
    {Column::distribution, "pt", "distribuição de probabilidade"},
    {Column::distribution, "pt", "tipo de distribuição"},
    {Column::nu, "en", "degree of freedom"},
    {Column::nu, "en", "degrees of freedom"},
    {Column::nu, "de", "freiheitsgrad"},
    {Column::nu, "de", "freiheitsgrade"},
    {Column::nu, "de", "anzahl der freiheitsgrade"},
    {Column::nu, "fr", "degré de liberté"},
    {Column::nu, "fr", "degrés de liberté"},
    {Column::nu, "es", "grado de libertad"},
    {Column::nu, "es", "grados de libertad"},
    {Column::nu, "it", "grado di libertà"},
    {Column::nu, "it", "gradi di libertà"},
    {Column::nu, "pt", "grau de liberdade"},
    {Column::nu, "pt", "graus de liberdade"},
    {Column::c, "en", "sensitivity coefficient"},
    {Column::c, "en", "sensitivity factor"},
    {Column::c, "en", "sensitivity coeff"},
    {Column::c, "en", "sens coeff"},
    {Column::c, "en", "sensitivity"},
    {Column::c, "de", "sensitivitätskoeffizient"},
    {Column::c, "de", "sensitivitätsfaktor"},
    {Column::c, "de", "sensitivität"},
    {Column::c, "de", "sensitivitätskoeff"},
    {Column::c, "de", "empfindlichkeitskoeffizient"},
    {Column::c, "de", "empfindlichkeitsfaktor"},
    {Column::c, "de", "empfindlichkeit"},
    {Column::c, "fr", "coefficient de sensibilité"},
    {Column::c, "fr", "facteur de sensibilité"},
    {Column::c, "fr", "sensibilité"},
    {Column::c, "es", "coeficiente de sensibilidad"},
    {Column::c, "es", "sensibilidad"},
    {Column::c, "it", "coefficiente di sensibilità"},
    {Column::c, "it", "sensibilità"},
    {Column::c, "pt", "coeficiente de sensibilidade"},
    {Column::c, "pt", "sensibilidade"},
    {Column::contribution, "en", "contribution"},
    {Column::contribution, "en", "uncertainty contribution"},
    {Column::contribution, "en", "standard uncertainty contribution"},
    {Column::contribution, "en", "contribution to the standard uncertainty"},
    {Column::contribution, "en", "contribution to the combined standard uncertainty"},
    {Column::contribution, "en", "contribution to the uncertainty"},
    {Column::contribution, "en", "contribution to uncertainty"},
    {Column::contribution, "de", "beitrag"},
    {Column::contribution, "de", "unsicherheitsbeitrag"},
    {Column::contribution, "de", "messunsicherheitsbeitrag"},
    {Column::contribution, "de", "beitrag zur unsicherheit"},
    {Column::contribution, "de", "beitrag zur standardunsicherheit"},
    {Column::contribution, "de", "beitrag zur messunsicherheit"},
    {Column::contribution, "de", "beitrag zur standardmessunsicherheit"},
    {Column::contribution, "fr", "contribution à l'incertitude"},
    {Column::contribution, "fr", "contribution à l'incertitude type"},
    {Column::contribution, "es", "contribución"},
    {Column::contribution, "es", "contribución a la incertidumbre"},
    {Column::contribution, "es", "contribución a la incertidumbre típica"},
    {Column::contribution, "es", "contribución a la incertidumbre estándar"},
    {Column::contribution, "it", "contributo"},
    {Column::contribution, "it", "contributo all'incertezza"},
    {Column::contribution, "it", "contributo all'incertezza tipo"},
    {Column::contribution, "it", "contributo di incertezza"},
    {Column::contribution, "pt", "contribuição"},
    {Column::contribution, "pt", "contribuição para a incerteza"},
    {Column::contribution, "pt", "contribuição para a incerteza padrão"},
    {Column::source, "en", "source"},
    {Column::source, "en", "origin"},
    {Column::source, "en", "remark"},
    {Column::source, "en", "comment"},
    {Column::source, "en", "note"},
    {Column::source, "en", "reference"},
    {Column::source, "de", "quelle"},
    {Column::source, "de", "herkunft"},
    {Column::source, "de", "bemerkung"},
    {Column::source, "de", "bemerkungen"},
    {Column::source, "de", "anmerkung"},
    {Column::source, "de", "kommentar"},
    {Column::source, "de", "nachweis"},
    {Column::source, "fr", "origine"},
    {Column::source, "fr", "remarque"},
    {Column::source, "fr", "commentaire"},
    {Column::source, "es", "fuente"},
    {Column::source, "es", "origen"},
    {Column::source, "es", "observaciones"},
    {Column::source, "es", "comentario"},
    {Column::source, "it", "fonte"},
    {Column::source, "it", "osservazioni"},
    {Column::source, "it", "commento"},
    {Column::source, "pt", "origem"},
    {Column::source, "pt", "observações"},
    {Column::source, "pt", "comentário"},
    {Column::unread, "en", "no"},
    {Column::unread, "en", "item"},
    {Column::unread, "en", "index"},
    {Column::unread, "en", "type"},
    {Column::unread, "en", "type a or b"},
    {Column::unread, "en", "type a b"},
    {Column::unread, "en", "method of evaluation"},
    {Column::unread, "en", "evaluation"},
    {Column::unread, "en", "share"},
    {Column::unread, "en", "percentage"},
    {Column::unread, "en", "percent"},
    {Column::unread, "en", "its square"},
    {Column::unread, "en", "square"},
    {Column::unread, "en", "variance"},
    {Column::unread, "en", "its fourth power over nu"},
    {Column::unread, "de", "nr"},
    {Column::unread, "de", "lfd nr"},
    {Column::unread, "de", "pos"},
    {Column::unread, "de", "typ"},
    {Column::unread, "de", "ermittlungsmethode"},
    {Column::unread, "de", "anteil"},
    {Column::unread, "de", "varianzanteil"},
    {Column::unread, "de", "varianz"},
    {Column::unread, "de", "quadrat"},
    {Column::unread, "fr", "numéro"},
    {Column::unread, "fr", "pourcentage"},
    {Column::unread, "fr", "méthode d'évaluation"},
    {Column::unread, "es", "número"},
    {Column::unread, "es", "porcentaje"},
    {Column::unread, "es", "tipo"},
    {Column::unread, "it", "numero"},
    {Column::unread, "it", "percentuale"},
    {Column::unread, "pt", "porcentagem"},
    {Column::unread, "pt", "percentagem"}};

/// Signs and the plain letters that they are compared as: letters with marks, ligatures, quotation marks,
/// dashes.
constexpr std::array<std::pair<std::string_view, std::string_view>, 14> letters_below{{{"àáâãäåÀÁÂÃÄÅ", "a"},
                                                                                       {"çÇ", "c"},
                                                                                       {"èéêëÈÉÊË", "e"},
                                                                                       {"ìíîïÌÍÎÏ", "i"},
                                                                                       {"ñÑ", "n"},
                                                                                       {"òóôõöøÒÓÔÕÖØ", "o"},
                                                                                       {"ùúûüÙÚÛÜ", "u"},
                                                                                       {"ýÿÝ", "y"},
                                                                                       {"ßẞ", "ss"},
                                                                                       {"æÆ", "a"},
                                                                                       {"œŒ", "o"},
                                                                                       {"ºª°", ""},
                                                                                       {"’‘´`", " "},
                                                                                       {"–—‐‑−", " "}}};

std::size_t letter_length(std::string_view text) {
    const auto first = static_cast<unsigned char>(text.front());
    const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    return std::min(length, text.size());
}

std::string folded_letter(std::string_view letter) {
    if (letter.size() == 1) {
        const auto c = static_cast<unsigned char>(letter.front());
        return std::string(
            1, std::isalnum(c) || c == '%' || c == '#' ? static_cast<char>(std::tolower(c)) : ' ');
    }
    // The marks U+0300 to U+036F stand behind their letter.
    if (letter >= "\xCC\x80" && letter <= "\xCD\xAF") return {};
    for (const auto& [marked, below] : letters_below)
        for (std::string_view rest = marked; !rest.empty(); rest.remove_prefix(letter_length(rest)))
            if (rest.substr(0, letter_length(rest)) == letter) return std::string(below);
    return std::string(letter);
}

/// The word without the second letter of vowels that are written with two: "groesse" is "größe". Both sides
/// of a comparison are treated alike, so that "value" and "valu" do no harm.
std::string without_two_letter_vowels(const std::string& word) {
    std::string plain;
    for (const char c : word)
        if (c != 'e' || plain.empty() || std::string_view("aou").find(plain.back()) == std::string_view::npos)
            plain += c;
    if (plain.size() > 3 && plain.back() == 's') plain.pop_back();
    return plain;
}

/// The symbol without bars, signs of multiplication and the sign of its index: "ciu(xi)" of "|c_i| · u(x_i)".
std::string bare_symbol(const std::string& text) {
    std::string bare;
    for (std::string_view rest = text; !rest.empty(); rest.remove_prefix(letter_length(rest))) {
        const std::string_view letter = rest.substr(0, letter_length(rest));
        if (letter == "ᵢ")
            bare += 'i';
        else if (letter != "·" && letter != "×" && letter != "|" && letter != "_" && letter != "*")
            bare += letter;
    }
    while (!bare.empty() && std::string_view(",:;.").find(bare.back()) != std::string_view::npos)
        bare.pop_back();
    if (bare.size() > 2 && bare.front() == '(' && bare.back() == ')') bare = bare.substr(1, bare.size() - 2);
    return bare;
}

const BudgetSymbol* symbol_in(const std::string& text) {
    const std::string bare = bare_symbol(text);
    const auto found = std::find_if(budget_symbols().begin(), budget_symbols().end(),
                                    [&](const BudgetSymbol& known) { return bare == known.symbol; });
    return found == budget_symbols().end() ? nullptr : &*found;
}

/// Words that do not tell the meaning of a column.
bool is_filler(const std::string& folded) {
    static const std::set<std::string> fillers = [] {
        std::set<std::string> all;
        for (const std::string& word :
             folded_words("of the an for in to per or and at on input each single individual measurement "
                          "der die das des dem den und oder je von zu zum zur für im am "
                          "de du la le les et ou en au aux entrée mesure "
                          "del los las el para por y o e medida medición entrada "
                          "di il lo gli della dello dei delle al all alla ingresso misura "
                          "da do dos das à ao aos medição effective effektiv effektive effektiver "
                          "effectif effectifs efectivos effettivi efetivos eff estimated geschätzt d l a"))
            all.insert(word);
        return all;
    }();
    return fillers.contains(folded);
}

struct FoldedWord {
    const BudgetWord* word;
    std::vector<std::string> parts;
};

/// The known words, longest first: "contribution to the standard uncertainty" before "standard uncertainty".
const std::vector<FoldedWord>& folded_table() {
    static const std::vector<FoldedWord> table = [] {
        std::vector<FoldedWord> all;
        for (const BudgetWord& word : budget_words()) all.push_back({&word, folded_words(word.words)});
        std::stable_sort(all.begin(), all.end(), [](const FoldedWord& a, const FoldedWord& b) {
            return a.parts.size() > b.parts.size();
        });
        return all;
    }();
    return table;
}

struct Found {
    std::set<Column> strong, weak;
};

/// The known word that begins at `at`; null where none does.
const FoldedWord* word_at(const std::vector<std::string>& words, std::size_t at) {
    for (const FoldedWord& known : folded_table())
        if (at + known.parts.size() <= words.size() &&
            std::equal(known.parts.begin(), known.parts.end(),
                       words.begin() + static_cast<std::ptrdiff_t>(at)))
            return &known;
    return nullptr;
}

/// Finds the words of a text; false where one is not known.
bool find_words(const std::string& text, Found& found) {
    const std::vector<std::string> words = folded_words(text);
    // Symbols of one letter count as they were written: "U" is not "u".
    std::string as_written;
    for (const char c : text) as_written += std::isspace(static_cast<unsigned char>(c)) || c == '-' ? ' ' : c;
    std::set<std::string> letters;
    for (std::size_t begin = 0; begin < as_written.size();) {
        const std::size_t end = std::min(as_written.find(' ', begin), as_written.size());
        if (const std::string bare = bare_symbol(as_written.substr(begin, end - begin)); bare.size() == 1)
            letters.insert(bare);
        begin = end + 1;
    }
    for (std::size_t i = 0; i < words.size();) {
        if (const FoldedWord* known = word_at(words, i)) {
            (known->word->weak ? found.weak : found.strong).insert(known->word->column);
            i += known->parts.size();
            continue;
        }
        const std::string& word = words[i++];
        const BudgetSymbol* symbol = nullptr;
        if (word.size() == 1)
            for (const std::string& letter :
                 {word, std::string(1, static_cast<char>(std::toupper(static_cast<unsigned char>(word[0]))))})
                if (letters.contains(letter) && !symbol) symbol = symbol_in(letter);
        if (symbol)
            found.strong.insert(symbol->column);
        else if (!is_filler(word))
            return false;
    }
    return true;
}

/// Finds the words of a head with symbols of several letters among them: "estimate x_i"; false where one is
/// not known.
bool find_words_and_symbols(const std::string& head, Found& found) {
    std::string words;
    for (std::size_t begin = 0; begin < head.size();) {
        const std::size_t end = std::min(head.find(' ', begin), head.size());
        const std::string piece = head.substr(begin, end - begin);
        const BudgetSymbol* symbol = bare_symbol(piece).size() > 1 ? symbol_in(piece) : nullptr;
        if (symbol)
            found.strong.insert(symbol->column);
        else
            words += piece + ' ';
        begin = end + 1;
    }
    return find_words(words, found);
}

}  // namespace

std::vector<std::string> folded_words(const std::string& text) {
    std::string folded;
    for (std::string_view rest = text; !rest.empty(); rest.remove_prefix(letter_length(rest)))
        folded += folded_letter(rest.substr(0, letter_length(rest)));
    std::vector<std::string> words;
    for (std::size_t begin = 0; begin < folded.size();) {
        const std::size_t end = std::min(folded.find(' ', begin), folded.size());
        if (end > begin) words.push_back(without_two_letter_vowels(folded.substr(begin, end - begin)));
        begin = end + 1;
    }
    return words;
}

std::optional<HeadMeaning> meaning_of_head(const std::string& head) {
    if (const BudgetSymbol* whole = symbol_in(head)) return HeadMeaning{whole->column};
    Found found;
    if (!find_words(head, found) && !find_words_and_symbols(head, found = {})) return std::nullopt;
    // A share is headed "Variance contribution" or "contribution %".
    if (found.strong == std::set{Column::contribution, Column::unread}) return HeadMeaning{Column::unread};
    // The unit of the uncertainty alone is not that of the estimate.
    if (found.strong.contains(Column::unit) && found.weak.contains(Column::expanded)) return std::nullopt;
    if (found.strong.size() == 1) return HeadMeaning{*found.strong.begin()};
    if (found.strong.size() > 1) return std::nullopt;
    for (const Column column :
         {Column::name, Column::limits, Column::expanded, Column::value, Column::quantity})
        if (found.weak.contains(column)) return HeadMeaning{column, true};
    return std::nullopt;
}

std::span<const BudgetSymbol> budget_symbols() {
    return known_symbols;
}

std::span<const BudgetWord> budget_words() {
    return known_words;
}

}  // namespace covaria
