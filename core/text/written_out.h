// Which results are written out, without a power of ten: 50 000 840 ± 180.
#pragma once

namespace covaria {

inline constexpr double largest_written_out = 1e10;
inline constexpr int most_rounded_places = 3;  ///< before the point

}  // namespace covaria
