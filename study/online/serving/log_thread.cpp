#include "study/online/serving/log_thread.h"

#include <utility>

namespace seamline::study::online {
namespace {

const HttpResponse not_stored = {.status = 503,
                                 .body =
                                     "{\"error\":\"log: wanted a disk that takes what is written, found one "
                                     "that does not: send it again later\",\"stored\":[]}"};

}  // namespace

LogThread::LogThread(Intake& intake) : intake_(intake), thread_([this] { run(); }) {}

LogThread::~LogThread() {
  finish();
}

void LogThread::add(LogWork work, Reply reply) {
  {
    const std::lock_guard guard(lock_);
    waiting_.push_back({.work = std::move(work), .reply = std::move(reply)});
  }
  wake_.notify_one();
}

void LogThread::finish() {
  {
    const std::lock_guard guard(lock_);
    ends_ = true;
  }
  wake_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void LogThread::run() {
  for (;;) {
    std::vector<Job> jobs;
    {
      std::unique_lock guard(lock_);
      wake_.wait(guard, [&] { return ends_ || !waiting_.empty(); });
      if (waiting_.empty()) return;
      jobs = std::exchange(waiting_, {});
    }
    commit(jobs);
    for (Job& job : jobs) job.reply(std::move(job.response));
  }
}

bool LogThread::try_commit(std::vector<Job*> jobs) {
  try {
    intake_.transaction([&] {
      for (Job* job : jobs) job->response = job->work(intake_);
    });
    ++transactions_;
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

void LogThread::commit(std::vector<Job>& jobs) {
  std::vector<Job*> all;
  for (Job& job : jobs) all.push_back(&job);
  if (try_commit(all)) return;
  for (Job& job : jobs)
    if (jobs.size() == 1 || !try_commit({&job})) job.response = not_stored;
}

}  // namespace seamline::study::online
