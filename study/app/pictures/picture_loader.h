#pragma once
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "study/placement/trial.h"
#include "support/files/image.h"

namespace seamline::study::app {

/// Decodes pictures ahead on a thread of its own. It holds at most what is wanted: two pictures.
class PictureLoader {
 public:
  using Load = std::function<ByteImage(const Trial&)>;
  explicit PictureLoader(Load load);
  ~PictureLoader();
  PictureLoader(const PictureLoader&) = delete;
  PictureLoader& operator=(const PictureLoader&) = delete;

  /// What is needed from now on, the most urgent first; what was decoded for anything else is dropped.
  void want(const std::vector<Trial>& trials);

  /// The picture, once, when it is decoded. Throws what loading it threw.
  [[nodiscard]] std::optional<ByteImage> take(const Trial& trial);

 private:
  struct Entry {
    Trial trial;
    std::optional<ByteImage> picture = {};
    std::exception_ptr failure = {};
    bool begun = false;
  };
  void work();
  [[nodiscard]] Entry* find(const Trial& trial);

  Load load_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Entry> entries_;
  bool over_ = false;
  std::thread thread_;
};

}  // namespace seamline::study::app
