#include "study/app/pictures/picture_loader.h"

#include <algorithm>

namespace seamline::study::app {

PictureLoader::PictureLoader(Load load) : load_(std::move(load)), thread_([this] { work(); }) {}

PictureLoader::~PictureLoader() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

PictureLoader::Entry* PictureLoader::find(const Trial& trial) {
  const auto at =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.trial == trial; });
  return at == entries_.end() ? nullptr : &*at;
}

void PictureLoader::want(const std::vector<Trial>& trials) {
  const std::lock_guard lock(mutex_);
  std::vector<Entry> kept;
  for (const Trial& trial : trials) {
    Entry* entry = find(trial);
    kept.push_back(entry == nullptr ? Entry{.trial = trial} : std::move(*entry));
  }
  entries_ = std::move(kept);
  changed_.notify_all();
}

std::optional<ByteImage> PictureLoader::take(const Trial& trial) {
  const std::lock_guard lock(mutex_);
  Entry* entry = find(trial);
  if (entry == nullptr) return std::nullopt;
  if (entry->failure) std::rethrow_exception(entry->failure);
  if (!entry->picture) return std::nullopt;
  std::optional<ByteImage> picture = std::move(entry->picture);
  entries_.erase(entries_.begin() + (entry - entries_.data()));
  return picture;
}

void PictureLoader::work() {
  std::unique_lock lock(mutex_);
  while (!over_) {
    const auto next = std::find_if(entries_.begin(), entries_.end(), [](const Entry& e) { return !e.begun; });
    if (next == entries_.end()) {
      changed_.wait(lock);
      continue;
    }
    next->begun = true;
    const Trial trial = next->trial;
    lock.unlock();
    std::optional<ByteImage> picture;
    std::exception_ptr failure;
    try {
      picture = load_(trial);
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    if (Entry* entry = find(trial)) {  // still wanted
      entry->picture = std::move(picture);
      entry->failure = failure;
    }
  }
}

}  // namespace seamline::study::app
