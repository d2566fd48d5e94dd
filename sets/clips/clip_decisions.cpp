#include "sets/clips/clip_decisions.h"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "sets/clips/decision_file.h"
#include "stimuli/definition/clip_frames.h"
#include "support/files/hash.h"

namespace seamline::renderer {
namespace {

constexpr std::size_t deciding_frames = 4;

/// Names that belong together, by a forest of parents.
class Together {
 public:
  void join(const std::string& a, const std::string& b) { parents_[root(b)] = root(a); }
  [[nodiscard]] const std::string& root(const std::string& name) {
    const std::string* one = &name;
    while (true) {
      const auto found = parents_.try_emplace(*one, *one).first;
      if (found->second == *one) return found->first;
      one = &found->second;
    }
  }

 private:
  std::map<std::string, std::string> parents_;
};

}  // namespace

/// Estimators of the frames that decide for a group of truths; they hold to what was decided.
struct ClipDecisions::Deciding {
  std::string group;
  std::vector<TruthScene> scenes = {};
  std::vector<std::unique_ptr<SceneEstimator>> estimators = {};
};

std::vector<std::string> evenly(const std::vector<std::string>& members, std::size_t most) {
  if (members.size() <= most) return members;
  std::vector<std::string> out;
  for (std::size_t i = 0; i < most; ++i) out.push_back(members[(2 * i + 1) * members.size() / (2 * most)]);
  return out;
}

ClipDecisions::~ClipDecisions() = default;

ClipDecisions::ClipDecisions(const StudyDefinition& shown, ClipDecisionSubject subject)
    : subject_(std::move(subject)) {
  Together truths, stimuli;
  for (const Clip& clip : list_clips(shown))
    for (const Stimulus& frame : clip.frames) {
      truths.join(truth_of(clip.frames.front()), truth_of(frame));
      stimuli.join(stimulus_id(clip.frames.front()), stimulus_id(frame));
    }
  std::map<std::string, std::size_t> groups;
  for (const SceneDefinition& scene : list_truths(subject_.study)) {
    scenes_.emplace(scene.truth, scene);
    const auto [group, added] = groups.emplace(truths.root(scene.truth), truth_groups_.size());
    if (added) truth_groups_.push_back({.name = "truth-" + scene.truth, .members = {}});
    truth_groups_[group->second].members.push_back(scene.truth);
    group_of_truth_[scene.truth] = group->second;
  }
  for (const Group& group : truth_groups_) deciding_.push_back(evenly(group.members, deciding_frames));
  groups.clear();
  for (const Stimulus& frame : list_stimuli(subject_.study)) {
    const std::string id = stimulus_id(frame);
    const auto [group, added] = groups.emplace(stimuli.root(id), stimulus_groups_.size());
    if (added) stimulus_groups_.push_back({.name = id, .members = {}});
    stimulus_groups_[group->second].members.push_back(id);
    group_of_stimulus_[id] = group->second;
    truth_of_stimulus_[id] = truth_of(frame);
  }
  // A stimulus that none of the deciding frames has is decided by its own middle one too.
  for (const Group& group : stimulus_groups_) {
    auto& deciding = deciding_[group_of_truth_.at(truth_of_stimulus_.at(group.members.front()))];
    const bool has_one = std::any_of(group.members.begin(), group.members.end(), [&](const auto& id) {
      return std::find(deciding.begin(), deciding.end(), truth_of_stimulus_.at(id)) != deciding.end();
    });
    if (!has_one) deciding.push_back(truth_of_stimulus_.at(group.members[group.members.size() / 2]));
  }
  for (std::size_t g = 0; g < truth_groups_.size(); ++g) {
    std::string inputs;
    for (const std::string& truth : deciding_[g]) inputs += subject_.inputs_of_truth(truth);
    truth_groups_[g].inputs = sha256(inputs);
  }
  std::map<std::string, std::string> inputs;
  for (const Stimulus& frame : list_stimuli(subject_.study))
    stimulus_groups_[group_of_stimulus_.at(stimulus_id(frame))].inputs += subject_.inputs_of_stimulus(frame);
  for (Group& group : stimulus_groups_)
    group.inputs =
        sha256(truth_groups_[group_of_truth_.at(truth_of_stimulus_.at(group.members.front()))].inputs +
               group.inputs);
}

const PhotographDecision& ClipDecisions::of_truth(const std::string& truth) {
  const Group& group = truth_groups_[group_of_truth_.at(truth)];
  if (const auto known = of_truths_.find(group.name); known != of_truths_.end()) return known->second;
  if (auto read = read_photograph_decision(subject_.set_folder, group.name, group.inputs))
    return of_truths_.emplace(group.name, std::move(*read)).first->second;
  (void)open(group);
  return of_truths_.at(group.name);
}

void ClipDecisions::hold(SceneEstimator& estimator, const std::string& truth) {
  estimator.hold_to(of_truth(truth));
  estimator.sample_beside([this, truth] { return base_of(truth); });
}

std::shared_ptr<const FrameBase> ClipDecisions::base_of(const std::string& truth) {
  const std::size_t g = group_of_truth_.at(truth);
  if (truth_groups_[g].members.size() <= deciding_[g].size()) return nullptr;
  if (base_ && group_of_base_ == g) return base_;
  const std::string& frame = deciding_[g][deciding_[g].size() / 2];
  const TruthScene scene = subject_.moving.load(scenes_.at(frame));
  const auto estimator = subject_.estimator_of(scene);
  estimator->hold_to(of_truth(frame));
  base_ = estimator->frame_base([&](double) { subject_.tell("samples of " + frame); });
  group_of_base_ = g;
  return base_;
}

const StimulusDecision& ClipDecisions::of_stimulus(const std::string& id) {
  const Group& group = stimulus_groups_[group_of_stimulus_.at(id)];
  if (const auto known = of_stimuli_.find(group.name); known != of_stimuli_.end()) return known->second;
  if (auto read = read_stimulus_decision(subject_.set_folder, group.name, group.inputs))
    return of_stimuli_.emplace(group.name, std::move(*read)).first->second;
  decide_stimuli(truth_groups_[group_of_truth_.at(truth_of_stimulus_.at(id))]);
  return of_stimuli_.at(group.name);
}

/// The estimators of the frames that decide, and what they come to for the photograph.
ClipDecisions::Deciding& ClipDecisions::open(const Group& truths) {
  if (open_ && open_->group == truths.name) return *open_;
  open_ = std::make_unique<Deciding>(Deciding{.group = truths.name});
  auto known = of_truths_.find(truths.name);
  PhotographDecision joined;
  for (const std::string& truth : deciding_[group_of_truth_.at(truths.members.front())]) {
    subject_.tell("samples of " + truth);
    open_->scenes.push_back(subject_.moving.load(scenes_.at(truth)));
    open_->estimators.push_back(subject_.estimator_of(open_->scenes.back()));
    if (known == of_truths_.end())
      join_decisions(open_->estimators.back()->photograph_decision(
                         [&](double) { subject_.tell("samples of " + truth); }),
                     joined);
  }
  if (known == of_truths_.end()) {
    write_decision(subject_.set_folder, truths.name, truths.inputs, joined);
    known = of_truths_.emplace(truths.name, std::move(joined)).first;
  }
  for (const auto& estimator : open_->estimators) estimator->hold_to(known->second);
  return *open_;
}

/// All that are rendered and nobody decided yet.
void ClipDecisions::decide_stimuli(const Group& truths) {
  Deciding& deciding = open(truths);
  std::set<std::size_t> undecided;
  for (const Stimulus& one : subject_.wanted) {
    const std::string id = stimulus_id(one);
    const std::size_t group = group_of_stimulus_.at(id);
    if (group_of_truth_.at(truth_of_stimulus_.at(id)) == group_of_truth_.at(truths.members.front()) &&
        !of_stimuli_.contains(stimulus_groups_[group].name) &&
        !read_stimulus_decision(subject_.set_folder, stimulus_groups_[group].name,
                                stimulus_groups_[group].inputs))
      undecided.insert(group);
  }
  for (std::size_t frame = 0; frame < deciding.scenes.size(); ++frame) {
    using Mesh = std::tuple<int, std::string, DepthSettings>;
    std::map<Mesh, std::vector<Stimulus>> by_mesh;
    for (const Stimulus& stimulus : subject_.stimuli.at(deciding.scenes[frame].definition.truth)) {
      if (!undecided.contains(group_of_stimulus_.at(stimulus_id(stimulus)))) continue;
      const std::optional<SceneDefinition> captured = captured_scene(subject_.study, stimulus);
      by_mesh[{stimulus.object_index, captured ? canonical_text(*captured) : std::string(), stimulus.depth}]
          .push_back(stimulus);
    }
    int taken = 0;
    for (const auto& [mesh, of_mesh] : by_mesh) {
      if (std::get<int>(mesh) != taken)
        deciding.estimators[frame]->take_object(taken = std::get<int>(mesh), [&](double) {
          subject_.tell("samples of " + deciding.scenes[frame].definition.truth);
        });
      decide_mesh(deciding, frame, of_mesh);
    }
  }
  for (const std::size_t group : undecided)
    write_decision(subject_.set_folder, stimulus_groups_[group].name, stimulus_groups_[group].inputs,
                   of_stimuli_.at(stimulus_groups_[group].name));
}

void ClipDecisions::decide_mesh(Deciding& deciding, std::size_t frame, const std::vector<Stimulus>& of_mesh) {
  const TruthScene& scene = deciding.scenes[frame];
  SceneEstimator& estimator = *deciding.estimators[frame];
  const bool needed = std::any_of(of_mesh.begin(), of_mesh.end(), [](const Stimulus& one) {
    return recipe(one.artifact, one.isolation).answers.needs_depth();
  });
  std::optional<LocalScene> depth;
  if (needed) depth.emplace(subject_.depth_of(scene, estimator, of_mesh.front()));
  for (const Stimulus& stimulus : of_mesh) {
    const std::string id = stimulus_id(stimulus);
    const EstimatedStimulus made = estimator.stimulus(recipe(stimulus.artifact, stimulus.isolation),
                                                      depth ? depth->world() : DepthWorld(nullptr),
                                                      [&](double) { subject_.tell("samples of " + id); });
    join_decisions(*made.decision, of_stimuli_[stimulus_groups_[group_of_stimulus_.at(id)].name]);
  }
}

}  // namespace seamline::renderer
