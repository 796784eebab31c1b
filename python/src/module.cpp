// SPDX-License-Identifier: MIT
// spear._native: the SDK for Python. Binding only; see _native.pyi for what each thing is.

#include <chrono>

#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/vector.h>

#include "classes.hpp"
#include "session.hpp"
#include "spear_wire.h"

namespace spear::python {

void set_python_error(const detail::ErrorBase& error) {
    const ErrorInfo& info = error.info();
    nb::object python_class = nb::borrow(PyDict_GetItemString(classes.errors, std::string(error.name()).c_str()));
    nb::object made = python_class(info.message, info.operation, info.argument, info.expected);
    if (const ErrorInfo* original = error.original()) {
        nb::object original_class =
            nb::borrow(PyDict_GetItemString(classes.errors, std::string(error_name(original->code)).c_str()));
        nb::object cause =
            original_class(original->message, original->operation, original->argument, original->expected);
        PyException_SetCause(made.ptr(), cause.release().ptr());
    }
    PyErr_SetObject(python_class.ptr(), made.ptr());
}

void translate_current_exception() noexcept {
    try {
        try {
            throw;
        } catch (nb::python_error& error) {
            error.restore();
        } catch (const detail::ErrorBase& error) {
            set_python_error(error);
        } catch (const std::bad_alloc&) {
            PyErr_NoMemory();
        } catch (const std::exception& error) {
            PyErr_SetString(PyExc_RuntimeError, error.what());
        }
    } catch (nb::python_error& error) { // the error's own class could not be made
        error.restore();
    } catch (const std::exception& error) {
        PyErr_SetString(PyExc_RuntimeError, error.what());
    }
}

namespace {

const char* runs_on_name(RunsOn thread) {
    return thread == RunsOn::game_thread ? "game_thread" : thread == RunsOn::any_frame ? "any_frame" : "server_thread";
}

SessionOptions session_options(const std::string& address, nb::bytes token, std::uint32_t lease_ms,
    std::uint32_t deadline_ms, std::uint32_t timeout_ms, bool channel, bool spin) {
    SessionOptions options;
    options.channel = channel;
    options.spin = spin;
    options.address = address;
    options.token.assign(static_cast<const char*>(token.data()), token.size());
    options.no_lease = lease_ms == SPEAR_LEASE_OFF;
    options.lease = Milliseconds(options.no_lease ? 0 : lease_ms);
    if (deadline_ms != 0) {
        options.deadline = Milliseconds(deadline_ms);
    }
    options.connect_timeout = Milliseconds(timeout_ms);
    return options;
}

nb::object wrap(Instance instance) {
    return nb::cast(new PySession(std::move(instance)), nb::rv_policy::take_ownership);
}

nb::object connect_python(const std::string& address, nb::bytes token, std::uint32_t lease_ms,
    std::uint32_t deadline_ms, std::uint32_t timeout_ms, bool channel, bool spin) {
    const SessionOptions options =
        session_options(address, token, lease_ms, deadline_ms, timeout_ms, channel, spin);
    std::optional<Instance> instance;
    {
        const nb::gil_scoped_release unlock;
        instance.emplace(spear::connect(address, options));
    }
    return wrap(std::move(*instance));
}

nb::object launch_python(const std::string& scene, const std::string& executable,
    const std::vector<std::string>& arguments, double fps, double fixed_dt, const std::string& address, bool paused,
    const std::string& log_file, nb::bytes token, std::uint32_t lease_ms, std::uint32_t deadline_ms,
    std::uint32_t timeout_ms, bool channel, bool spin) {
    LaunchOptions options;
    options.token.assign(static_cast<const char*>(token.data()), token.size());
    options.channel = channel;
    options.spin = spin;
    options.scene = scene;
    options.executable = executable;
    options.arguments = arguments;
    if (fps >= 0)
        options.fps = fps;
    if (fixed_dt > 0)
        options.fixed_dt = fixed_dt;
    options.address = address;
    options.paused = paused;
    options.log_file = log_file;
    options.no_lease = lease_ms == SPEAR_LEASE_OFF;
    options.lease = Milliseconds(options.no_lease ? 0 : lease_ms);
    if (deadline_ms != 0)
        options.deadline = Milliseconds(deadline_ms);
    options.connect_timeout = Milliseconds(timeout_ms);
    std::optional<Instance> instance;
    {
        const nb::gil_scoped_release unlock;
        instance.emplace(spear::launch(options));
    }
    return wrap(std::move(*instance));
}

nb::tuple statistics_python(PySession& self) {
    Session::Statistics found;
    {
        const nb::gil_scoped_release unlock;
        found = self.session()->statistics();
    }
    const auto traffic = [](const Session::Traffic& one) { return nb::make_tuple(one.messages, one.bytes); };
    return nb::make_tuple(traffic(found.sent), traffic(found.received), traffic(found.server_received),
        traffic(found.server_sent), found.kept_results);
}

nb::list list_engines() {
    nb::list engines;
    spear_list_engines(nullptr, &engines, [](void* user, const char* address, std::uint64_t process_id) {
        static_cast<nb::list*>(user)->append(nb::make_tuple(address, process_id));
    });
    return engines;
}

nb::list remove_leftovers(bool logs_too) {
    nb::list removed;
    spear_remove_leftovers(nullptr, logs_too, &removed,
        [](void* user, const char* path) { static_cast<nb::list*>(user)->append(path); });
    return removed;
}

nb::dict describe_engine(const std::string& address, std::uint32_t timeout_ms) {
    spear_description description{};
    spear_wire_error error{};
    int failed = 0;
    {
        const nb::gil_scoped_release unlock;
        failed = spear_describe(address.c_str(), timeout_ms, &description, &error);
    }
    if (failed) {
        throw_error(static_cast<ErrorCode>(error.code), error.message);
    }
    nb::dict result;
    result["spear_version"] = description.spear_version;
    result["engine"] = description.engine;
    result["scene"] = description.scene;
    result["process_id"] = description.process_id;
    result["sessions"] = description.sessions;
    result["project"] = description.project;
    result["frame"] = description.frame;
    result["uptime"] = static_cast<double>(description.uptime_ms) / 1000;
    return result;
}

/// A recording; its end does not wait for the engine with Python's lock held.
struct PyTrace {
    std::unique_ptr<Trace> trace;

