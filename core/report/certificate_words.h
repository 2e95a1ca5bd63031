// The words that a certificate says of its own, in English; internal to core/report and to the list of texts.
#pragma once

#include "core/text/document_language.h"

namespace covaria::certificate_words {

inline const Phrase title{"Calibration certificate %1"};
inline const Phrase untitled{"Calibration certificate"};
inline const Phrase page{"Page %1 of %2"};
inline const Phrase not_stated{"— not stated —"};
inline const Phrase dates{"%1 to %2"};
inline const Phrase in_the_laboratory{"in the laboratory"};
inline const Phrase item{"Item"};
inline const Phrase calibration{"Calibration"};
inline const Phrase results{"Results"};
inline const Phrase left_out{"This certificate states %1 of %2 results. Not stated: %3."};
inline const Phrase further_result{
    "1 further result is in the digital certificate that is attached to the PDF (certificate.xml)."};
inline const Phrase further_results{
    "%1 further results are in the digital certificate that is attached to the PDF (certificate.xml)."};
inline const Phrase not_evaluated{"Not evaluated: %1."};
inline const Phrase evaluated_with{"Evaluated with Covaria %1, project fingerprint %2."};
inline const Phrase evaluated_analyses{"Evaluated with Covaria %1, project fingerprint %2, analyses: %3."};
inline const Phrase closing{
    "The results relate only to the item described above, in the state in which it was calibrated. This "
    "certificate may "
    "be reproduced in full only, unless the laboratory permits otherwise."};
inline const Phrase date_of_issue{"Date of issue: %1"};
inline const Phrase end{"End of certificate"};
inline const Phrase end_of{"End of certificate %1"};

// Words about results
inline const Phrase group{"Group"};
inline const Phrase quantity{"Quantity"};
inline const Phrase result{"Result"};
inline const Phrase from_to{"p = %1 to %2."};
inline const Phrase no_result{
    "No result is stated: what was evaluated does not represent the measurand; %1 trials have no value."};
inline const Phrase skewed_intervals{"Coverage intervals that are not symmetric about the estimate: %1."};
inline const Phrase skewed_intervals_and{
    "Coverage intervals that are not symmetric about the estimate: %1; and %2 others."};
inline const Phrase in_interval{"%1 in %2"};
inline const Phrase results_of{"%1: %2"};
inline const Phrase by_law{
    "The standard uncertainty was determined by the law of propagation of uncertainty in accordance with "
    "JCGM 100."};
inline const Phrase by_distributions{
    "The distribution was determined by the propagation of distributions in accordance with JCGM 101."};
inline const Phrase fixed_factor{
    "The expanded uncertainty U stated after ± is the standard uncertainty multiplied by the fixed coverage "
    "factor k; "
    "y ± U has the coverage probability p that is stated with it."};
inline const Phrase half_interval{
    "The expanded uncertainty U stated after ± is half the width of the probabilistically symmetric coverage "
    "interval of "
    "the coverage probability p, and k = U/u."};
inline const Phrase by_degrees_of_freedom{
    "The expanded uncertainty U stated after ± is the standard uncertainty multiplied by the coverage factor "
    "k, which for "
    "a normal distribution, or for a t distribution of the effective degrees of freedom nu_eff where they "
    "are stated, "
    "corresponds to the coverage probability p."};

// Words about conformity
inline const Phrase conformity{"Statement of conformity"};
inline const Phrase unit{"Unit"};
inline const Phrase tolerance{"Tolerance"};
inline const Phrase acceptance{"Acceptance"};
inline const Phrase rule{"Decision rule"};
inline const Phrase decision{"Decision"};
inline const Phrase conforming{"Conforming"};
inline const Phrase by{"by"};
inline const Phrase passes{"pass (accepted)"};
inline const Phrase fails{"fail (rejected)"};
inline const Phrase not_judged{"not judged"};
inline const Phrase trials{"trials"};
inline const Phrase student_t{"Student t"};
inline const Phrase normal{"normal"};
inline const Phrase conformity_note{
    "JCGM 106: probability that the measurand lies inside the tolerance, by the distribution of the result: "
    "its trials, "
    "or by the law of propagation Student's t for the effective degrees of freedom. The acceptance interval "
    "is the "
    "tolerance less guard bands w. Decision rules are named as in ILAC-G8:09/2019. TUR: half of the "
    "tolerance over U. "
    "C_m: T/(2U) for U = 2u, T/(4u)."};

// Words about what an amended certificate replaces
inline const Phrase changes{"Changes to certificate %1"};
inline const Phrase no_changed_result{"No result has changed."};
inline const Phrase statement{"Statement"};
inline const Phrase replaced{"Replaced certificate"};
inline const Phrase amended{"This certificate"};

}  // namespace covaria::certificate_words
