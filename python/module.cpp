// Covaria in Python: projects loaded, changed, evaluated and saved; results, trials and the model as numpy
// arrays.
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "core/base/guarded.h"
#include "core/base/version.h"
#include "core/document/document_writers.h"
#include "core/made/load_project.h"
#include "core/project/linked_files.h"
#include "core/project/project_file.h"
#include "core/propagation/engine.h"
#include "core/report/report.h"
#include "core/report/report_parts.h"
#include "core/report/table_builder.h"
#include "core/result_files/results_json.h"
#include "core/views/result_columns.h"

namespace py = pybind11;
namespace fs = std::filesystem;

namespace covaria {

namespace {

std::string words_of(const Error& error) {
    std::string words = error.file + (error.line > 0 ? ":" + std::to_string(error.line) : "");
    if (!words.empty()) words += ": ";
    if (!error.path.empty()) words += error.path + ": ";
    return words + error.message.english();
}

/// Errors are ValueError in Python.
template <class T>
T value_or_raise(Result<T> result) {
    if (!result) throw py::value_error(words_of(result.error()));
    if constexpr (!std::is_void_v<T>) return std::move(*result);
}

/// As `--set` takes it: JSON for what JSON has, else the text.
std::string json_of(const py::object& value) {
    if (py::isinstance<py::str>(value)) return value.cast<std::string>();
    return py::module_::import("json").attr("dumps")(value).cast<std::string>();
}

py::object from_json(const std::string& text) {
    return py::module_::import("json").attr("loads")(text);
}

/// 1000, numpy's integers, and 1e6 where no digit is lost.
std::uint64_t whole_number(const py::handle& value, const char* what) {
    const bool is_float = py::isinstance<py::float_>(value);
    if (is_float && !value.attr("is_integer")().cast<bool>())
        throw py::value_error(std::string(what) + " is a whole number, not " +
                              py::str(value).cast<std::string>());
    const py::int_ number = is_float ? py::int_(py::reinterpret_borrow<py::object>(value))
                                     : py::int_(py::module_::import("operator").attr("index")(value));
    const py::int_ least(0);
    if (number.attr("__lt__")(least).cast<bool>() || number.attr("bit_length")().cast<int>() > 64)
        throw py::value_error(std::string(what) + " cannot be " + py::str(value).cast<std::string>());
    return number.cast<std::uint64_t>();
}

std::optional<std::uint64_t> whole_number_or_none(const py::object& value, const char* what) {
    if (value.is_none()) return std::nullopt;
    return whole_number(value, what);
}

std::string html_of(std::vector<ReportBlock> blocks) {
    return html_body(blocks);
}

TableBlock analyses_block(const Project& project) {
    report_parts::TableBuilder table("analyses", Message(project.title));
    for (const char* head : {"Analysis", "Name", "Model"}) table.text(Message(head));
    for (const AnalysisEntry& entry : project.analyses) table.row({entry.id, entry.name, entry.model});
    return table.take();
}

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

class Analysis {
public:
    Analysis(std::shared_ptr<const PreparedAnalysis> prepared, MadeProject::Pointer made)
        : prepared_(std::move(prepared)), made_(std::move(made)) {}

    const std::string& id() const { return prepared_->id; }
    const std::string& name() const { return prepared_->name; }

    std::vector<std::string> inputs() const {
        std::vector<std::string> symbols;
        for (const InputQuantity& q : prepared_->inputs.quantities) symbols.push_back(q.symbol);
        return symbols;
    }
    std::vector<std::string> outputs() const {
        std::vector<std::string> symbols;
        for (const OutputQuantity& q : prepared_->model->outputs()) symbols.push_back(q.symbol);
        return symbols;
    }
    Eigen::VectorXd estimates() const {
        Eigen::VectorXd x(static_cast<Eigen::Index>(prepared_->inputs.quantities.size()));
        for (Eigen::Index i = 0; i < x.size(); ++i)
            x[i] = estimate_of(prepared_->inputs, static_cast<std::size_t>(i));
        return x;
    }

