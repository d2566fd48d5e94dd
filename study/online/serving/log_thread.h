#pragma once
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "study/online/intake/intake.h"
#include "study/online/serving/http_server.h"

namespace seamline::study::online {

/// What is done with the log, and says how it is answered. May be run twice: when a transaction of several
/// fails, each is tried alone.
using LogWork = std::function<HttpResponse(Intake&)>;

/// The one thread that touches the log. What comes in while a transaction is flushed to the disk becomes the
/// next transaction, so many people share a flush; an answer leaves after its commit.
class LogThread {
 public:
  /// `intake` must live longer, and belongs to the thread until `finish`.
  explicit LogThread(Intake& intake);
  ~LogThread();
  LogThread(const LogThread&) = delete;
  LogThread& operator=(const LogThread&) = delete;

  void add(LogWork work, Reply reply);
  /// Does what is left, and ends.
  void finish();

  [[nodiscard]] std::int64_t transactions() const { return transactions_; }

 private:
  struct Job {
    LogWork work;
    Reply reply;
    HttpResponse response = {};
  };
  void run();
  void commit(std::vector<Job>& jobs);
  [[nodiscard]] bool try_commit(std::vector<Job*> jobs);

  Intake& intake_;
  std::mutex lock_;
  std::condition_variable wake_;
  std::vector<Job> waiting_;
  bool ends_ = false;
  std::atomic<std::int64_t> transactions_ = 0;
  std::thread thread_;
};

}  // namespace seamline::study::online
