// Lines and columns of a text, and errors that name them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace covaria {

inline tl::unexpected<Error> refused_at(int line, Message message) {
    return fail(Error{ErrorCode::bad_input, std::move(message), {}, {}, line});
}
inline tl::unexpected<Error> refused_at(int line, int column, const Message& message) {
    return refused_at(line, tell<"column %1: %2">(column, message));
}

/// Places by the offset of a byte; both count from 1.
class TextPlaces {
public:
    explicit TextPlaces(std::string_view text) {
        for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1))
            ends_.push_back(static_cast<std::ptrdiff_t>(at));
    }
    int line(std::ptrdiff_t at) const {
        return 1 + static_cast<int>(std::lower_bound(ends_.begin(), ends_.end(), at) - ends_.begin());
    }
    int column(std::ptrdiff_t at) const {
        const int before = line(at) - 1;
        return static_cast<int>(at - (before == 0 ? -1 : ends_[static_cast<std::size_t>(before - 1)]));
    }

private:
    std::vector<std::ptrdiff_t> ends_;
};

}  // namespace covaria
