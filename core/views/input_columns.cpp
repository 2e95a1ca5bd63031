// The columns of input quantities and their components.
#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <unordered_map>

#include "core/views/result_columns.h"
#include "core/views/result_words.h"

namespace covaria {
namespace {

using Scale = Measured::Scale;

/// A row of the table, with the set that it is about.
struct InputLine {
    const InputSet& inputs;
    const InputRow& row;

    std::size_t index() const { return row.quantities.front(); }
    const InputQuantity& quantity() const { return inputs.quantities[index()]; }
    const UncertaintyComponent& component_of(const Share& share) const {
        return inputs.components[share.component];
    }
    /// The share that the row is about; null where it is about none, or about several.
    const Share* share() const {
        const std::vector<Share>& shares = quantity().shares;
        if (row.share) return &shares[*row.share];
        return shares.size() == 1 ? &shares.front() : nullptr;
    }
    const UncertaintyComponent* component() const { return share() ? &component_of(*share()) : nullptr; }
};
using L = const InputLine&;

Message name_of(L l) {
    if (l.row.part) return "– " + l.component()->name;
    const Message& first = l.quantity().name;
    return l.row.quantities.size() == 1 ? first
                                        : first + " … " + l.inputs.quantities[l.row.quantities.back()].name;
}

Cell symbols_of(L l) {
    Symbols symbols;
    for (const std::size_t i : l.row.quantities)
        if (!l.row.part) symbols.push_back(l.inputs.quantities[i].symbol);
    return symbols;
}

/// The figures of the quantities of a table, each computed once: a quantity with hundreds of shares has as
/// many rows.
class QuantityFigures {
public:
    struct Figures {
        double estimate = 0.0, u = 0.0;
    };
    Figures of(const InputSet& inputs, std::size_t quantity) {
        const std::scoped_lock lock(mutex_);
        const auto [figures, is_new] = figures_.try_emplace(quantity);
        if (is_new)
            figures->second = {estimate_of(inputs, quantity), standard_uncertainty_of(inputs, quantity)};
        return figures->second;
    }

private:
    std::mutex mutex_;
    std::unordered_map<std::size_t, Figures> figures_;
};

/// The standard uncertainty of a part of the quantity.
double part_uncertainty(L l) {
    return std::abs(l.share()->factor) * l.component()->distribution.standard_uncertainty();
}

Message row_distribution(L l) {
    if (l.quantity().shares.empty()) return tell<"constant">();
    const UncertaintyComponent* c = l.component();
    if (!c) return tell<"combined">();
    const Message title = Message::declared(std::string(drawn_distribution(*c).title()));
    return c->held ? tell<"%1, constant">(title) : title;
}

/// The origin that all components of the quantity have in common, such as "typed"; empty where they have
/// none.
Message common_origin(L l) {
    const std::vector<Share>& shares = l.quantity().shares;
    const Message& origin = l.component_of(shares.front()).origin;
    const bool same = std::all_of(shares.begin(), shares.end(),
                                  [&](const Share& share) { return l.component_of(share).origin == origin; });
    return same ? origin : Message();
}

Message row_origin(L l) {
    const std::vector<Share>& shares = l.quantity().shares;
    if (shares.empty()) return {};
    if (const UncertaintyComponent* c = l.component()) return c->origin.empty() ? c->name : c->origin;
    const Message count = l.quantity().combination == Combination::arithmetic
                              ? tell<"%1 components, added arithmetically">(shares.size())
                              : tell<"%1 components, in quadrature">(shares.size());
    const Message common = common_origin(l);
    return common.empty() ? count : common + "; " + count;
}

Cell row_degrees_of_freedom(L l) {
    if (l.quantity().shares.empty()) return {};
    const UncertaintyComponent* c = l.component();
    return Measured{c ? c->degrees_of_freedom : degrees_of_freedom_of(l.inputs, l.index())};
}

/// Adds columns whose cells are made from lines.
class InputColumns {
public:
    InputColumns(const InputSet& inputs, std::vector<InputRow> rows)
        : inputs_(inputs), rows_(std::make_shared<const std::vector<InputRow>>(std::move(rows))) {}

    Table make() {
        table_.rows = rows_->size();
        add_quantity();
        add_row();
        add_component();
        return std::move(table_);
    }

private:
    template <class Get>
    Column& add(const char* key, Get get) {
        return table_.add(key, [&inputs = inputs_, rows = rows_, get](std::size_t i) -> Cell {
            return get(InputLine{inputs, (*rows)[i]});
        });
    }

