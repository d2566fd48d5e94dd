#include "sets/clips/frame_changes.h"

#include <set>

namespace seamline::renderer {

bool is_judged(const std::string& truth, int frames) {
  const std::size_t mark = truth.rfind('@');
  return frames <= 16 || mark == std::string::npos || std::stoi(truth.substr(mark + 1)) % 8 < 2;
}

FrameChanges::FrameChanges(const StudyDefinition& shown) {
  if (!shown.clip) return;
  std::size_t number = 0;
  for (const Clip& clip : list_clips(shown)) {
    std::set<std::string> seen;
    std::string before;
    Place* place = nullptr;
    for (const Stimulus& frame : clip.frames) {
      const std::string id = stimulus_id(frame);
      if (seen.insert(id).second) {
        place = &places_[id].emplace_back(Place{.clip = number, .before = before});
      }
      before = id;
    }
    if (place != nullptr) place->is_last = true;
    ++number;
  }
}

std::map<std::string, double> FrameChanges::add(const std::string& frame, ErrorMap map) {
  std::map<std::string, double> out;
  const auto found = places_.find(frame);
  if (found == places_.end()) return out;
  const auto shared = std::make_shared<const ErrorMap>(std::move(map));
  for (const Place& place : found->second) {
    const auto last = last_.find(place.clip);
    if (last != last_.end() && last->second.frame == place.before && !out.contains(place.before))
      out[place.before] = change_error(*last->second.map, *shared);
    if (place.is_last)
      last_.erase(place.clip);
    else
      last_[place.clip] = {frame, shared};
  }
  return out;
}

ClipChangeError clip_change_error(const std::vector<std::string>& frames, const FrameChangeErrors& errors) {
  ClipChangeError out;
  for (std::size_t k = 1; k < frames.size(); ++k) {
    ++out.changes;
    const auto found = errors.find({frames[k], frames[k - 1]});
    if (frames[k] != frames[k - 1] && found == errors.end()) continue;
    ++out.known;
    if (frames[k] != frames[k - 1]) out.squared += found->second;
  }
  if (out.known > 0) out.squared /= out.known;
  return out;
}

}  // namespace seamline::renderer
