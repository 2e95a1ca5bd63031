// The part of the start of an adjustment that no plane helps: points of space that slope distances alone tie.
#pragma once

#include "core/kinds/network/adjusted_placing.h"

namespace covaria::network {

/// Whether each point has all three coordinates and nothing but slope distances was read of it.
std::vector<char> tied_by_slopes_alone(const AdjustedNetwork& network);

/// Places those of the `wanted` points that distances to places, or among themselves, tie by three or more;
/// false where there is none. What no place ties lies anywhere, or as it was stated where it was.
bool place_by_slopes(AdjustedNetwork& network, Placing& placing, const std::vector<char>& wanted);

/// Lays the points that slope distances alone tie without a look at approximate coordinates, which may lie
/// where the distances do not lead on from: all in a plane, or far off. False where there are none.
bool lay_anew_in_space(AdjustedNetwork& network);

}  // namespace covaria::network
