// Work that is started, looked at, stopped and taken.
#include "bindings/jobs.h"

#include <algorithm>
#include <vector>

#include "bindings/bind.h"

namespace illustrate::bindings {
namespace {

// Those that may still run; only touched with the GIL.
std::vector<std::weak_ptr<PythonJob>>& started_jobs() {
  static std::vector<std::weak_ptr<PythonJob>> jobs;
  return jobs;
}

// Of all jobs: nothing runs on when the interpreter ends.
void stop_jobs() {
  std::vector<JobPointer> running;
  for (const auto& started : started_jobs()) {
    // Held until all have ended: without the GIL another thread may let go of the last reference.
    if (JobPointer job = started.lock()) running.push_back(std::move(job));
  }
  for (const JobPointer& job : running) job->job().cancel();
  const py::gil_scoped_release release;
  for (const JobPointer& job : running) {
    while (!job->job().wait(1)) {
    }
  }
}

bool wait_for(PythonJob& job, double seconds) {
  const py::gil_scoped_release release;
  return job.job().wait(seconds);
}

py::tuple poll(PythonJob& job) {
  const Job::State state = job.job().state();
  return py::make_tuple(state.fraction, state.stage);
}

}  // namespace

py::object PythonJob::result() const {
  if (!job_.is_done()) throw InvalidInput("the job is not done: look at is_done, or wait");
  job_.rethrow();
  return result_();
}

void remember(const JobPointer& job) {
  auto& jobs = started_jobs();
  jobs.erase(
      std::remove_if(jobs.begin(), jobs.end(), [](const auto& old) { return old.expired(); }),
      jobs.end());
  jobs.push_back(job);
}

void bind_jobs(py::module_& m) {
  using namespace py::literals;
  py::class_<PythonJob, JobPointer>(m, "Job", "Work in a thread of its own.")
      .def_property_readonly("is_done", [](PythonJob& job) { return job.job().is_done(); })
      .def("poll", &poll, "How far it is: a share, and the stage.")
      .def(
          "cancel", [](PythonJob& job) { job.job().cancel(); }, "Asks it to stop.")
      .def("wait", &wait_for, "seconds"_a, "Waits at most so long; True when it is done.")
      .def("result", &PythonJob::result, "What it made; raises what went wrong.");
  m.def("stop_jobs", &stop_jobs, "Cancels all jobs and waits for their ends.");
  // Python's own atexit runs while the interpreter still stands; a destructor of C++ comes after.
  py::module_::import("atexit").attr("register")(py::cpp_function(&stop_jobs));
}

}  // namespace illustrate::bindings