    /// Of one row of input quantities, or of each row of a matrix.
    Numbers model(const Numbers& x) const {
        const auto in = prepared_->inputs.quantities.size(), out = prepared_->model->outputs().size();
        if (x.ndim() != 1 && x.ndim() != 2)
            throw py::value_error("the input quantities are a row, or a matrix with a row for each trial");
        if (const auto given = static_cast<std::size_t>(x.shape(x.ndim() - 1)); given != in)
            throw py::value_error("the model has " + std::to_string(in) + " input quantities, not " +
                                  std::to_string(given));
        std::vector<py::ssize_t> shape(x.shape(), x.shape() + x.ndim());
        const std::size_t rows = x.ndim() == 1 ? 1 : static_cast<std::size_t>(shape.front());
        shape.back() = static_cast<py::ssize_t>(out);
        Numbers y(shape);
        const double* const from = x.data();
        double* const to = y.mutable_data();
        const py::gil_scoped_release others_may_run;
        for (std::size_t row = 0; row < rows; ++row) {
            double* const values = to + row * out;
            if (!prepared_->model->evaluate({from + row * in, in}, {values, out}))
                std::fill_n(values, out, std::nan(""));
        }
        return y;
    }

    /// Inputs and outputs, a row for each trial.
    std::pair<Eigen::MatrixXd, Eigen::MatrixXd> trials(const py::object& count, const py::object& first,
                                                       const py::object& seed) const {
        const std::uint64_t wanted = whole_number(count, "count"), from = whole_number(first, "first");
        const auto of_seed = whole_number_or_none(seed, "seed");
        ReplayedTrials replayed = value_or_raise([&] {
            const py::gil_scoped_release others_may_run;
            return replay_trials(*prepared_->propagated, of_seed.value_or(prepared_->options.seed), from,
                                 wanted);
        }());
        return {replayed.inputs.transpose(), replayed.outputs.transpose()};
    }

    std::string words() const {
        const std::size_t in = prepared_->inputs.quantities.size(), out = prepared_->model->outputs().size();
        return "<covaria.Analysis '" + id() + "': " + std::to_string(in) + " input quantit" +
               (in == 1 ? "y, " : "ies, ") + std::to_string(out) + (out == 1 ? " output>" : " outputs>");
    }

    /// The first input quantities: a network has thousands.
    std::string html() const {
        constexpr std::size_t most_rows = 200;
        std::vector<InputRow> rows;
        for (std::size_t i = 0; i < std::min(most_rows, prepared_->inputs.quantities.size()); ++i)
            rows.push_back({{i}, {}, false});
        const std::vector<std::string> keys{"symbol", "name", "unit", "estimate", "u", "row distribution"};
        report_parts::TableBuilder table("inputs", Message(name().empty() ? id() : name()));
        table.all_of(inputs_table(prepared_->inputs, rows), keys);
        if (const std::size_t more = prepared_->inputs.quantities.size() - rows.size())
            table.note(std::to_string(more) + " more");
        return html_of({table.take()});
    }

private:
    std::shared_ptr<const PreparedAnalysis> prepared_;
    MadeProject::Pointer made_;
};

class PythonProject {
public:
    explicit PythonProject(const fs::path& file) : file_(file.string()) { load(); }

    const std::string& file() const { return file_; }
    const std::string& title() const { return made_->project().title; }

    void set(const std::string& pointer, const py::object& value) {
        values_.push_back({pointer, json_of(value)});
        try {
            load();
        } catch (...) {
            values_.pop_back();
            throw;
        }
    }

