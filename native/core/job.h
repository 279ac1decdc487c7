// Long work in a thread of its own, for a caller that has an interface to keep awake.
//
// The work begins at once and knows of its caller only that it should stop. Whoever owns the job
// looks at it now and then; nothing calls back.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "core/progress.h"

namespace illustrate {

class Job {
 public:
  using Work = std::function<void(const Progress&)>;

  // How far it is: a share in [0, 1] that never falls, and the name of the stage.
  struct State {
    double fraction = 0;
    std::string stage;
  };

  // `work` and what it holds are destroyed in the thread as soon as the work ends.
  explicit Job(Work work);
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;
  // Cancels, and waits for the next report of progress.
  ~Job();

  State state() const;
  bool is_done() const;
  // Asks the work to stop, and does not wait.
  void cancel();
  // Waits for the end, at most so long; true when it has come.
  bool wait(double seconds) const;
  // Throws what the work threw, Cancelled among it; nothing before it is done.
  void rethrow() const;

 private:
  void run(Work& work);
  bool report(double fraction, const std::string& stage);

  mutable std::mutex mutex_;
  mutable std::condition_variable ended_;
  State state_;
  bool is_cancelled_ = false;
  bool is_done_ = false;
  std::exception_ptr failure_;
  std::thread thread_;  // last: it uses the others
};

}  // namespace illustrate
