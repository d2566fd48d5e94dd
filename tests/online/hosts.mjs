// Hosts for the page: a plain static server, one like JATOS whose append fails at random, a stand-in for `seamline serve`
// that fails at random too, and the program itself. Each keeps what it accepted; `folder` is the study's, without the kind of host.
import { spawn } from "node:child_process";
import { createServer, request as ask } from "node:http";
import { randomBytes } from "node:crypto";
import { readFileSync, existsSync } from "node:fs";
import { join, normalize } from "node:path";

const TYPES = {
  html: "text/html; charset=utf-8", js: "text/javascript", css: "text/css", json: "application/json",
  png: "image/png", jpg: "image/jpeg", txt: "text/plain", ttf: "font/ttf",
};

export function sendFile(folder, path, response) {
  const name = normalize(path === "/" ? "/index.html" : path);
  const file = join(folder, name);
  if (!file.startsWith(folder) || !existsSync(file) || name.endsWith("/")) {
    response.writeHead(404).end("not found");
    return;
  }
  response.writeHead(200, { "Content-Type": TYPES[name.split(".").pop()] ?? "application/octet-stream" });
  response.end(readFileSync(file));
}

export const bodyOf = async (request) => {
  const parts = [];
  for await (const part of request) parts.push(part);
  return Buffer.concat(parts).toString("utf8");
};

