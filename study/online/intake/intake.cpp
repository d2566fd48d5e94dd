#include "study/online/intake/intake.h"

#include <fmt/core.h>

#include <algorithm>

#include "study/log/now.h"
#include "study/online/messages/message_writer.h"
#include "study/trials/study_languages.h"
#include "support/files/hash.h"

namespace seamline::study::online {
namespace {

/// Beliefs of an adaptive procedure are large; those of more people than this are made again when needed.
constexpr std::size_t most_remembered_sequences = 128;
/// A slot that a page on a host of files may draw where everybody has an order of their own.
constexpr int most_own_orders = 1'000'000;

std::optional<int> trial_of(const MessageBody& body) {
  if (const auto* answer = std::get_if<AnswerBody>(&body)) return answer->trial_index;
  return std::nullopt;
}

std::size_t free_text_bytes_of(const MessageBody& body) {
  if (const auto* event = std::get_if<EventBody>(&body)) return event->kind.size() + event->detail.size();
  if (const auto* begin = std::get_if<BeginBody>(&body)) return begin->user_agent.size();
  if (const auto* enrol = std::get_if<EnrolBody>(&body)) return enrol->user_agent.size();
  return 0;
}

MessageNote note_of(const Message& message, const std::string& content) {
  return {.id = message.id,
          .sequence = message.sequence,
          .kind = std::string(kind_word(message.body)),
          .trial_index = trial_of(message.body),
          .content_sha256 = content,
          .free_text_bytes = free_text_bytes_of(message.body)};
}

}  // namespace

Intake::Intake(const RenderedSet& set, const std::filesystem::path& log, KnownNames known)
    : set_(set),
      names_(set),
      known_names_(known),
      rules_(make_trial_rules(set)),
      script_(make_visit_script(set)),
      log_(log, set) {
  consents_[sha256(set.study.consent.text)] = set.study.consent.text;
  for (const StudyTexts& texts : whole_languages(set.study)) {
    const std::string text = in_language(set.study, texts).consent.text;
    consents_[sha256(text)] = text;
  }
}

void Intake::transaction(const std::function<void()>& work) {
  try {
    log_.transaction([&] {
      look_who_is_excluded();
      work();
    });
  } catch (...) {
    people_.clear();  // what is remembered of them may not be stored
    sequences_ = 0;
    throw;
  }
}

void Intake::look_who_is_excluded() {
  if (const auto excluded = log_.excluded_since())
    for (auto& [code, one] : people_) one.stored.place.excluded = excluded->contains(code);
}

Intake::Person* Intake::find(const std::string& code) {
  if (const auto known = people_.find(code); known != people_.end()) return &known->second;
  try {
    std::optional<OnlinePerson> found = log_.find(code);
    if (!found) return nullptr;
    return &people_.emplace(code, Person{.stored = *std::move(found)}).first->second;
  } catch (const Refusal&) {
    throw;
  } catch (const InputError& error) {
    throw Refusal(RefusalKind::conflict, {.field = error.what()});
  }
}

Intake::Person& Intake::person(const std::string& code) {
  if (Person* found = find(code)) return *found;
  throw Refusal(RefusalKind::unknown,
                {.field = "participant", .wanted = "one who is enrolled", .found = in_quotes(code)});
}

Intake::Person& Intake::participant(const std::string& code) {
  Person& found = person(code);
  if (found.stored.place.excluded)
    throw Refusal(RefusalKind::excluded, {.field = "participant",
                                          .wanted = "one who takes part",
                                          .found = in_quotes(code) + ", who is excluded"});
  return found;
}

void Intake::check_study(const Message& message) const {
  if (message.study_hash != set_.manifest.study_hash)
    throw conflict("study_hash", set_.manifest.study_hash + ", this log's study",
                   in_quotes(message.study_hash));
  if (message.set_hash != set_.set_hash)
    throw conflict("set_hash", set_.set_hash + ", this log's set", in_quotes(message.set_hash));
}

void Intake::check_consent(const EnrolBody& body) const {
  if (!consents_.contains(body.consent_sha256))
    throw conflict("body.consent_sha256", sha256(set_.study.consent.text) + ", of this study's consent",
                   in_quotes(body.consent_sha256));
  if (!body.pilot && is_default_consent(set_.study.consent))
    throw wrong("body.pilot", "a pilot, since the study has the shipped consent text", "a participant");
}

bool Intake::is_known(const Message& message, const std::string& content) {
  const std::optional<KnownMessage> known = log_.message(message.id);
  if (!known) return false;
  if (known->content_sha256 == content &&
      (message.participant.empty() || known->participant == message.participant))
    return true;
  throw conflict("id", "an id of its own", "that of another message, " + message.id);
}

void Intake::check_sequence(const Person& person, const Message& message) {
  if (!log_.has_sequence(person.stored, message.sequence)) return;
  throw conflict("sequence", "a number of its own",
                 fmt::format("{}, which another message of {} has", message.sequence, person.stored.code));
}

void Intake::check_quota(const Person& person, const MessageNote& note) const {
  if (!quota_) return;
  const std::int64_t most =
      quota_->base_bytes +
      quota_->bytes_a_trial * static_cast<std::int64_t>(person.stored.place.trials.size());
  if (person.stored.stored_bytes + stored_bytes_of(note.free_text_bytes) <= most) return;
  throw Refusal(RefusalKind::too_much, {.field = "messages",
                                        .wanted = fmt::format("at most {} bytes of a participant", most),
                                        .found = "more"});
}

Intake::Person& Intake::enter(const OnlineNewcomer& newcomer, const EnrolBody& body) {
  const std::int64_t begun_unix_s = newcomer.origin == Origin::serve ? now_unix_s() : body.accepted_unix_s;
  Person entered{.stored = log_.enter(newcomer)};
  log_.begin_sitting(entered.stored, body.user_agent, begun_unix_s);
  log_.record_consent(entered.stored, consents_.at(body.consent_sha256), body.accepted_unix_s);
  const std::vector<Trial> decided = decided_trials(rules_, newcomer.slot, {});
  if (!decided.empty()) log_.append_trials(entered.stored, decided);
  return people_.insert_or_assign(newcomer.code, std::move(entered)).first->second;
}

EnrolledPerson Intake::enrol(const Message& message, const GivenIdentity& given) {
  check_study(message);
  const auto& body = std::get<EnrolBody>(message.body);
  const std::string content = content_sha256(message);
  if (!message.participant.empty() || body.slot != -1 || body.origin != Origin::serve ||
      message.sequence != 0)
    throw wrong("body", "an enrolment whose code and slot the server gives, number 0 of origin serve",
                "another one");
  if (is_known(message, content)) {
    Person& known = person(log_.message(message.id)->participant);
    if (known.stored.next_sequence != 1)
      throw conflict("id", "an enrolment that is new", "that of somebody who has begun");
    log_.set_secret(known.stored, given.secret_sha256);
    return {.code = known.stored.code, .slot = known.stored.place.slot, .next_sequence = 1};
  }
  check_consent(body);
  if (!given.token_sha256.empty() && !log_.use_token(given.token_sha256))
    throw Refusal(
        RefusalKind::unknown,
        {.field = "invitation in the link",
         .wanted = "one that is still free; each is for one person, in the browser that opened it first",
         .found = "a used one"});
  const std::vector<HeldSlot> held = log_.held_slots(body.pilot);
  int slot = newcomer_slot(set_.study.session.orders, held);
  if (slot >= given.slots) slot = newcomer_slot(given.slots, held);  // people share what the page has
  Person& entered = enter({.code = given.code,
                           .slot = slot,
                           .pilot = body.pilot,
                           .origin = Origin::serve,
                           .secret_sha256 = given.secret_sha256},
                          body);
  log_.note_message(entered.stored, note_of(message, content));
  return {.code = given.code, .slot = slot, .next_sequence = entered.stored.next_sequence, .is_new = true};
}

bool Intake::enrol_elsewhere(const Message& message, const std::string& content) {
  const auto& body = std::get<EnrolBody>(message.body);
  const int orders = set_.study.session.orders > 0 ? set_.study.session.orders : most_own_orders;
  if (body.origin == Origin::serve)
    throw wrong("body.origin", "static or jatos (a server enrols its own)", "serve");
  if (rules_.is_adaptive())
    throw wrong("body.origin", "serve, since the study places trials by the answers",
                std::string(word(body.origin)));
  if (body.slot < 0 || body.slot >= orders)
    throw wrong("body.slot", fmt::format("a slot from 0 to {}", orders - 1), std::to_string(body.slot));
  check_consent(body);
  if (find(message.participant) != nullptr)
    throw conflict("participant", "a code that nobody has", in_quotes(message.participant));
  Person& entered = enter(
      {.code = message.participant, .slot = body.slot, .pilot = body.pilot, .origin = body.origin}, body);
  log_.note_message(entered.stored, note_of(message, content));
  return true;
}

bool Intake::take(const Message& message) {
  check_study(message);
  const std::string content = content_sha256(message);
  if (is_known(message, content)) return false;
  if (std::holds_alternative<DeclineBody>(message.body)) {
    log_.note_decline(note_of(message, content));
    return true;
  }
  if (std::holds_alternative<EnrolBody>(message.body)) return enrol_elsewhere(message, content);
  Person& who = participant(message.participant);
  check_sequence(who, message);
  const MessageNote note = note_of(message, content);
  check_quota(who, note);
  store(who, message.body);
  log_.note_message(who.stored, note);
  return true;
}

TrialSequence& Intake::sequence_of(Person& who) {
  if (who.sequence) return *who.sequence;
  if (sequences_ >= most_remembered_sequences) {
    for (auto& [code, other] : people_) other.sequence.reset();
    sequences_ = 0;
  }
  const OpenSession& place = who.stored.place;
  who.sequence =
      trial_sequence(rules_, {.slot = place.slot, .trials = place.trials, .answers = place.answers});
  ++sequences_;
  return *who.sequence;
}

std::int64_t Intake::time_of(const Person& who) {
  return who.stored.origin == Origin::serve ? now_unix_s() : who.stored.accepted_unix_s;
}

Whereabouts Intake::where(const std::string& code) {
  const OnlinePerson& stored = person(code).stored;
  return {.participant = code,
          .origin = stored.origin,
          .slot = stored.place.slot,
          .answered = {stored.answered.begin(), stored.answered.end()},
          .trials = static_cast<int>(stored.place.trials.size()),
          .form_done = stored.place.form_done,
          .training_done = stored.training_done,
          .completed = stored.place.completed,
          .next_sequence = stored.next_sequence};
}

std::optional<std::pair<int, Trial>> Intake::next_trial(const std::string& code) {
  Person& who = participant(code);
  if (!rules_.is_adaptive())
    throw wrong("seamline", "a study that places trials by the answers", "one whose orders are fixed");
  if (who.stored.place.completed) return std::nullopt;
  const std::optional<Trial> due = current_trial(sequence_of(who));
  if (!due) return std::nullopt;
  if (std::ssize(who.stored.place.trials) <= who.stored.place.answered)
    log_.append_trials(who.stored, std::span<const Trial>(&*due, 1));
  return std::pair(who.stored.place.answered, *due);
}

std::vector<Trial> Intake::pictures_of(const Trial& trial) const {
  return shown_pictures(rules_.task_of(trial), trial);
}

std::optional<Trial> Intake::mask_of(const Trial& trial) const {
  if (!rules_.task_of(trial).masks) return std::nullopt;
  return Trial{.kind = TrialKind::mask, .stimulus = trial.stimulus};
}

std::string Intake::sender_of(const std::string& message_id) {
  const std::optional<KnownMessage> known = log_.message(message_id);
  return known ? known->participant : std::string();
}

int Intake::attention_right(const std::string& code) {
  const OpenSession& place = person(code).stored.place;
  int right = 0;
  for (const TrialAnswer& answer : place.answers) {
    const Trial& trial = place.trials.at(answer.trial_index);
    const ManifestStimulus& shown = set_.manifest.stimuli.at(trial.stimulus);
    const int wanted = trial.right_index != 0 ? trial.right_index : shown.stimulus.object_index;
    if (trial.kind == TrialKind::attention && answer.chosen_index == wanted) ++right;
  }
  return right;
}

std::vector<std::int64_t> Intake::gaps(const std::string& code) {
  std::vector<std::int64_t> missing;
  std::int64_t due = 0;
  for (const std::int64_t stored : log_.sequences(person(code).stored)) {
    for (; due < stored && missing.size() < 10000; ++due) missing.push_back(due);
    due = stored + 1;
  }
  return missing;
}

}  // namespace seamline::study::online
