// Laws of the page's parts that need no browser.   laws.mjs WEB_FOLDER
import assert from "node:assert/strict";
import { importCore, importPart } from "./replay.mjs";

const web = process.argv[2];
const { drawCode, drawSlot, drawUuid, makeMessage, progressOf } = await importCore(web, "messages.js");
const { direction, fillIn } = await importCore(web, "texts.js");
const { bracketBars, objectAt, placeTrial, unpackMap } = await importCore(web, "place.js");
const { next, resumeVisit } = await importCore(web, "visit.js");

// Names: of the right form, and never the same twice.
const uuids = new Set(Array.from({ length: 2000 }, () => drawUuid()));
assert.equal(uuids.size, 2000);
for (const uuid of uuids) assert.match(uuid, /^[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}$/);
const codes = new Set(Array.from({ length: 2000 }, () => drawCode()));
assert.equal(codes.size, 2000);
for (const code of codes) assert.match(code, /^w-[a-z2-7]{16}$/);

// A slot: every one equally likely; a draw from the incomplete last stretch is drawn again.
const tally = new Array(7).fill(0);
for (let i = 0; i < 14000; ++i) ++tally[drawSlot(7)];
const chi2 = tally.reduce((sum, n) => sum + (n - 2000) ** 2 / 2000, 0);
assert.ok(chi2 < 33, "chi-squared " + chi2); // 6 degrees of freedom, 1 in 100,000
const draws = [2 ** 32 - 1, 8];
assert.equal(drawSlot(7, () => draws.shift()), 1);

// Words.
assert.equal(fillIn("{done} of {all} {unknown}", { done: 0, all: 5 }), "0 of 5 {unknown}");
for (const [language, wanted] of [["en", "ltr"], ["ar", "rtl"], ["he-IL", "rtl"], ["FA", "rtl"], ["az-Arab", "rtl"], ["pt-BR", "ltr"], ["ks-Latn", "ltr"]])
  assert.equal(direction(language), wanted, language);

// Places, as the window computes them.
const place = placeTrial({ width: 1001, height: 700 }, { width: 400, height: 240 }, 18);
assert.deepEqual([place.x, place.y, place.questions_y, place.fits], [300, 176, 416, true]);
assert.equal(placeTrial({ width: 1000, height: 347 }, { width: 400, height: 240 }, 18).fits, false);
assert.equal(placeTrial({ width: 400, height: 348 }, { width: 400, height: 240 }, 18).fits, true);
const map = unpackMap({ width_px: 4, height_px: 2, frames: [], runs: [3, 0, 2, 1, 3, 2] });
assert.deepEqual([objectAt(map, 3.9, 0), objectAt(map, 0, 1.9), objectAt(map, 1, 1), objectAt(map, 4, 0), objectAt(map, -0.1, 0)], [1, 1, 2, 0, 0]);
assert.equal(bracketBars({ x: 10, y: 10, width: 60, height: 40 }).length, 8);
assert.deepEqual(bracketBars({ x: 10, y: 10, width: 60, height: 40 })[0], [10, 10, 13, 3]);
assert.deepEqual(bracketBars({ x: 10, y: 10, width: 60, height: 40 }, true)[0], [10, 10, 13, 7]);
assert.deepEqual(bracketBars({ x: 0, y: 0, width: 0, height: 0 }), []);

// Progress: what the kept messages say is what happened.
const stream = { study_hash: "s", set_hash: "t", participant: "w-a" };
const kinds = [["enrol", {}], ["form", {}], ["training", {}], ["event", { kind: "shown", detail: "practice" }]];
const messages = kinds.map(([kind, body], at) => makeMessage(stream, at, kind, body));
assert.deepEqual(progressOf(messages), { enrolled: true, form_done: true, trained: 1, answered: 0, begun: false, completed: false });
messages.push(makeMessage(stream, 4, "event", { kind: "shown", detail: "" }), makeMessage(stream, 5, "answer", {}));
assert.deepEqual([progressOf(messages).begun, progressOf(messages).answered], [true, 1]);

