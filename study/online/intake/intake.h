#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "study/log/online/online_log.h"
#include "study/online/intake/refusal.h"
#include "study/online/messages/message.h"
#include "study/online/messages/shown_names.h"
#include "study/trials/participant_trials.h"
#include "study/trials/rendered_set.h"
#include "study/visit/visit_script.h"

namespace seamline::study::online {

/// How far a participant has come.
struct Whereabouts {
  std::string participant;
  Origin origin = Origin::serve;
  int slot = 0;
  std::vector<int> answered;  ///< indices of trials, rising
  int trials = 0;             ///< decided so far
  bool form_done = false;
  int training_done = 0;
  bool completed = false;
  std::int64_t next_sequence = 0;
};

/// What a server gives a newcomer besides their slot.
struct GivenIdentity {
  std::string code;
  std::string secret_sha256;
  std::string token_sha256 = {};  ///< of the invitation; empty: none is needed
  int slots = 0;                  ///< orders that the page has
};

/// What an enrolment at a server came to.
struct EnrolledPerson {
  std::string code;
  int slot = 0;
  std::int64_t next_sequence = 0;
  bool is_new = false;  ///< false: the same message came before
};

/// Between messages and the log: decides what is stored, stores it once, and knows how far everybody is.
/// Everything that a session in the window would refuse is refused, with a sentence (`Refusal`): messages of
/// another study or set, a trial that is not planned, a second answer to one, answers after the end. A
/// message whose id is stored is not stored again; with other content it is a conflict. Not for several
/// threads at once.
///
///     intake.transaction([&] { for (message : messages) intake.take(message); });   // then it is on the
///     disk
class Intake {
 public:
  /// Opens or makes the log. `set` must live as long as this. Throws InputError as LogWriter does.
  Intake(const RenderedSet& set, const std::filesystem::path& log, KnownNames known = KnownNames::shown);

  /// How much a participant may store: some `base_bytes` and `bytes_a_trial` for every trial that is planned
  /// (`stored_bytes_of` a message). A session takes a few KiB a trial; whoever imports files decides for
  /// themselves.
  struct Quota {
    std::int64_t base_bytes = std::int64_t{8} << 20;
    std::int64_t bytes_a_trial = std::int64_t{16} << 10;
  };
  void limit(const Quota& quota) { quota_ = quota; }

  /// Runs `work` as one transaction, on the disk when this returns. When it fails (InputError) nothing is
  /// stored, and nobody's progress is remembered wrongly.
  void transaction(const std::function<void()>& work);

  /// Stores a message; false when it was stored before. An enrolment must bring its code and slot: a host of
  /// files or JATOS. Throws Refusal, and stores nothing, when it may not be stored.
  bool take(const Message& message);

  /// Enrols somebody at a server: `message` has no participant and no slot. They get the slot that the fewest
  /// have completed (`newcomer_slot`). The same message again finds the same participant again, whose secret
  /// becomes the new one as long as nothing else of theirs is stored. Throws Refusal.
  [[nodiscard]] EnrolledPerson enrol(const Message& message, const GivenIdentity& given);

  /// How far a participant is. Throws Refusal when there is none.
  [[nodiscard]] Whereabouts where(const std::string& code);

  /// The trial that a participant of an adaptive study gets next, decided and stored before it is told; none
  /// when the session is over. Throws Refusal when there is none of that code, they are excluded, or the
  /// study is not adaptive.
  [[nodiscard]] std::optional<std::pair<int, Trial>> next_trial(const std::string& code);
  /// The pictures that a trial shows, side by side or one after another; one of most tasks.
  [[nodiscard]] std::vector<Trial> pictures_of(const Trial& trial) const;

  /// What covers the pictures of a trial after them; none: nothing does.
  [[nodiscard]] std::optional<Trial> mask_of(const Trial& trial) const;

  /// Numbers of a participant's messages that are missing below the highest stored.
  [[nodiscard]] std::vector<std::int64_t> gaps(const std::string& code);

  /// Whose message this id is; empty: nobody's.
  [[nodiscard]] std::string sender_of(const std::string& message_id);
  /// Attention trials that a participant answered right. Throws Refusal when there is none of that code.
  [[nodiscard]] int attention_right(const std::string& code);
  [[nodiscard]] std::vector<OnlineStanding> standings() { return log_.standings(); }
  [[nodiscard]] std::int64_t declines() { return log_.declines(); }

  [[nodiscard]] std::map<std::string, std::string> secrets() { return log_.secrets(); }
  [[nodiscard]] OnlineLog::Counts counts() { return log_.counts(); }
  [[nodiscard]] const RenderedSet& set() const { return set_; }
  [[nodiscard]] const ShownNames& names() const { return names_; }

 private:
  struct Person {
    OnlinePerson stored;
    std::optional<TrialSequence> sequence = {};  ///< of an adaptive study, as far as it is remembered
  };

  /// `seamline log exclude LOG CODE` may have been called since the last transaction.
  void look_who_is_excluded();
  Person& person(const std::string& code);
  Person& participant(const std::string& code);  ///< who is not excluded
  Person* find(const std::string& code);
  void check_study(const Message& message) const;
  void check_consent(const EnrolBody& body) const;
  /// Whether this very message is stored. Throws Refusal when another with its id is.
  bool is_known(const Message& message, const std::string& content);
  void check_sequence(const Person& person, const Message& message);
  void check_quota(const Person& person, const MessageNote& note) const;
  Person& enter(const OnlineNewcomer& newcomer, const EnrolBody& body);
  bool enrol_elsewhere(const Message& message, const std::string& content);
  void store(Person& person, const MessageBody& body);
  void store(Person& person, const BeginBody& body);
  void store(Person& person, const FormBody& body);
  void store(Person& person, const DisplayBody& body);
  void store(Person& person, const TrainingBody& body);
  void store(Person& person, const AnswerBody& body);
  void store(Person& person, const EventBody& body);
  void store_completion(Person& person);
  void check_choice(const Trial& planned, const PictureAnswer& answer) const;
  void check_shown(const Trial& planned, const PictureAnswer& answer, const std::string& which) const;
  [[nodiscard]] int matched_stimulus(const Trial& planned, const PictureAnswer& answer,
                                     const std::string& which) const;
  TrialSequence& sequence_of(Person& person);
  [[nodiscard]] static std::int64_t time_of(const Person& person);

  const RenderedSet& set_;
  ShownNames names_;
  KnownNames known_names_;
  TrialRules rules_;
  VisitScript script_;
  std::map<std::string, std::string> consents_;  ///< the text in each language, by its hash
  std::optional<Quota> quota_ = {};
  OnlineLog log_;
  std::unordered_map<std::string, Person> people_;
  std::size_t sequences_ = 0;  ///< remembered
};

}  // namespace seamline::study::online
