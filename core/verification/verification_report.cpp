// The table of a verification, as a report and as text.
#include <algorithm>
#include <cmath>

#include "core/base/version.h"
#include "core/report/report_parts.h"
#include "core/report/table_builder.h"
#include "core/text/numbers.h"
#include "core/text/symbol.h"
#include "core/verification/verification.h"
#include "core/views/result_words.h"

namespace covaria {
namespace {

/// Number with as many digits as the tolerance of the reference or the last printed digit of the published
/// value gives a meaning, and one more.
std::string figure_text(double value, double resolution) {
    if (!std::isfinite(value)) return std::isnan(value) ? "none" : "infinite";
    const double magnitude = std::max(std::abs(value), 1e-300);
    constexpr int most_digits = 16;  // of what is compared to the last digits of a double
    int digits = 9;
    if (resolution > 0.0) digits = static_cast<int>(std::ceil(std::log10(magnitude / resolution))) + 1;
    return format_short(value, std::clamp(digits, 2, most_digits));
}

std::string published_text(const VerificationCheck& check) {
    if (!check.published) return "";
    if (check.half_digit <= 0.0) return figure_text(*check.published, 0.0);
    const int decimals = std::max(0, static_cast<int>(std::lround(-std::log10(2.0 * check.half_digit))));
    return format_decimals(*check.published, decimals);
}

std::string reference_text(const CheckedFigure& f) {
    return f.check.reference ? figure_text(*f.check.reference, f.tolerance) : "";
}

std::string value_text(const CheckedFigure& f) {
    return figure_text(f.value, f.tolerance > 0.0 ? f.tolerance : 0.1 * f.check.half_digit);
}

std::string status_text(const CheckedFigure& f) {
    if (!f.passed())
        return !f.agrees_with_reference  ? "FAILS: differs from the reference"
               : !f.reproduces_published ? "FAILS: differs from the published value"
                                         : "FAILS: is the figure of an evaluation that " + f.check.naive->how;
    if (f.check.naive)
        return "agrees; " + figure_text(f.check.naive->value, 0.0) + " is what one gives that " +
               f.check.naive->how;
    if (!f.check.published) return "agrees";
    return f.reproduces_published ? "reproduces" : "differs, because " + f.check.because;
}

std::string unit_of(const VerificationCheck& check) {
    return check.unit == Unit{} ? "" : check.unit.display();
}

std::string summary(const std::vector<CheckedCase>& cases) {
    std::size_t total = 0, passed = 0;
    for (const CheckedCase& c : cases)
        for (const CheckedFigure& f : c.figures) ++total, passed += f.passed() ? 1 : 0;
    return std::to_string(passed) + " of " + std::to_string(total) + " figures of " +
           std::to_string(cases.size()) + " cases are as they should be.";
}

}  // namespace

TableBlock verification_table(const CheckedCase& c) {
    report_parts::TableBuilder table("verification-" + result_words::id_part(c.of.title),
                                     c.of.title + " (" + c.of.source + ")");
    for (const char* head : {"Figure", "Unit", "Published", "Reference", "Covaria", "κ", "Pass rule",
                             "Allowed deviation", "Status"})
        table.text(head);
    for (const CheckedFigure& f : c.figures)
        table.row({f.check.what, unit_of(f.check), published_text(f.check), reference_text(f), value_text(f),
                   f.check.condition > 0.0 ? figure_text(f.check.condition, 0.1 * f.check.condition)
                                           : std::string(),
                   pass_rule(f), f.tolerance > 0.0 ? figure_text(f.tolerance, f.tolerance) : std::string(),
                   status_text(f)});
    table.note("Project: " + c.of.project + ".");
    return table.take();
}

namespace {

/// Length in characters of UTF-8 text.
std::size_t characters(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width, bool right) {
    const std::string blanks(width > characters(text) ? width - characters(text) : 0, ' ');
    return right ? blanks + text : text + blanks;
}

std::string heading() {
    return std::string("Verification of Covaria ") + version();
}

}  // namespace

ReportDocument verification_report(const std::vector<CheckedCase>& cases) {
    ReportDocument document;
    document.title = document.running_head = heading();
    document.blocks.push_back(ParagraphBlock{summary(cases)});
    document.blocks.push_back(
        ParagraphBlock{"Each case is evaluated as its project states, which is installed with the program. "
                       "Published values count as "
                       "reproduced within half of their last printed digit; reference values were computed "
                       "independently of Covaria, "
                       "and Monte Carlo results may deviate from them by four combined standard errors."});
    for (const CheckedCase& c : cases) document.blocks.push_back(verification_table(c));
    return document;
}

std::string verification_text(const std::vector<CheckedCase>& cases) {
    std::string text = heading() + "\n";
    for (const CheckedCase& c : cases) {
        text += "\n" + c.of.title + " (" + c.of.source + "), " + c.of.project + "\n";
        text += padded("  figure", 54, false) + padded("published", 17, true) +
                padded("reference", 17, true) + padded("Covaria", 17, true) + "  status\n";
        if (!c.not_evaluated.empty()) text += "  FAILS: " + c.not_evaluated + "\n";
        for (const CheckedFigure& f : c.figures) {
            const std::string unit = unit_of(f.check);
            text += padded("  " + f.check.what + (unit.empty() ? "" : " in " + unit), 54, false) +
                    padded(published_text(f.check), 17, true) + padded(reference_text(f), 17, true) +
                    padded(value_text(f), 17, true) + "  " + status_text(f) + "\n";
        }
    }
    return text + "\n" + summary(cases) + "\n";
}

}  // namespace covaria
