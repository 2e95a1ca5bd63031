// Lengths of ballbars that are more than a point needs, as evidence for or against what is stated of them.
#pragma once

#include "core/kinds/ballbar/setup.h"
#include "core/kinds/points/component_evidence.h"

namespace covaria::tcp {

/// Evidence of points that were measured with more than three bars: about the readings of the bars, their
/// constants, the lengths between supports and the heights of supports. Empty without such lengths, and where
/// a reading has no uncertainty.
ComponentEvidence evidence_of(const TcpSetup& setup, const TcpInputs& inputs);

/// Residuals of measured lengths; no rows without any.
Table residuals_of_lengths(const TcpSetup& setup);
/// Warns of lengths that contradict each other more than their uncertainties allow.
void warn_of_lengths(const ComponentEvidence& evidence, Problems& problems);

}  // namespace covaria::tcp