export async function listening(handler) {
  const requests = [];
  const host = {};
  const server = createServer((request, response) => {
    requests.push(request.url);
    const path = new URL(request.url, "http://x").pathname;
    const instead = host.instead?.(request.method, path);
    if (instead) return response.writeHead(instead.status, { "Content-Type": instead.type ?? "text/html" }).end(instead.body);
    Promise.resolve(handler(request, response, path)).catch(() => response.destroy());
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return Object.assign(host, {
    /** {status, body, type} of somebody on the way who answers a request (method, path) in the host's place, or null. */
    instead: null,
    address: "http://localhost:" + server.address().port + "/",
    requests,
    server,
    stop: () => (server.closeAllConnections(), new Promise((resolve) => server.close(resolve))),
  });
}

export const staticHost = (folder) =>
  listening((request, response, path) => sendFile(folder + "-static", path, response));

/** Somebody on the way to a host: everything goes through. */
export async function onTheWayTo(host) {
  const { port } = new URL(host.address);
  const way = await listening((request, response) => {
    const further = ask({ host: "127.0.0.1", port, path: request.url, method: request.method, headers: request.headers }, (answer) => {
      response.writeHead(answer.statusCode, answer.headers);
      answer.pipe(response);
    });
    further.on("error", () => response.destroy());
    request.pipe(further);
  });
  const stop = way.stop;
  return Object.assign(way, { where: host.where, health: host.health, stop: async () => (await stop(), host.stop()) });
}

/** Fails before it stores, or after; `trouble` is the share of requests that fail. */
export function fails(trouble) {
  if (Math.random() >= trouble) return null;
  return ["before", "after", "cut"][Math.floor(Math.random() * 3)];
}

/** The protocol of `seamline serve`, in memory. `next(answers)` places the trials of an adaptive study. */
export async function fakeServe(folder, { trouble = 0.2, next = () => null } = {}) {
  const lines = [];
  const ids = new Map();
  const people = new Map(); // by secret
  const enrolled = new Map(); // by id
  const study = JSON.parse(readFileSync(join(folder + "-serve", "study.json"), "utf8"));
  const json = (response, status, value) =>
    response.writeHead(status, { "Content-Type": "application/json" }).end(JSON.stringify(value));

  function enrol({ message }) {
    if (message.kind === "decline") return { status: 200, answer: {} };
    if (!enrolled.has(message.id)) {
      const participant = "s-" + (enrolled.size + 1);
      const answer = { participant, slot: enrolled.size % Math.max(1, study.slots), secret: randomBytes(32).toString("hex"), next_sequence: 1 };
      enrolled.set(message.id, answer);
      people.set(answer.secret, { participant, slot: answer.slot, messages: [] });
      lines.push(JSON.stringify({ ...message, participant, body: { ...message.body, slot: answer.slot } }));
    }
    return { status: 200, answer: enrolled.get(message.id) };
  }

  function store(person, text) {
    const stored = [];
    for (const line of text.split("\n").filter((one) => one !== "")) {
      const message = JSON.parse(line);
      if (message.participant !== person.participant) return { status: 400, answer: { error: "another participant", stored } };
      if (ids.has(message.id) && ids.get(message.id) !== line) return { status: 409, answer: { error: "conflict", stored } };
      if (!ids.has(message.id)) {
        ids.set(message.id, line);
        lines.push(line);
        person.messages.push(message);
      }
      stored.push(message.id);
    }
    return { status: 200, answer: { stored } };
  }

  const of = (person, kind) => person.messages.filter((message) => message.kind === kind);
  const where = (person) => ({
    participant: person.participant,
    slot: person.slot,
    answered: of(person, "answer").map((message) => message.body.trial_index),
    form_done: of(person, "form").length > 0,
    training_done: of(person, "training").length,
    completed: of(person, "completion").length > 0,
    next_sequence: 1 + person.messages.length,
  });

  function answerTo(path, request, text) {
    if (path === "/api/enrol") return enrol(JSON.parse(text));
    const person = people.get((request.headers.authorization ?? "").replace("Bearer ", ""));
    if (!person) return { status: 401, answer: { error: "unknown secret" } };
    if (path === "/api/messages") return store(person, text);
    if (path === "/api/where") return { status: 200, answer: where(person) };
    if (path === "/api/next") {
      const trial = next(of(person, "answer"), study);
      return { status: 200, answer: trial ? { trial } : { done: true } };
    }
    return { status: 404, answer: { error: "nothing here" } };
  }

  const host = await listening(async (request, response, path) => {
    if (path === "/host.json") return json(response, 200, { kind: "serve" });
    if (!path.startsWith("/api/")) return sendFile(folder + "-serve", path, response);
    const text = await bodyOf(request);
    const failure = fails(host.trouble);
    if (failure === "before") return json(response, 503, { error: "busy" });
    const { status, answer } = answerTo(path, request, text);
    if (failure === "cut") return response.destroy();
    if (failure === "after") return json(response, 500, { error: "broken" });
    json(response, status, answer);
  });
  return Object.assign(host, { lines, trouble, people });
}

/** `seamline serve` itself. `restart` kills it and starts it again at the same address; `where(secret)` is what its log knows. */
export async function realServe(program, folder, set, log) {
  let child;
  let port = 0;
  const start = () =>
    new Promise((resolve, reject) => {
      child = spawn(program, ["serve", folder + "-serve", "--set", set, "--log", log, "--port", String(port)]);
      let said = "";
      const hear = (text) => {
        said += text;
        const found = /http:\/\/127\.0\.0\.1:(\d+)\//.exec(said);
        if (found) resolve((port = Number(found[1])));
      };
      child.stdout.on("data", hear);
      child.stderr.on("data", hear);
      child.on("exit", () => reject(new Error(said)));
    });
  await start();
  const address = "http://localhost:" + port + "/";
  const ended = () => new Promise((resolve) => child.once("exit", resolve));
  const ask = async (path, headers = {}) => (await fetch("http://127.0.0.1:" + port + path, { headers })).json();
  return {
    address,
    trouble: 0,
    where: (secret) => ask("/api/where", { Authorization: "Bearer " + secret }),
    health: () => ask("/health"),
    async restart(pause_ms) {
      const over = ended();
      child.kill("SIGKILL");
      await over;
      await new Promise((resolve) => setTimeout(resolve, pause_ms));
      await start();
    },
    async stop() {
      const over = ended();
      child.kill("SIGTERM");
      await over;
    },
  };
}