// Who comes again goes on where they were, behind a pause, and repeats nothing.
const script = { form: [], instruction_pages: 1, training: [{ right_index: 1 }, { right_index: 2 }], pace: { break_every_trials: 0, minimum_viewing_ns: 0, inter_trial_ns: 0 } };
const order = [{}, {}, {}];
const come = (answered, trained, begun) => {
  const visit = resumeVisit(script, { form_done: true, trained, begun, trials: { order, answered, most: 3 } });
  const shown = next(visit, { type: "display_confirmed", facts: {} });
  return shown.pending ? next(shown, { type: "record_stored" }) : shown;
};
assert.deepEqual(come(1, 2, true).screen, { name: "pause", below: { name: "trial" } });
assert.equal(next(come(1, 2, true), { type: "continued" }).session.trials.answered, 1);
assert.deepEqual(come(0, 1, false).screen, { name: "pause", below: { name: "training" } });
assert.deepEqual(come(0, 2, false).screen, { name: "pause", below: { name: "ready" } });
assert.deepEqual(come(0, 0, false).screen, { name: "instructions", page: 0 });
const over = resumeVisit(script, { form_done: true, trained: 2, begun: true, trials: { order, answered: 3, most: 3 } });
assert.equal(over.pending.kind, "completion");
// What an answer means. Whatever the status, the words of somebody on the way never end a visit; the host's own do, where the
// status is HTTP's for "never", and an answer of success counts only when it is the host's.
const { NotNow, Refused, verdict } = await importPart(web, "keeping/verdict.js");
const { findHost, wrongHost } = await importPart(web, "keeping/hosts.js");
for (let status = 200; status < 300; ++status) assert.equal(verdict(status), null);
for (let status = 300; status < 600; ++status) {
  assert.ok(verdict(status) instanceof NotNow, status);
  assert.match(verdict(status, { of: "study.json" }).message, new RegExp("^study\\.json: HTTP " + status + "$"));
  const isFinal = status >= 400 && status < 500 && ![408, 425, 429].includes(status);
  assert.equal(verdict(status, { sentence: "no" }) instanceof Refused, isFinal, status);
}
globalThis.location = { pathname: "/" };
const words = { texts: { online_host: "{wanted} {found}" }, slots: 5 };
const server = await findHost({ ...words, host: "serve" }, { token: null, secret: "s" });
const message = { id: "m-1", participant: "w-a" };
const asks = {
  enrol: [() => server.enrol(message), { participant: "s-1", slot: 0, secret: "x", next_sequence: 1 }],
  decline: [() => server.decline(message), {}],
  send: [() => server.send([message]), { stored: ["m-1"] }],
  where: [() => server.where(), { next_sequence: 3 }],
  nextTrial: [() => server.nextTrial(), { done: true }],
};
const answering = (status, body) => (globalThis.fetch = async () => new Response([204, 205, 304].includes(status) ? null : body, { status }));
for (const [name, [ask, right]] of Object.entries(asks)) {
  answering(200, JSON.stringify(right));
  await ask();
  for (let status = 200; status < 600; ++status) {
    answering(status, "<!doctype html>Please log in");
    await assert.rejects(ask, NotNow, name + " " + status);
    if (status < 300) continue;
    answering(status, JSON.stringify({ error: "no" }));
    await assert.rejects(ask, status >= 400 && status < 500 && ![408, 425, 429].includes(status) ? Refused : NotNow, name + " " + status);
  }
  for (const wrong of ["", "null", "[]", "{}", '{"stored":"m-1"}', '"ok"']) {
    answering(200, wrong);
    if (name === "decline" && ["[]", "{}", '{"stored":"m-1"}'].includes(wrong)) continue;
    await assert.rejects(ask, NotNow, name + " " + wrong);
  }
}
answering(200, '{"stored":["another"]}');
assert.equal(await server.send([message]), 0, "acknowledged by the id of another message");

// A page talks to the host that it was exported for, whoever answers, and says so where the visit was begun at another.
globalThis.fetch = async () => assert.fail("a page need not ask who hosts it");
for (const host of ["serve", "static"]) assert.equal((await findHost({ ...words, host }, {})).kind, host);
answering(404, "");
await assert.rejects(findHost({ ...words, host: "jatos" }, {}), NotNow);
globalThis.location = { pathname: "/publix/1/index.html" };
await assert.rejects(findHost({ ...words, host: "static" }, {}), Refused);
assert.equal(wrongHost(words, "serve", "serve"), null);
assert.equal(wrongHost(words, "static", "serve").message, "a host of files seamline serve");
// What is kept while a request is under way is sent after it, none is left out, and no request is larger than a host takes.
const { makeCourier } = await importPart(web, "keeping/courier.js");
const arrived = [];
let sizes = [];
const courier = makeCourier({
  store: { append: async () => {}, keepFact: async () => {} },
  host: {
    async send(group) {
      if (arrived.length < 40) for (let i = 0; i < 3; ++i) await courier.keep("event", { detail: "é".repeat(20000) });
      sizes.push(Buffer.byteLength(group.map((one) => JSON.stringify(one) + "\n").join("")));
      arrived.push(...group.map((one) => one.sequence));
      return group.length;
    },
  },
  stream: { participant: "w-a" },
  messages: [],
  acknowledged: 0,
  away() {},
});
await courier.deliver("form", {});
await courier.deliver("completion", {});
assert.deepEqual(arrived, arrived.map((_, at) => at));
assert.ok(arrived.length > 40 && courier.unsent() === 0);
assert.ok(Math.max(...sizes) < 2 ** 20, Math.max(...sizes));
// A study that ended for somebody says why, in words of its own: the reason comes from the server to the last screen.
for (const [status, reason] of [[401, "forgotten"], [409, "excluded"], [409, undefined]]) {
  answering(status, JSON.stringify({ error: "a sentence", reason }));
  const refusal = await server.where().then(assert.fail, (error) => error);
  const stopped = next(over, { type: "store_failed", message: refusal.message, reason: refusal.reason });
  assert.deepEqual(stopped.screen, { name: "stopped", message: "a sentence", reason });
}

