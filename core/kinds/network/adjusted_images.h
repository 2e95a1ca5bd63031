// Mirror images: points that slope distances alone tie to places in a plane fit as well on its other side.
#pragma once

#include "core/kinds/network/adjusted_setup.h"

namespace covaria::network {

/// Takes an adjusted network to the side that approximate coordinates state, where the distances fit there as
/// well.
void take_stated_sides(AdjustedNetwork& network);
/// Warns of points that may as well be on the other side of a plane, or hardly are on any side of it.
void check_images(const AdjustedNetwork& network, Problems& problems);
/// Puts points next to the plane of what they are tied to into it, where the search for their distance from
/// it has no end; false where there are none.
bool put_into_planes(AdjustedNetwork& network);

}  // namespace covaria::network