    /// CSV files that the project refers to are where it is: elsewhere their data must be inside.
    void save(const fs::path& file, bool embed) const {
        Project project = made_->project();
        const auto folder_of = [](const fs::path& of) {
            return fs::weakly_canonical(fs::absolute(of).parent_path());
        };
        if (embed)
            unlink_tables(project);
        else if (!linked_files(project).empty() && folder_of(file) != folder_of(file_))
            throw py::value_error(
                "the project refers to CSV files beside it, which the new folder does not have: use "
                "embed=True");
        value_or_raise(save_project(project, file));
    }

    std::vector<std::string> analyses() const {
        std::vector<std::string> ids;
        for (const AnalysisEntry& entry : made_->project().analyses) ids.push_back(entry.id);
        return ids;
    }

    Analysis analysis(const std::string& id) const { return {prepared(id), made_}; }

    /// As results.json has it, with the arrays of each analysis.
    py::object evaluate(const std::vector<std::string>& chosen, const py::object& trials,
                        const py::object& seed) const {
        const auto of_trials = whole_number_or_none(trials, "trials"),
                   of_seed = whole_number_or_none(seed, "seed");
        std::vector<EvaluatedAnalysis> evaluated;
        for (const std::string& id : chosen.empty() ? analyses() : chosen)
            evaluated.push_back(evaluated_one(id, of_trials, of_seed));
        py::dict results = from_json(results_json(made_->project(), evaluated));
        py::dict arrays;
        std::vector<ReportBlock> blocks;
        for (const EvaluatedAnalysis& e : evaluated) {
            arrays[py::str(e.analysis->id)] = arrays_of(*e.result);
            blocks.push_back(results_block_of(e));
        }
        results["arrays"] = arrays;
        return py::module_::import("covaria").attr("Results")(results, html_of(std::move(blocks)));
    }

    std::string words() const {
        std::string ids;
        for (const std::string& id : analyses()) ids += (ids.empty() ? "" : ", ") + id;
        return "<covaria.Project '" + title() + "': " + (ids.empty() ? "no analyses" : ids) + ">";
    }

    std::string html() const { return html_of({analyses_block(made_->project())}); }

private:
    void load() {
        LoadedProject loaded = load_project(file_, values_);
        for (const Problem& problem : loaded.problems.items())
            if (problem.severity == Severity::error)
                throw py::value_error(words_of({ErrorCode::bad_input, problem.message, problem.path,
                                                problem.file.empty() ? file_ : problem.file, problem.line}));
        made_ = std::move(loaded.made);
    }

    std::shared_ptr<const PreparedAnalysis> prepared(const std::string& id) const {
        auto found = made_->analysis(id);
        if (!found) throw py::key_error("there is no analysis '" + id + "'");
        return found;
    }

    EvaluatedAnalysis evaluated_one(const std::string& id, std::optional<std::uint64_t> trials,
                                    std::optional<std::uint64_t> seed) const {
        auto analysis = std::make_shared<PreparedAnalysis>(*prepared(id));
        if (trials) {
            analysis->options.method = *trials == 0 ? Method::first_order : Method::monte_carlo;
            analysis->options.trials = *trials == 0 ? analysis->options.trials : *trials;
        }
        if (seed) analysis->options.seed = *seed;
        UncertaintyResult result = value_or_raise([&] {
            const py::gil_scoped_release others_may_run;
            return run_analysis(*analysis);
        }());
        return {std::move(analysis),
                std::make_shared<const UncertaintyResult>(std::move(result)),
                made_->warnings_of(id),
                {}};
    }

    static TableBlock results_block_of(const EvaluatedAnalysis& evaluated) {
        std::vector<std::size_t> measurands;
        for (std::size_t i = 0; i < evaluated.result->outputs.size(); ++i)
            if (evaluated.result->outputs[i].quantity.role == OutputRole::measurand) measurands.push_back(i);
        const PreparedAnalysis& analysis = *evaluated.analysis;
        return report_parts::results_block(*evaluated.result, measurands,
                                           Message(analysis.name.empty() ? analysis.id : analysis.name),
                                           DocumentLanguage::english());
    }

