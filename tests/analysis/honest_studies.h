#pragma once
#include <string>
#include <vector>

#include "stimuli/definition/stimulus.h"
#include "study/observers/observer.h"
#include "tests/analysis/threshold_people.h"

namespace seamline::test {

/// A study of simulated people who look and answer as well as they can, for the screens to judge.
struct HonestStudy {
  std::string name;
  std::vector<Artifact> artifacts = {paper_artifacts.begin(), paper_artifacts.end()};
  std::vector<int> widths_px = {paper_widths_px.begin(), paper_widths_px.end()};
  int objects = 3;
  int people = 20;
  ObserverKind observer = ObserverKind::threshold;
  ObserverDefinition definition = {};
  double object_sd_octaves = 0;  ///< `image`: how much objects of an artifact differ in what is seen of them
  int staircase_trials = 0;  ///< 0: every stimulus once; else placed by the answers, a staircase an artifact
};

namespace detail {

/// What the `image` observer sees of a stimulus: falls by half an octave for each octave of width.
inline double visible_difference(const HonestStudy& study, const Stimulus& stimulus) {
  Random of_object(mix_bits(static_cast<std::uint64_t>(stimulus.artifact)),
                   static_cast<std::uint64_t>(stimulus.object_index));
  const double midpoint = std::log2(study.definition.midpoint.at(stimulus.artifact)) +
                          study.object_sd_octaves * of_object.normal();
  return std::exp2((midpoint - std::log2(stimulus.level)) / 2);
}

struct ShownPerson {
  std::string code;
  Observer observer;
  bool random = false;
};

inline void answer_one(LogContents& log, const ShownPerson& person, const Stimulus& stimulus,
                       Random& random) {
  Response response{};
  if (person.random) {
    response.chosen_index = 1 + static_cast<int>(random.below(3));
    response.rating = 1 + static_cast<int>(random.below(4));
  } else {
    response = respond(person.observer, stimulus, random);
  }
  log.answers.push_back(answer(person.code, static_cast<int>(stimulus.level), stimulus.object_index,
                               response.chosen_index, response.rating));
  log.answers.back().artifact = stimulus.artifact;
  log.answers.back().object = stimulus.object;
}

}  // namespace detail

/// Its log, with `random` people more who choose and rate at random ("random0", ...).
inline LogContents simulate_honest_study(const HonestStudy& study, int random_people, std::uint64_t seed) {
  LogContents log;
  log.file = "simulated.sqlite";
  const auto differences = std::make_shared<VisibleDifferences>();
  std::vector<std::vector<std::vector<Stimulus>>> stimuli;  // artifact, width, object
  for (const Artifact artifact : study.artifacts) {
    stimuli.emplace_back();
    for (const int width_px : study.widths_px) {
      stimuli.back().emplace_back();
      for (int object = 1; object <= study.objects; ++object) {
        Stimulus stimulus;
        stimulus.scene = "scene";
        stimulus.artifact = artifact;
        stimulus.object = "object" + std::to_string(object);
        stimulus.object_index = 1 + (object - 1) % 3;
        stimulus.depth.width_px = width_px;
        stimulus.level = width_px;
        (*differences)[stimulus_id(stimulus)].above_floor = detail::visible_difference(study, stimulus);
        stimuli.back().back().push_back(stimulus);
      }
    }
  }
  for (int p = 0; p < study.people + random_people; ++p) {
    Random random(mix_bits(seed ^ 0x68736b), static_cast<std::uint64_t>(p));
    detail::ShownPerson person{
        .code = p < study.people ? "p" + std::to_string(p) : "random" + std::to_string(p - study.people),
        .observer = make_observer(study.observer, study.definition, random, differences),
        .random = p >= study.people};
    log.participants.push_back(test::person(person.code));
    for (const auto& of_artifact : stimuli) {
      if (study.staircase_trials == 0) {
        for (const auto& of_width : of_artifact)
          for (const Stimulus& stimulus : of_width) detail::answer_one(log, person, stimulus, random);
        continue;
      }
      std::size_t at = 0;
      int right = 0;
      for (int trial = 0; trial < study.staircase_trials; ++trial) {  // two right: finer; one wrong: coarser
        const auto& of_width = of_artifact[at];
        detail::answer_one(log, person, of_width[random.below(of_width.size())], random);
        right = log.answers.back().correct() ? right + 1 : 0;
        if (right == 2) at = std::min(at + 1, of_artifact.size() - 1), right = 0;
        if (!log.answers.back().correct() && at > 0) --at;
      }
    }
  }
  return log;
}

/// Designs of honest studies, from 3 to 84 stimuli: the screens know none of these generators.
inline std::vector<HonestStudy> honest_studies() {
  const auto study = [](const char* name, ObserverKind observer = ObserverKind::threshold) {
    HonestStudy made;
    made.name = name;
    made.observer = observer;
    return made;
  };
  const auto one_artifact = [&](const char* name, std::vector<int> widths_px) {
    HonestStudy made = study(name);
    made.artifacts = {Artifact::receiver};
    made.widths_px = std::move(widths_px);
    made.definition.people_sd_octaves = 0.8;
    return made;
  };
  std::vector<HonestStudy> studies = {
      study("84 stimuli, `threshold`"),
      study("84 stimuli, `threshold`, 0.8 octave SD"),
      study("84 stimuli, `image`, objects differ", ObserverKind::image),
      study("84 stimuli, little visible, `threshold`"),
      study("84 stimuli, nothing visible, `guesser`", ObserverKind::guesser),
      one_artifact("one artifact, 21 stimuli", {64, 128, 256, 512, 1024, 2048, 4096}),
      one_artifact("one artifact, 15 stimuli", {64, 128, 256, 512, 1024}),
      one_artifact("one artifact, 9 stimuli", {64, 512, 4096}),
      one_artifact("one artifact, 3 stimuli", {64, 512, 4096}),
      one_artifact("one artifact, adaptive, 40 trials", {64, 128, 256, 512, 1024, 2048, 4096}),
      study("four artifacts, adaptive, 160 trials")};
  studies[1].definition.people_sd_octaves = 0.8;
  studies[2].definition.image_gain = 1;
  studies[2].definition.people_sd_octaves = 0.25;
  studies[2].definition.scale_octaves = 0.25;
  studies[2].object_sd_octaves = 1;
  for (auto& [artifact, midpoint_px] : studies[3].definition.midpoint) midpoint_px = 70;
  studies[8].objects = 1;
  studies[9].staircase_trials = studies[10].staircase_trials = 40;
  return studies;
}

}  // namespace seamline::test
