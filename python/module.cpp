// Covaria in Python: projects loaded, changed and evaluated; results, trials and the model as numpy arrays.
#include <pybind11/eigen.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "core/base/guarded.h"
#include "core/made/load_project.h"
#include "core/propagation/engine.h"
#include "core/report/report.h"

namespace py = pybind11;

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
    return std::move(*result);
}

/// As `--set` takes it: JSON for what JSON has, else the text.
std::string json_of(const py::object& value) {
    if (py::isinstance<py::str>(value)) return value.cast<std::string>();
    return py::module_::import("json").attr("dumps")(value).cast<std::string>();
}

py::object from_json(const std::string& text) {
    return py::module_::import("json").attr("loads")(text);
}

class Analysis {
public:
    Analysis(std::shared_ptr<const PreparedAnalysis> prepared, MadeProject::Pointer made)
        : prepared_(std::move(prepared)), made_(std::move(made)) {}

    const PreparedAnalysis& prepared() const { return *prepared_; }

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

    Eigen::VectorXd model(const Eigen::VectorXd& x) const {
        if (static_cast<std::size_t>(x.size()) != prepared_->inputs.quantities.size())
            throw py::value_error("the model has " + std::to_string(prepared_->inputs.quantities.size()) +
                                  " input quantities, not " + std::to_string(x.size()));
        Eigen::VectorXd y(static_cast<Eigen::Index>(prepared_->model->outputs().size()));
        const bool valid = prepared_->model->evaluate({x.data(), static_cast<std::size_t>(x.size())},
                                                      {y.data(), static_cast<std::size_t>(y.size())});
        if (!valid) y.setConstant(std::nan(""));
        return y;
    }

    /// Inputs and outputs, a row for each trial.
    std::pair<Eigen::MatrixXd, Eigen::MatrixXd> trials(std::uint64_t count, std::uint64_t first,
                                                       std::optional<std::uint64_t> seed) const {
        ReplayedTrials replayed = value_or_raise([&] {
            const py::gil_scoped_release others_may_run;
            return replay_trials(*prepared_->propagated, seed.value_or(prepared_->options.seed), first,
                                 count);
        }());
        return {replayed.inputs.transpose(), replayed.outputs.transpose()};
    }

private:
    std::shared_ptr<const PreparedAnalysis> prepared_;
    MadeProject::Pointer made_;
};

class PythonProject {
public:
    explicit PythonProject(std::string file) : file_(std::move(file)) { load(); }

    void set(const std::string& pointer, const py::object& value) {
        values_.push_back({pointer, json_of(value)});
        try {
            load();
        } catch (...) {
            values_.pop_back();
            throw;
        }
    }

    std::vector<std::string> analyses() const {
        std::vector<std::string> ids;
        for (const AnalysisEntry& entry : made_->project().analyses) ids.push_back(entry.id);
        return ids;
    }

    Analysis analysis(const std::string& id) const { return {prepared(id), made_}; }

    /// As results.json has it, with the arrays of each analysis.
    py::dict evaluate(const std::vector<std::string>& chosen, std::optional<std::uint64_t> trials,
                      std::optional<std::uint64_t> seed) const {
        std::vector<EvaluatedAnalysis> evaluated;
        for (const std::string& id : chosen.empty() ? analyses() : chosen) {
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
            evaluated.push_back({std::move(analysis),
                                 std::make_shared<const UncertaintyResult>(std::move(result)),
                                 made_->warnings_of(id),
                                 {}});
        }
        py::dict results = from_json(results_json(made_->project(), evaluated));
        py::dict arrays;
        for (const EvaluatedAnalysis& e : evaluated) arrays[py::str(e.analysis->id)] = arrays_of(*e.result);
        results["arrays"] = arrays;
        return results;
    }

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
        arrays["covariance"] = result.covariance;
        return arrays;
    }

    std::string file_;
    std::vector<ValueAt> values_;
    MadeProject::Pointer made_;
};

}  // namespace

}  // namespace covaria

PYBIND11_MODULE(covaria, module) {
    using covaria::Analysis;
    using covaria::PythonProject;
    module.doc() = "Measurement uncertainty with Covaria's projects. All arrays are in SI units.";
    module.def(
        "load", [](const std::string& file) { return PythonProject(file); }, py::arg("file"),
        "A project from its file. ValueError with its place where the file is wrong.");
    py::class_<PythonProject>(module, "Project")
        .def_property_readonly("analyses", &PythonProject::analyses, "Ids of the analyses.")
        .def("analysis", &PythonProject::analysis, py::arg("id"), "KeyError: there is none of that id.")
        .def("set", &PythonProject::set, py::arg("pointer"), py::arg("value"),
             "Puts a value at a JSON pointer, as `covaria run --set` does. ValueError leaves all as it was.")
        .def("evaluate", &PythonProject::evaluate, py::arg("analyses") = std::vector<std::string>(),
             py::arg("trials") = py::none(), py::arg("seed") = py::none(),
             "The content of results.json, and under 'arrays' y, u, k, U and covariance of each analysis "
             "(SI). "
             "trials: 0 for the law of propagation only.");
    py::class_<Analysis>(module, "Analysis")
        .def_property_readonly("inputs", &Analysis::inputs, "Symbols of the input quantities.")
        .def_property_readonly("outputs", &Analysis::outputs, "Symbols of the outputs.")
        .def_property_readonly("estimates", &Analysis::estimates, "Estimates of the input quantities, SI.")
        .def("model", &Analysis::model, py::arg("x"), "y = f(x), SI; NaN where the model has no value.")
        .def("__call__", &Analysis::model, py::arg("x"))
        .def("trials", &Analysis::trials, py::arg("count"), py::arg("first") = 0,
             py::arg("seed") = py::none(),
             "(inputs, outputs), a row for each trial, exactly as the run had them; NaN without a value.");
}
