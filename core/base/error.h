// Failures as values: Error (one failure), Result<T> (a value or an Error), Problem (one finding of
// a check).
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/message.h"

namespace covaria {

enum class ErrorCode {
    bad_input,  ///< the user's data are wrong; `path` says where
    not_found,  ///< a file, asset, analysis or quantity does not exist
    io,         ///< reading or writing failed (permissions, full disk)
    cancelled,  ///< stopped on request
    numeric,    ///< the computation has no result (singular geometry, all trials failed)
    usage,      ///< wrong command line
};

/// A failure: what the user is told, with the place in the project file where it is known.
struct Error {
    ErrorCode code = ErrorCode::bad_input;
    Message message = {};
    std::string path = {};  ///< JSON pointer into the project, e.g. "/analyses/0/setup/base_points/rows/2"
    std::string file = {};
    int line = 0;  ///< 1-based; 0 = unknown
};

template <class T>
using Result = tl::expected<T, Error>;

inline tl::unexpected<Error> fail(ErrorCode code, Message message, std::string path = {}) {
    return tl::unexpected<Error>(Error{code, std::move(message), std::move(path), {}, 0});
}
inline tl::unexpected<Error> fail(Error error) {
    return tl::unexpected<Error>(std::move(error));
}

enum class Severity { warning, error };

/// A way out of a problem that a person can take with one click: what it is, and what is to stand where.
struct Remedy {
    struct Value {
        std::string place;  ///< JSON pointer, relative as the path of its problem
        std::variant<std::monostate, double, std::string> value;  ///< nothing: it becomes empty
    };
    Message words;  ///< "a difference: t in K"
    std::vector<Value> values;
};

/// A finding of a check (of a project, a set-up, an asset). Checks collect all of them instead of stopping
/// at the first.
struct Problem {
    Severity severity = Severity::error;
    std::string path = {};  ///< JSON pointer, relative to what is checked until the caller prefixes it
    Message message = {};
    std::string file = {};
    int line = 0;
    std::vector<Remedy> remedies = {};  ///< ways out to choose from

    /// Moves the finding below `prefix` ("/analyses/0/setup"), where the part lives that was checked.
    void move_below(const std::string& prefix) {
        path = prefix + path;
        for (Remedy& remedy : remedies)
            for (Remedy::Value& value : remedy.values) value.place = prefix + value.place;
    }
};

/// Collects problems; the prefix of the place being checked is put before each path.
class Problems {
public:
    void error(std::string path, Message message) {
        add(Severity::error, std::move(path), std::move(message));
    }
    void warning(std::string path, Message message) {
        add(Severity::warning, std::move(path), std::move(message));
    }
    void add(Severity severity, std::string path, Message message) {
        items_.push_back({severity, std::move(path), std::move(message), {}, 0, {}});
    }
    void add(Problem problem) { items_.push_back(std::move(problem)); }
    /// Takes over the problems of a part that lives at `prefix` ("/analyses/0/setup").
    void take(const Problems& part, const std::string& prefix) {
        for (Problem p : part.items_) {
            p.move_below(prefix);
            items_.push_back(std::move(p));
        }
    }
    bool has_errors() const {
        for (const Problem& p : items_)
            if (p.severity == Severity::error) return true;
        return false;
    }
    const std::vector<Problem>& items() const { return items_; }
    std::vector<Problem>& items() { return items_; }
    bool empty() const { return items_.empty(); }

private:
    std::vector<Problem> items_;
};

}  // namespace covaria