    explicit PyTrace(std::unique_ptr<Trace> made) : trace(std::move(made)) {}
    PyTrace(const PyTrace&) = delete;
    PyTrace& operator=(const PyTrace&) = delete;
    ~PyTrace() {
        const nb::gil_scoped_release unlock;
        trace.reset();
    }
};

void setup(const nb::kwargs& given) {
    const auto take = [&](const char* name) { return Py_NewRef(nb::object(given[name]).ptr()); };
    classes.object = take("object_class");
    classes.struct_base = take("struct_base");
    classes.struct_class = take("struct_class");
    classes.enum_class = take("enum_class");
    classes.enum_entries = take("enum_entries");
    classes.result_class = take("result_class");
    classes.null_result = take("null_result");
    classes.parameter_name = take("parameter_name");
    classes.errors = take("errors");
    classes.future_object = take("future_object");
    classes.member = take("member_class");
    classes.async_namespace = take("async_namespace");
    classes.send_namespace = take("send_namespace");
    classes.renamed = take("renamed");
    classes.unreal_name_of = take("unreal_name_of");
    classes.check_assignment = take("check_assignment");
    // Python before 3.12 does not hand the quick way of calling down to classes that derive.
    auto* const member = reinterpret_cast<PyTypeObject*>(classes.member);
    member->tp_flags |= Py_TPFLAGS_HAVE_VECTORCALL;
    PyType_Modified(member);
}

/// Arguments that come as a tuple and a dict: names are interned, so that they are found by identity.
class UnpackedArguments {
public:
    UnpackedArguments(nb::tuple args, nb::dict kwargs) {
        for (Py_ssize_t i = 0; i < PyTuple_GET_SIZE(args.ptr()); ++i) {
            values_.push_back(PyTuple_GET_ITEM(args.ptr(), i));
        }
        const Py_ssize_t count = PyDict_Size(kwargs.ptr());
        if (count != 0) {
            keywords_ = nb::steal(PyTuple_New(count));
            if (!keywords_.is_valid()) {
                throw nb::python_error();
            }
            PyObject *name = nullptr, *value = nullptr;
            Py_ssize_t position = 0;
            for (Py_ssize_t i = 0; PyDict_Next(kwargs.ptr(), &position, &name, &value); ++i) {
                PyTuple_SET_ITEM(keywords_.ptr(), i, Py_NewRef(name));
                values_.push_back(value);
            }
        }
        arguments = {values_.data(), PyTuple_GET_SIZE(args.ptr()), keywords_.is_valid() ? keywords_.ptr() : nullptr};
    }
    Arguments arguments;

private:
    std::vector<PyObject*> values_;
    nb::object keywords_;
};

/// The path of a text, for one operation.
nb::object path_of(nb::str text) { return nb::steal(reinterpret_cast<PyObject*>(path_of_text(text.ptr()))); }

} // namespace

NB_MODULE(_native, module) {
    nb::set_leak_warnings(false); // objects that outlive the interpreter's shutdown order are no defect of a script

    nb::register_exception_translator([](const std::exception_ptr& pointer, void*) {
        try {
            std::rethrow_exception(pointer);
        } catch (const detail::ErrorBase& error) {
            set_python_error(error);
        }
    });

    module.attr("__version__") = spear::version;
    module.attr("SYNC") = static_cast<int>(sync_mode);
    module.attr("ASYNC") = static_cast<int>(async_mode);
    module.attr("SEND") = static_cast<int>(send_mode);
    module.attr("RAW") = static_cast<int>(raw_mode);
    module.attr("LEASE_OFF") = static_cast<std::uint32_t>(SPEAR_LEASE_OFF);

    nb::list error_list;
    for (const ErrorRow& row : error_rows) {
        error_list.append(nb::make_tuple(row.name, error_name(row.parent), row.meaning));
    }
    module.attr("ERROR_ROWS") = error_list;
    nb::list entry_point_list;
    AllEntryPoints::for_each([&](auto entry) {
        using E = decltype(entry);
        nb::list parameters;
        for (const std::string_view name : E::parameters) {
            parameters.append(name);
        }
        entry_point_list.append(
            nb::make_tuple(E::name, parameters, runs_on_name(E::runs_on), E::documentation, E::signature()));
    });
    module.attr("ENTRY_POINTS") = entry_point_list;

    make_native_types(module);

    nb::class_<PySession>(module, "Session")
        .def_prop_ro("address", [](PySession& self) { return self.session()->address(); })
        .def_prop_ro("session_id", [](PySession& self) { return self.session()->id(); })
        .def_prop_ro("serial", [](PySession& self) { return self.serial; })
        .def_prop_ro("process_id",
            [](PySession& self) -> std::optional<std::int64_t> {
                const EngineProcess* process = self.instance().process();
                return process ? std::optional(process->process_id()) : std::nullopt;
            })
        .def("statistics", &statistics_python)
        .def_prop_ro("uses_channel", [](PySession& self) { return self.session()->uses_channel(); })
        .def_prop_ro("is_open", [](PySession& self) { return self.session()->is_open(); })
        .def("begin_block", &PySession::begin_block)
        .def("end_block", &PySession::end_block)
        .def("close_block", &PySession::close_block)
        .def("abort_block", &PySession::abort_block)
        .def("flush", &PySession::flush)
        .def("close", &PySession::close)
        .def("call", [](nb::handle self, std::string_view entry_point, nb::tuple args, nb::dict kwargs,
                         int mode) { return PySession::call(self, entry_point, args, kwargs, mode); })
        .def("call_function",
            [](nb::handle self, nb::handle target, nb::str function, nb::tuple args, nb::dict kwargs, int mode) {
                const UnpackedArguments unpacked(args, kwargs);
                const nb::object path = path_of(function);
                return PySession::call_function(self, target, as<NativePath>(path.ptr()), unpacked.arguments, mode);
            })
        .def("call_many", &PySession::call_many)
        .def("get_property",
            [](nb::handle self, nb::handle target, nb::str text, int mode) {
                const nb::object path = path_of(text);
                return PySession::get_property(self, target, as<NativePath>(path.ptr()), mode);
            })
        .def(
            "set_property",
            [](nb::handle self, nb::handle target, nb::str text, nb::handle value, int mode) {
                const nb::object path = path_of(text);
                return PySession::set_property(self, target, as<NativePath>(path.ptr()), value, mode);
            },
            nb::arg("target"), nb::arg("path"), nb::arg("value").none(), nb::arg("mode"));

    module.def("connect", &connect_python, nb::kw_only(), nb::arg("address"), nb::arg("token"), nb::arg("lease_ms"),
        nb::arg("deadline_ms"), nb::arg("timeout_ms"), nb::arg("channel"), nb::arg("spin"));
    module.def("launch", &launch_python, nb::kw_only(), nb::arg("scene"), nb::arg("executable"), nb::arg("arguments"),
        nb::arg("fps"), nb::arg("fixed_dt"), nb::arg("address"), nb::arg("paused"), nb::arg("log_file"),
        nb::arg("token"), nb::arg("lease_ms"), nb::arg("deadline_ms"), nb::arg("timeout_ms"), nb::arg("channel"),
        nb::arg("spin"));
    nb::class_<PyTrace>(module, "Trace")
        .def("__init__",
            [](PyTrace* self, PySession& session, const std::string& file, bool operations, std::uint64_t events) {
                const nb::gil_scoped_release unlock;
                TraceOptions options{.file = file, .operations = operations};
                if (events != 0)
                    options.events_per_thread = events;
                new (self) PyTrace{std::make_unique<Trace>(session.session(), std::move(options))};
            },
            nb::arg("session"), nb::arg("file"), nb::arg("operations"), nb::arg("events_per_thread"))
        .def("stop", [](PyTrace& self) {
            const nb::gil_scoped_release unlock;
            self.trace->stop();
        });

    module.def("list_engines", &list_engines);
    module.def("describe_engine", &describe_engine, nb::arg("address"), nb::arg("timeout_ms"));
    module.def("remove_leftovers", &remove_leftovers, nb::arg("logs_too"));
    module.def("setup", &setup);
    module.def("forget_names", &forget_names);
}

} // namespace spear::python
