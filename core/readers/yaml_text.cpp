// YAML parsed. This is the only file that knows yaml-cpp.
#include "core/readers/yaml_text.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <sstream>

#include "core/base/in_quotes.h"
#include "core/readers/entry_texts.h"
#include "core/readers/xml_text.h"

namespace covaria {

namespace {

constexpr std::size_t deepest = 60, most_nodes = 200'000;

/// The error that ends the parsing; it never leaves this file.
struct RefusedYaml {
    Error error;
};

/// Builder of nodes from events; the nodes that are not finished are in `open_`.
class NodeBuilder : public YAML::EventHandler {
public:
    YamlNode take() { return std::move(root_); }

    void OnDocumentStart(const YAML::Mark&) override {}
    void OnDocumentEnd() override {}
    void OnNull(const YAML::Mark& mark, YAML::anchor_t) override { add(node_at(mark, Kind::nothing)); }
    void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
        refuse(mark, tell<"an alias (*name): write out what it stands for, aliases are not expanded">());
    }
    void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                  const std::string& value) override {
        YamlNode node = node_at(mark, Kind::scalar);
        node.text = value;
        add(std::move(node));
    }
    void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                         YAML::EmitterStyle::value) override {
        open(mark, Kind::list);
    }
    void OnSequenceEnd() override { close(); }
    void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                    YAML::EmitterStyle::value) override {
        open(mark, Kind::map);
    }
    void OnMapEnd() override { close(); }

private:
    using Kind = YamlNode::Kind;

    [[noreturn]] static void refuse(const YAML::Mark& mark, const Message& message) {
        throw RefusedYaml{refused_at(mark.line + 1, mark.column + 1, message).value()};
    }

    YamlNode node_at(const YAML::Mark& mark, Kind kind) {
        if (++nodes_ > most_nodes) refuse(mark, tell<"more than %1 entries are not read">(most_nodes));
        YamlNode node;
        node.kind = kind;
        node.line = mark.line + 1;
        node.column = mark.column + 1;
        return node;
    }

    void open(const YAML::Mark& mark, Kind kind) {
        if (open_.size() == deepest) refuse(mark, tell<"more than %1 levels are not read">(deepest));
        open_.push_back(node_at(mark, kind));
    }

    void close() {
        YamlNode node = std::move(open_.back());
        open_.pop_back();
        add(std::move(node));
    }

    /// Adds a finished node to the one around it; in a map keys and values come in turns.
    void add(YamlNode node) {
        if (open_.empty()) {
            root_ = std::move(node);
            return;
        }
        YamlNode& parent = open_.back();
        if (parent.kind == Kind::map && parent.keys.size() == parent.children.size()) {
            const YAML::Mark mark = mark_of(node);
            if (node.kind != Kind::scalar) refuse(mark, tell<"a key must be a word">());
            if (std::find(parent.keys.begin(), parent.keys.end(), node.text) != parent.keys.end())
                refuse(mark, tell<"the key %1 stands twice">(in_quotes(plain_name(node.text))));
            if (parent.keys.size() == 1000) refuse(mark, tell<"more than 1000 keys are not read">());
            parent.keys.push_back(std::move(node.text));
        } else {
            parent.children.push_back(std::move(node));
        }
    }

    static YAML::Mark mark_of(const YamlNode& node) {
        YAML::Mark mark;
        mark.line = node.line - 1;
        mark.column = node.column - 1;
        return mark;
    }

    YamlNode root_;
    std::vector<YamlNode> open_;
    std::size_t nodes_ = 0;
};

}  // namespace

const YamlNode* YamlNode::find(const std::string& key) const {
    const auto found = std::find(keys.begin(), keys.end(), key);
    if (found == keys.end()) return nullptr;
    const YamlNode& child = children[static_cast<std::size_t>(found - keys.begin())];
    return child.kind == Kind::nothing ? nullptr : &child;
}

std::string YamlNode::text_of(const std::string& key) const {
    const YamlNode* node = find(key);
    return node && node->kind == Kind::scalar ? node->text : std::string();
}

std::optional<double> YamlNode::number() const {
    return kind == Kind::scalar ? number_in_text(text) : std::nullopt;
}

Result<YamlNode> parse_yaml(const std::string& text) {
    if (text.size() > largest_yaml)
        return refused_at(1, tell<"YAML of more than %1 kB is not read">(largest_yaml / 1000));
    std::istringstream stream(text);
    NodeBuilder builder;
    try {
        YAML::Parser parser(stream);
        if (!parser.HandleNextDocument(builder))
            return refused_at(1, tell<"the file has no YAML document">());
        return builder.take();
    } catch (const RefusedYaml& refused) {
        return fail(refused.error);
    } catch (const YAML::Exception& e) {
        const bool placed = !e.mark.is_null();
        return refused_at(placed ? e.mark.line + 1 : 1, placed ? e.mark.column + 1 : 1,
                          tell<"not readable as YAML: %1">(plain_line(e.msg)));
    }
}

}  // namespace covaria
