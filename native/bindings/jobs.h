// Jobs as Python sees them. They hold no Python object and never take the GIL: neither an
// interpreter that ends nor a thread of Python's that waits for a job can lock up with it.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <memory>
#include <optional>

#include "core/job.h"

namespace illustrate::bindings {

namespace py = pybind11;

class PythonJob {
 public:
  PythonJob(Job::Work work, std::function<py::object()> result)
      : job_(std::move(work)), result_(std::move(result)) {}

  Job& job() { return job_; }
  // Throws what the work threw, and InvalidInput before the end.
  py::object result() const;

 private:
  Job job_;
  std::function<py::object()> result_;
};

using JobPointer = std::shared_ptr<PythonJob>;

// Cancelled and waited for when the interpreter ends.
void remember(const JobPointer& job);

// Starts make(progress), which holds no Python object; py::cast takes what it returns.
template <class Make>
JobPointer start_job(Make make) {
  using Result = std::invoke_result_t<Make&, const Progress&>;
  const auto made = std::make_shared<std::optional<Result>>();
  auto job = std::make_shared<PythonJob>(
      [make = std::move(make), made](const Progress& progress) { *made = make(progress); },
      [made] { return py::cast(made->value()); });
  remember(job);
  return job;
}

}  // namespace illustrate::bindings
