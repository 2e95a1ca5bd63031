#include "app/json_output.h"

#include <CLI/CLI.hpp>

#include "core/base/version.h"

namespace covaria {
namespace {

OrderedJson text_or_null(const std::string& text) {
    return text.empty() ? OrderedJson(nullptr) : OrderedJson(text);
}

}  // namespace

void add_json_option(CLI::App& command, bool& wanted) {
    command.add_flag("--json", wanted, "print JSON, for programs");
}

OrderedJson json_document(const std::string& format) {
    return {{"format", format}, {"schemaVersion", 1}, {"covariaVersion", version()}};
}

std::string json_text(const OrderedJson& json) {
    return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

OrderedJson problems_json(const Problems& problems) {
    OrderedJson list = OrderedJson::array();
    for (const Problem& p : problems.items())
        list.push_back({{"severity", p.severity == Severity::error ? "error" : "warning"},
                        {"file", text_or_null(p.file)},
                        {"line", p.line > 0 ? OrderedJson(p.line) : OrderedJson(nullptr)},
                        {"path", text_or_null(p.path)},
                        {"message", p.message.english()}});
    return list;
}

}  // namespace covaria
