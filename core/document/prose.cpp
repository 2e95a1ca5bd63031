#include "core/document/prose.h"

#include "core/text/symbol.h"

namespace covaria {

std::string prose_html(const std::vector<ProseSpan>& spans, Links links) {
    std::string out;
    const auto wrapped = [](const char* tag, const std::string& inner) {
        return std::string("<") + tag + ">" + inner + "</" + tag + ">";
    };
    for (const ProseSpan& span : spans) {
        std::string text =
            span.code ? wrapped("code", escape_html(span.text)) : to_html(running_text(span.text));
        if (span.strong) text = wrapped("b", text);
        if (span.emphasis) text = wrapped("i", text);
        if (links == Links::shown && !span.link.empty())
            text = "<a href=\"" + escape_html(span.link) + "\">" + text + "</a>";
        out += text;
    }
    return out;
}

std::string prose_words(const std::vector<ProseSpan>& spans) {
    std::string out;
    for (const ProseSpan& span : spans) out += span.code ? span.text : to_unicode(running_text(span.text));
    return out;
}

}  // namespace covaria