    /// SI, in the order of the outputs.
    static py::dict arrays_of(const UncertaintyResult& result) {
        const auto n = static_cast<Eigen::Index>(result.outputs.size());
        Eigen::VectorXd y(n), u(n), k(n), expanded(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            const OutputResult& output = result.outputs[static_cast<std::size_t>(i)];
            y[i] = output.estimate;
            u[i] = output.standard_uncertainty;
            k[i] = output.coverage_factor;
            expanded[i] = output.expanded_uncertainty;
        }
        py::dict arrays;
        arrays["y"] = y;
        arrays["u"] = u;
        arrays["k"] = k;
        arrays["U"] = expanded;
        if (result.covariance.is_whole()) {
            arrays["covariance"] = result.covariance.whole();
        } else {
            py::list blocks;
            for (std::size_t b = 0; b < result.covariance.blocks().list().size(); ++b)
                blocks.append(
                    py::make_tuple(result.covariance.blocks().list()[b].first, result.covariance.block(b)));
            arrays["covariance_blocks"] = blocks;
        }
        return arrays;
    }

    std::string file_;
    std::vector<ValueAt> values_;
    MadeProject::Pointer made_;
};

void add_project(py::module_& module) {
    py::class_<PythonProject>(module, "Project")
        .def_property_readonly("analyses", &PythonProject::analyses, "Ids of the analyses.")
        .def_property_readonly("file", &PythonProject::file, "The file that it was loaded from.")
        .def_property_readonly("title", &PythonProject::title)
        .def("analysis", &PythonProject::analysis, py::arg("id"), "KeyError: there is none of that id.")
        .def("set", &PythonProject::set, py::arg("pointer"), py::arg("value"),
             "Puts a value at a JSON pointer, as `covaria run --set` does. ValueError leaves all as it was.")
        .def("save", &PythonProject::save, py::arg("file"), py::arg("embed") = false,
             "Writes the project with the values that were set. embed: the data of CSV files inside.")
        .def("evaluate", &PythonProject::evaluate, py::arg("analyses") = std::vector<std::string>(),
             py::arg("trials") = py::none(), py::arg("seed") = py::none(),
             "The content of results.json, and under 'arrays' y, u, k, U and covariance of each analysis "
             "(SI). "
             "trials: 0 for the law of propagation only.")
        .def("__repr__", &PythonProject::words)
        .def("_repr_html_", &PythonProject::html);
}

void add_analysis(py::module_& module) {
    py::class_<Analysis>(module, "Analysis")
        .def_property_readonly("id", &Analysis::id)
        .def_property_readonly("name", &Analysis::name)
        .def_property_readonly("inputs", &Analysis::inputs, "Symbols of the input quantities.")
        .def_property_readonly("outputs", &Analysis::outputs, "Symbols of the outputs.")
        .def_property_readonly("estimates", &Analysis::estimates, "Estimates of the input quantities, SI.")
        .def("model", &Analysis::model, py::arg("x"),
             "y = f(x), SI, of a row of input quantities or of each row of a matrix; NaN where the model has "
             "no value.")
        .def("__call__", &Analysis::model, py::arg("x"))
        .def("trials", &Analysis::trials, py::arg("count"), py::arg("first") = 0,
             py::arg("seed") = py::none(),
             "(inputs, outputs), a row for each trial, exactly as the run had them; NaN without a value.")
        .def("__repr__", &Analysis::words)
        .def("_repr_html_", &Analysis::html);
}

}  // namespace

}  // namespace covaria

PYBIND11_MODULE(_covaria, module) {
    module.doc() = "Measurement uncertainty with Covaria's projects. All arrays are in SI units.";
    module.attr("__version__") = covaria::version();
    module.def(
        "load", [](const fs::path& file) { return covaria::PythonProject(file); }, py::arg("file"),
        "A project from its file. ValueError with its place where the file is wrong.");
    covaria::add_project(module);
    covaria::add_analysis(module);
}
