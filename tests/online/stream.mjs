// What must hold of the lines that a host has of one participant.
import assert from "node:assert/strict";

/** The messages of a participant, each once, in their order. A line that came twice must be the same twice. */
export function messagesOf(lines, participant) {
  const byId = new Map();
  for (const line of lines) {
    assert.ok(line.length <= 65536);
    const message = JSON.parse(line);
    if (message.participant !== participant) continue;
    if (byId.has(message.id)) assert.deepEqual(byId.get(message.id), message, "the same id, other content");
    byId.set(message.id, message);
  }
  return [...byId.values()].sort((a, b) => a.sequence - b.sequence);
}

const KEYS = ["format", "study_hash", "set_hash", "participant", "sequence", "id", "kind", "body"];
const BODIES = {
  enrol: ["slot", "consent_sha256", "accepted_unix_s", "user_agent", "origin", "pilot"],
  form: ["answers"],
  display: ["screen_width_px", "screen_height_px", "device_pixel_ratio", "viewport_width_px", "viewport_height_px", "mm_per_px",
    "viewing_distance_mm", "pixels_per_degree", "refresh_hz", "gamma_confirmed", "image_scale"],
  training: ["training_index", "kind", "stimulus_id", "chosen_index", "rating", "choice_ns", "rating_ns"],
  answer: ["trial_index", "kind", "stimulus_id", "chosen_index", "rating", "choice_ns", "rating_ns", "image_scale"],
  event: ["monotonic_ns", "kind", "trial_index", "detail"],
  begin: ["user_agent"],
  completion: [],
};

/** A whole stream of a participant who has finished: no gap, nothing twice, every trial of the order answered once. */
export function checkWhole(messages, order) {
  assert.deepEqual(messages.map((message) => message.sequence), messages.map((_, at) => at), "a gap, or a number twice");
  for (const message of messages) {
    assert.deepEqual(Object.keys(message), KEYS);
    assert.match(message.id, /^[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}$/);
    assert.deepEqual(Object.keys(message.body).sort(), [...BODIES[message.kind]].sort(), message.kind);
    for (const [name, value] of Object.entries(message.body))
      if (/_ns$|_index$/.test(name) && value !== null) assert.ok(Number.isSafeInteger(value), name);
  }
  assert.equal(messages[0].kind, "enrol");
  assert.equal(messages.at(-1).kind, "completion");
  const answers = messages.filter((message) => message.kind === "answer").map((message) => message.body);
  assert.deepEqual(answers.map((answer) => answer.trial_index), answers.map((_, at) => at), "an answer is missing, or twice");
  if (order) {
    assert.equal(answers.length, order.length);
    answers.forEach((answer, at) => {
      assert.equal(answer.stimulus_id, order[at].stimulus_id);
      assert.equal(answer.kind, order[at].kind);
      assert.ok(answer.choice_ns >= 0 && answer.rating_ns >= answer.choice_ns);
    });
  }
  for (const kind of ["enrol", "form", "completion"])
    assert.equal(messages.filter((message) => message.kind === kind).length, 1, kind);
  const trained = messages.filter((message) => message.kind === "training").map((message) => message.body.training_index);
  assert.deepEqual(trained, trained.map((_, at) => at), "practice");
  return answers;
}
