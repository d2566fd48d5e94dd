#include "study/app/pictures/picture_store.h"

#include <algorithm>

#include "stimuli/definition/looks/condition_tasks.h"
#include "stimuli/definition/looks/study_look.h"
#include "stimuli/definition/moving/clip_definition.h"
#include "study/trials/level_ladders.h"
#include "study/trials/participant_trials.h"
#include "study/trials/right_rule.h"
#include "study/trials/trial_picture.h"

namespace seamline::study::app {
namespace {

/// What names the click map of a trial's picture.
const std::string& truth_of(const RenderedSet& set, const Trial& trial) {
  return stimuli::truth_of(set.manifest.stimuli.at(trial.stimulus).stimulus);
}

/// How many pictures are held: of the trial before, the one that is due and the next.
std::size_t slots_of(const RenderedSet& set, const LevelLadders* ladders) {
  if (ladders == nullptr) {
    bool several = false;
    for (const TaskGroup& group : task_groups(set.study))
      several = several || shows_references(facts_of(group.task.get()));
    bool masked = false;
    for (const TaskGroup& group : task_groups(set.study)) masked = masked || facts_of(group.task.get()).masks;
    return (several ? 6U : 3U) + (masked ? 3U : 0U);
  }
  std::size_t longest = 0;
  for (const std::vector<int>& ladder : ladders->ladders) longest = std::max(longest, ladder.size());
  return 2 * longest;
}

}  // namespace

PictureStore::PictureStore(const RenderedSet& set, bool scaled)
    : set_(set),
      scaled_(scaled),
      ladders_(make_trial_rules(set).ladders),
      slots_(slots_of(set, ladders_.get())),
      loader_([&set](const Trial& trial) { return load_trial_picture(set, trial); }) {
  const int objects = objects_of(set.study);
  std::map<std::string, bool> two_eyes;
  for (const SceneDefinition& scene : list_truths(set.study))
    two_eyes[scene.truth] = scene.view.kind == ViewKind::side_by_side;
  for (int i = 0; i < std::ssize(set.manifest.stimuli); ++i) {
    const Trial trial{.stimulus = i};
    const std::string& truth = truth_of(set, trial);
    if (!objects_.contains(truth))
      objects_[truth] =
          shows_clips(set) ? objects_of_frames(set, trial)
          : is_panorama(set.study)
              ? std::vector{make_panorama_map(load_object_ids(set, trial), usual_reach_px, objects)}
              : std::vector{
                    make_object_map(load_object_ids(set, trial), usual_reach_px, two_eyes[truth], objects)};
  }
}

void PictureStore::prepare(const Trial& due, const std::optional<Trial>& after) {
  const std::vector<Trial> shown = pictures_of(due);
  std::vector<Trial> wanted;
  const auto want = [&](const std::vector<Trial>& pictures) {
    for (const Trial& picture : pictures)
      if (find(picture) == nullptr && std::find(wanted.begin(), wanted.end(), picture) == wanted.end())
        wanted.push_back(picture);
  };
  want(shown);
  if (after) want(pictures_of(*after));
  loader_.want(wanted);
  for (Slot& slot : slots_)
    if (slot.trial && std::find(shown.begin(), shown.end(), *slot.trial) != shown.end()) slot.used = ++clock_;
  for (const Trial& trial : wanted) fetch(trial);
}

void PictureStore::fetch(const Trial& trial) {
  const std::optional<ByteImage> picture = loader_.take(trial);
  if (!picture) return;
  Slot& slot = oldest_slot();
  slot.texture.upload(*picture);
  slot.texture.smooth(scaled_);
  slot.trial = trial;
  slot.used = ++clock_;
}

PictureStore::Slot& PictureStore::oldest_slot() {
  return *std::min_element(slots_.begin(), slots_.end(),
                           [](const Slot& a, const Slot& b) { return a.used < b.used; });
}

std::vector<Trial> PictureStore::pictures_of(const Trial& trial) const {
  if (ladders_) return pictures_of_ladder(*ladders_, trial);
  const TaskFacts task = facts_of(task_of(set_, trial).get());
  std::vector<Trial> pictures = shown_pictures(task, trial);
  if (task.masks) pictures.push_back({.kind = TrialKind::mask, .stimulus = trial.stimulus});
  return pictures;
}

const WindowTexture* PictureStore::find(const Trial& trial) const {
  for (const Slot& slot : slots_)
    if (slot.trial == trial) return &slot.texture;
  return nullptr;
}

const ObjectMap& PictureStore::objects(const Trial& trial) const {
  const std::vector<ObjectMap>& of_frames = objects_.at(truth_of(set_, trial));
  return player_ && playing_ == trial ? of_frames.at(player_->frame_on_screen()) : of_frames.front();
}

void PictureStore::play(const Trial& trial, std::int64_t now_ns) {
  if (!shows_clips(set_)) return;
  if (!player_ || playing_ != trial) {
    player_ = std::make_unique<ClipPlayer>(TrialClip(set_, trial), set_.study.clip->loops);
    playing_ = trial;
  }
  const std::optional<ByteImage> frame = player_->take(now_ns);
  if (!frame) return;
  const Trial shown = pictures_of(trial).front();
  for (Slot& slot : slots_)
    if (slot.trial == shown) slot.texture.upload(*frame);
}

void PictureStore::end_clip() {
  if (!player_) return;
  player_.reset();
  const std::optional<Trial> shown = playing_ ? std::optional(pictures_of(*playing_).front()) : std::nullopt;
  for (Slot& slot : slots_)
    if (slot.trial == shown) slot.trial.reset();
}

}  // namespace seamline::study::app
