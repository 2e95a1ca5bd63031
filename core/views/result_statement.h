// A result in the words of a certificate: "L = (50.000 78 ± 0.000 41) mm, k = 2.00, p = 95 %" (JCGM 100 7.2).
#pragma once

#include <string>

#include "core/result/uncertainty_result.h"
#include "core/text/display_units.h"
#include "core/text/document_language.h"

namespace covaria {

/// The value "(50.000 78 ± 0.000 41) mm": U with two significant digits and the estimate to match, common
/// powers of ten outside. Without `with_unit` it is a cell under a head that gives the unit.
std::string value_statement(const OutputResult& output, bool with_unit = true,
                            const DocumentLanguage& in = {}, const DisplayUnits& units = {}, int digits = 2);
/// The value of any estimate and expanded uncertainty, SI, with these significant digits of U.
std::string value_statement(double estimate, double uncertainty, const Unit& unit, int digits = 2,
                            bool with_unit = true, const DocumentLanguage& in = {});
/// The probability of "p = 95 %": the one that was asked for, or that of [y - U, y + U] where k was fixed.
double stated_probability(const OutputResult& output, const UncertaintyResult& result);
/// The probability of the result line by the law of propagation.
double stated_probability(const FirstOrderOutput& first, const UncertaintyResult& result);
/// The probability as text: "95 %", "95.45 %", "" if there is none.
std::string probability_text(double probability, const DocumentLanguage& in = {});
/// The degrees of freedom that k was taken for; infinite where k is not of a t distribution.
double stated_degrees_of_freedom(const OutputResult& output, const UncertaintyResult& result);
/// The statement "k = 2.09, ν_eff = 19, p = 95 %", and the interval where it is not symmetric about the
/// estimate.
std::string coverage_statement(const OutputResult& output, const UncertaintyResult& result,
                               const DocumentLanguage& in = {}, const DisplayUnits& units = {},
                               int digits = 2);
/// The statement behind "L = ": "(50.000 78 ± 0.000 41) mm, k = 2.00, p = 95 %"; by Monte Carlo, where the
/// interval is not symmetric about the estimate, "5.0 mm, u = 4.7 mm, p = 95 %, coverage interval [0.1, 18.4]
/// mm" (JCGM 101 5.5), u with as many significant digits and y to match: y ± U would cover another part of
/// the distribution. It is the value alone if that is exact.
std::string result_statement(const OutputResult& output, const UncertaintyResult& result,
                             const DocumentLanguage& in = {}, const DisplayUnits& units = {}, int digits = 2);
/// Whether result_statement gives the interval in place of U and k.
bool is_stated_by_interval(const OutputResult& output, const UncertaintyResult& result);
/// The largest of y, U and the limits of the interval, in that unit. It decides whether all of them, in the
/// line, the row of a table and the chart, are written without a power of ten (core/text/written_out.h).
double largest_stated_number(const OutputResult& output, const UncertaintyResult& result, const Unit& unit);
/// The standard uncertainty of the law of propagation as a part of that by Monte Carlo, to a hundredth; empty
/// where they differ by less than anybody would notice.
std::optional<double> part_of_first_order(const OutputResult& output);
/// The uncertainty whose digits decide those of the estimate and of its interval, wherever they stand: U, or
/// u where U is not stated and u is the smaller one.
double stated_spread(const OutputResult& output, const UncertaintyResult& result);
/// The coverage interval, "[1.234, 1.240] mm", if the estimate is not in its middle by more than a twentieth
/// of U; else empty. JCGM 101 states what y ± U does not say.
std::string skewed_interval(const OutputResult& output, const UncertaintyResult& result,
                            const DocumentLanguage& in = {}, const DisplayUnits& units = {}, int digits = 2);

}  // namespace covaria
