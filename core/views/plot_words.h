// The words of charts of results, comparisons, studies and designs, in English; internal to core/report and
// to the list of texts.
#pragma once

#include "core/text/document_language.h"

namespace covaria::plot_words {

// Words about distributions
inline const Phrase monte_carlo{"Monte Carlo"};
inline const Phrase run_for_distribution{"Run Monte Carlo to see the distribution of %1"};
inline const Phrase run_for_quantiles{"Run Monte Carlo to see the quantiles of %1"};
inline const Phrase more_for_distribution{"Run Monte Carlo with more trials to see the distribution of %1"};
inline const Phrase more_for_quantiles{"Run Monte Carlo with more trials to see the quantiles of %1"};
inline const Phrase same_in_every_trial{
    "%1 has the same value in every trial: give its inputs components of uncertainty"};
inline const Phrase distribution{"Distribution of %1"};
inline const Phrase density{"probability density"};
inline const Phrase short_density{"density"};
inline const Phrase normal_of_moments{"normal, same mean and u"};
inline const Phrase normal_of_interval{"normal, same interval"};
inline const Phrase normal_of_first_order{"normal, first order"};
inline const Phrase t_of_first_order{"Student t, first order"};
inline const Phrase interval{"%1 coverage interval"};
inline const Phrase mean{"mean %1"};
inline const Phrase normal_quantiles{"Normal quantiles of %1"};
inline const Phrase standard_quantile{"quantile of the standard normal distribution"};
inline const Phrase quantile{"quantile of %1"};
inline const Phrase short_quantile{"quantile"};

// Words about contributions, correlation, convergence
inline const Phrase nothing_influences{
    "No input quantity with an uncertainty influences %1: give its inputs components of uncertainty"};
inline const Phrase of_second_order{
    "To first order no input quantity influences %1 at these estimates: its uncertainty is of second order, "
    "as "
    "Monte Carlo shows"};
inline const Phrase without_first_order{
    "The law of propagation of uncertainty says nothing of %1 at these estimates: Monte Carlo answers alone"};
inline const Phrase contributions{"Contributions to u(%1)"};
inline const Phrase first_order_differs{"%1 (u of first order: %2 of that by Monte Carlo)"};
inline const Phrase share{"share of the variance, first order"};
inline const Phrase first_order{"first order"};
inline const Phrase one_at_a_time{"one at a time, Monte Carlo"};
inline const Phrase others{"%1 others"};
inline const Phrase single_output{"A single output quantity has nothing to be correlated with"};
inline const Phrase correlation{"Correlation coefficients"};
inline const Phrase coefficient{"correlation coefficient"};
inline const Phrase run_for_convergence{"Run Monte Carlo to see how u of %1 settles"};
inline const Phrase against_trials{"%1, against the number of trials"};
inline const Phrase not_stabilised{"%1 (not stabilised)"};
inline const Phrase trials{"number of trials"};
inline const Phrase standard_errors{"± 2 standard errors"};
inline const Phrase final_u{"final u %1"};

// Words about comparisons
inline const Phrase before{"before"};
inline const Phrase after{"after"};
inline const Phrase distributions{"Distributions of %1"};
inline const Phrase no_distribution{"The output quantity has no distribution to show"};
inline const Phrase in_one_only{"Only one of the results has %1"};
inline const Phrase budget_unchanged{"The budget of %1 has not changed"};
inline const Phrase budget_changes{"Changes of the budget of %1"};
inline const Phrase change_of_variance{"change, relative to the variance before"};

// Words about studies
inline const Phrase uncertainty{"uncertainty"};
inline const Phrase as_set_up{"as set up: %1"};
inline const Phrase slice_at{"%1 at %2 = %3"};
inline const Phrase run_study{"Run the study “%1” to see it"};
inline const Phrase no_values{"No grid point of “%1” has values: %2"};

// Words about designs
inline const Phrase before_and_after{"Uncertainties before and after"};
inline const Phrase relative_to_target{"U / target"};
inline const Phrase relative_to_present{"U relative to the present design"};
inline const Phrase designed{"designed"};
inline const Phrase target{"target"};
inline const Phrase more_rows{"What more rows give"};
inline const Phrase rows{"rows"};
inline const Phrase best_found{"best found"};
inline const Phrase kept{"kept"};
inline const Phrase worth_of_rows{"What each row kept is worth"};
inline const Phrase growth_without{"growth of the objective without it"};
inline const Phrase front{"What a smaller uncertainty costs"};
inline const Phrase largest_ratio{"largest U / target"};
inline const Phrase cost{"cost"};
inline const Phrase cheapest_reductions{"cheapest reductions"};
inline const Phrase cheapest_rows{"cheapest rows"};
inline const Phrase targets{"targets"};
inline const Phrase way{"The way of the search"};
inline const Phrase evaluations{"evaluations"};
inline const Phrase best_so_far{"best so far"};

}  // namespace covaria::plot_words