    /// Adds a column of figures that are computed for a row's quantity.
    template <class Get>
    Column& add_of_figures(const char* key, Get get) {
        return table_.add(key,
                          [&inputs = inputs_, rows = rows_, figures = figures_, get](std::size_t i) -> Cell {
                              const InputLine line{inputs, (*rows)[i]};
                              return get(line, [&] { return figures->of(inputs, line.index()); });
                          });
    }

    /// Adds a column about the component of the row's share; its cells are empty where the row has no share.
    template <class Get>
    void add_of_component(const char* key, Get get) {
        add(key, [get](L l) { return l.row.share ? Cell(get(l, *l.component())) : Cell(); });
    }

    void add_quantity() {
        add("group", [](L l) -> Cell { return l.quantity().group; });
        add("symbol", symbols_of).print("Symbol").of_symbols();
        add("name", [](L l) -> Cell { return name_of(l); }).print("Quantity");
        add("unit", [](L l) -> Cell { return l.quantity().unit; }).print("Unit");
        add_of_figures("estimate",
                       [](L l, const auto& figures) -> Cell {
                           if (l.row.part || l.row.quantities.size() > 1) return {};
                           return Measured{figures().estimate, Scale::value, l.quantity().unit, {}};
                       })
            .print("Estimate")
            .input_of("u");
        add_of_figures("u",
                       [](L l, const auto& figures) -> Cell {
                           const double u = l.row.part ? part_uncertainty(l) : figures().u;
                           return Measured{u, Scale::interval, l.quantity().unit, {}};
                       })
            .print_symbol("u(x_i)")
            .uncertainty()
            .of_row({"estimate", "u"});
    }

    /// Adds the columns that print has in one row, about the quantity or a part of it.
    void add_row() {
        add("row distribution", [](L l) -> Cell { return row_distribution(l); })
            .print("Distribution")
            .not_in_files();
        add("row type",
            [](L l) -> Cell {
                return l.component() ? Cell(result_words::type_text(l.component()->type)) : Cell();
            })
            .print("Type")
            .not_in_files();
        add("row degrees of freedom", row_degrees_of_freedom)
            .print_symbol("nu_i")
            .degrees_of_freedom()
            .not_in_files();
        add("row origin",
            [](L l) -> Cell {
                Message origin = row_origin(l);
                return origin.empty() ? Cell() : Cell(std::move(origin));
            })
            .print("Origin")
            .not_in_files();
    }

    void add_component() {
        using C = const UncertaintyComponent&;
        add_of_component("component", [](L, C c) { return c.name; });
        add_of_component("id", [](L, C c) { return c.id; });
        add_of_component("factor", [](L l, C c) {
            return Measured{l.share()->factor, Scale::interval, l.quantity().unit, c.unit};
        });
        add_of_component("component unit", [](L, C c) { return c.unit; });
        add_of_component("component u", [](L, C c) {
            return Measured{c.distribution.standard_uncertainty(), Scale::interval, c.unit, {}};
        });
        add_of_component("distribution", [](L, C c) { return std::string(drawn_distribution(c).title()); });
        add_of_component("type", [](L, C c) { return result_words::type_text(c.type); });
        add_of_component("degrees of freedom", [](L, C c) { return Measured{c.degrees_of_freedom}; });
        add_of_component("held", [](L, C c) { return Answer{c.held}; });
        add_of_component("origin", [](L, C c) { return c.origin; });
    }

    const InputSet& inputs_;
    std::shared_ptr<const std::vector<InputRow>> rows_;
    std::shared_ptr<QuantityFigures> figures_ = std::make_shared<QuantityFigures>();
    Table table_{"inputs", "Input quantities and their components"};
};

}  // namespace

std::vector<InputRow> all_shares(const InputSet& inputs) {
    std::vector<InputRow> rows;
    for (std::size_t i = 0; i < inputs.quantities.size(); ++i) {
        if (inputs.quantities[i].shares.empty()) rows.push_back({{i}});
        for (std::size_t k = 0; k < inputs.quantities[i].shares.size(); ++k) rows.push_back({{i}, k});
    }
    return rows;
}

Table inputs_table(const InputSet& inputs, std::vector<InputRow> rows) {
    return InputColumns(inputs, std::move(rows)).make();
}

}  // namespace covaria