// JATOS: a run's name is in the address; what jatos.js says of a failure (3.10 with its parts beside the sentence, before
// without) ends the study where JATOS itself refuses, and passes where anybody else may have answered, or nobody.
const { append, faultOf, leave, loadPartsByAddress, runOf } = await importPart(web, "keeping/jatos.js");
assert.equal(runOf("/publix/0b1c/77aa/start"), "0b1c");
assert.equal(runOf("/jatos/publix/0b1c/77aa/start"), "0b1c");
for (const elsewhere of ["/", "/study/index.html", "/publix/"]) assert.equal(runOf(elsewhere), null);
const sentence = (...parts) => "POST to http://localhost/publix/0b1c/77aa/resultData failed: " + parts.filter((part) => part).join(", ");
const faults = [
  ["Refused", 400, "Bad Request", "A study result 0b1c doesn't exist."],
  ["Refused", 403, "Forbidden", "Study run is already finished (study result 1)"],
  ["Refused", 413, "Request Entity Too Large", "Result data size exceeds allowed 5 MB. Consider using result files instead."],
  ["NotNow", 403, "Forbidden", "<html>a proxy</html>"],
  ["NotNow", 403, "Forbidden", null],
  ["NotNow", 404, "Not Found", null],
  ["NotNow", 408, "Request Timeout", "later"],
  ["NotNow", 429, "Too Many Requests", "later"],
  ["NotNow", 500, "Internal Server Error", "JATOS error"],
  ["NotNow", 503, "Service Unavailable", null],
  ["Error", 0, "", null],
  ["Error", undefined, undefined, "timeout"],
];
for (const [kind, status, name, answer] of faults) {
  const said = sentence(status, name, answer);
  assert.equal(faultOf(said, status, name, answer).constructor.name, kind, said);
  assert.equal(faultOf(said).constructor.name, kind, "before 3.10: " + said);
  if (kind === "Refused") assert.equal(faultOf(said, status, name, answer).message, answer);
}
assert.equal(faultOf("Can't send result data. This study run is invalid.").constructor.name, "Refused");
assert.equal(faultOf().constructor.name, "Error");

// It is asked once for each append, so that the page sees every failure; and what it would do by itself is as before.
const asked = [];
const jatos = {
  httpRetry: 5,
  appendResultData: (text) => (asked.push([text, jatos.httpRetry]), { then: (yes) => yes() }),
  endStudy: (...how) => asked.push(how),
};
await append(jatos, "a line\n");
for (const screen of ["stopped", "thanks", "declined"]) leave(jatos, screen);
assert.deepEqual(asked, [["a line\n", 0], [true], [false, "declined", false]]);
assert.equal(jatos.httpRetry, 5);

// Every jQuery that comes loads its parts by their address: also one of a load that was given up, which comes beside the next.
const settings = [];
loadPartsByAddress();
for (const load of ["given up", "the next"]) {
  globalThis.jQuery = { ajaxSetup: (more) => settings.push([load, more]) };
  globalThis.jQuery = undefined; // noConflict
}
assert.deepEqual(settings, [["given up", { scriptAttrs: {} }], ["the next", { scriptAttrs: {} }]]);
assert.equal(globalThis.jQuery, undefined);
// A picture has one map of its objects, a clip a list of them. Each is taken for what it is, and nothing else is: what somebody on
// the way sends in its place is waited out.
const { makePictures } = await importPart(web, "pictures.js");
const oneMap = { width_px: 2, height_px: 1, frames: [], runs: [1, 0, 1, 1] };
for (const [plays, right, wrong] of [[undefined, oneMap, [oneMap]], [{ frames: 2 }, [oneMap, oneMap], oneMap]]) {
  const answers = [{ login: true }, [], wrong, right].map((json) => JSON.stringify(json));
  globalThis.addEventListener = (_, over) => over(); // the network is back at once
  globalThis.removeEventListener = () => {};
  globalThis.fetch = async (file) => new Response(file === "map.json" ? answers.shift() : "abc");
  const loaded = new Promise((resolve, reject) => {
    const picture = { file: "a", bytes: 3, sha256: "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad", map: "map.json" };
    makePictures([picture], plays, { away: () => {}, progress: (here, all) => resolve([here, all]), failed: reject }).want(["a"]);
  });
  assert.deepEqual(await loaded, [1, 1]);
  assert.deepEqual(answers, [], "a map was taken that is none");
}
console.log("the page's parts keep their laws");
