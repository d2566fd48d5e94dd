// A stand-in for JATOS 3.10, written from its published routes (modules/publix/conf/publix.routes of github.com/JATOS/JATOS)
// and from what its jatos.js asks of them: study links, runs, cookies, results, the batch channel, ends. `library` is the
// folder of JATOS's own scripts (modules/publix/public); without one a jatos.js of ours takes its place, which loads its parts
// and reports failures as JATOS's does.
import { createHash, randomBytes, randomUUID } from "node:crypto";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { bodyOf, fails, listening, sendFile } from "./hosts.mjs";

const COMPONENT = "11111111-2222-4333-8444-555555555555";
const CODE = "aBcDeFgHiJk";
// Play's filter adds it to everything that is not marked `nocsp` in the routes.
const POLICY = { "Content-Security-Policy": "base-uri 'self'; object-src 'none'; script-src 'nonce-x' 'unsafe-inline' 'strict-dynamic' https: http:" };

const OURS = {
  "jatos.js": `
var jatos = { version: "stand-in", httpRetry: 5, httpTimeout: 30000, httpRetryWait: 1000, studyLength: null, urlQueryParameters: undefined };
(() => {
  let over, ready = new Promise((resolve) => { over = resolve; });
  jatos.onLoad = (then) => void ready.then(then);
  const script = document.createElement("script");
  script.src = "jatos-publix/javascripts/jquery.js";
  script.onload = () => start(jQuery.noConflict(true)).catch(() => {}).finally(over);
  document.head.append(script);
  const here = (path) => new URL(path, location.href).toString();

  async function start(own) {
    own.ajaxSetup({ cache: true });
    await own.getScript("jatos-publix/javascripts/parts.js");
    await window.jatosParts();
    const data = await (await fetch(here("initData"))).json();
    jatos.urlQueryParameters = data.urlQueryParameters;
    jatos.componentList = data.componentList;
    jatos.studyLength = data.componentList.length;
    const channel = new WebSocket(here("../batch/open").replace(/^http/, "ws"));
    await new Promise((resolve) => (channel.onmessage = channel.onerror = resolve));
    jatos.channel = channel.readyState;
  }

  /** As jQuery's promises do, whoever waits gets several arguments. */
  function ask(method, path, data) {
    let left = jatos.httpRetry;
    const promise = new Promise((resolve, reject) => {
      const again = () => {
        const request = new XMLHttpRequest();
        request.open(method, here(path));
        request.timeout = jatos.httpTimeout;
        request.setRequestHeader("X-Requested-With", "XMLHttpRequest");
        const failed = (error) => {
          if (left-- > 0 && request.status !== 400 && request.status !== 413) return setTimeout(again, jatos.httpRetryWait);
          const words = [request.status, request.statusText, error].filter((one) => one).join(", ");
          reject([method + " to " + here(path) + " failed: " + words, request.status, request.statusText, error]);
        };
        request.onload = () => (request.status === 200 ? resolve() : failed(request.responseText.trim() || null));
        request.onerror = () => failed(null);
        request.ontimeout = () => failed("timeout");
        request.send(data);
      };
      again();
    });
    return { then: (yes, no) => void promise.then(yes, (all) => no?.(...all)) };
  }

  jatos.appendResultData = (text) => ask("POST", "resultData", text);
  jatos.endStudy = (successful, message, showEndPage = true) => {
    const path = "../end?" + new URLSearchParams({ successful, ...(message === undefined ? {} : { message }) });
    if (!showEndPage) return ask("GET", path);
    location.href = here(path);
  };
})();`,
  // jQuery 3: scripts of the page's own origin become text in the page, unless attributes are asked for.
  "jatos-publix/javascripts/jquery.js": `
window.jQuery = (() => {
  const settings = {};
  const own = {
    ajaxSetup: (more) => Object.assign(settings, more),
    async getScript(address) {
      const script = document.createElement("script");
      if (settings.scriptAttrs) script.src = address;
      else script.text = await (await fetch(address)).text();
      const loaded = settings.scriptAttrs ? new Promise((resolve, reject) => ((script.onload = resolve), (script.onerror = reject))) : null;
      document.head.append(script);
      await loaded;
    },
    noConflict: () => ((window.jQuery = undefined), own),
  };
  return own;
})();`,
  "jatos-publix/javascripts/parts.js": `window.jatosParts = () => {};`,
};

/** The server's half of a WebSocket: one text before anything is asked, "pong" for a beat. */
function openChannel(request, socket, first) {
  const accept = createHash("sha1").update(request.headers["sec-websocket-key"] + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11").digest("base64");
  socket.write("HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: " + accept + "\r\n\r\n");
  const say = (text) => socket.write(Buffer.concat([Buffer.from([0x81, text.length]), Buffer.from(text)]));
  say(first);
  socket.on("data", (frame) => {
    if ((frame[0] & 15) === 8) return socket.end(Buffer.from([0x88, 0]));
    const mask = frame.subarray(2, 6);
    const text = Buffer.from(frame.subarray(6).map((byte, at) => byte ^ mask[at % 4])).toString();
    if (text.includes("ping")) say('{"heartbeat":"pong"}');
  });
  socket.on("error", () => {});
}

export async function jatosHost(folder, trouble = 0.3, { library = process.env.SEAMLINE_JATOS, endRedirectUrl = "" } = {}) {
  const runs = new Map();
  const host = await listening(answerTo);
  const address = host.address + "publix/" + CODE;

  function begin(query) {
    const run = { id: randomUUID(), state: "STARTED", message: null, components: [], query: Object.fromEntries(query), channels: 0, assets: randomBytes(4).toString("hex") };
    runs.set(run.id, run);
    return run;
  }
  const isDone = (run) => ["FINISHED", "FAIL", "ABORTED"].includes(run.state);
  const cookieOf = (run) =>
    "JATOS_IDS_0=" +
    Object.entries({ batchId: 1, componentId: 2, componentPos: 1, componentResultId: run.components.length, creationTime: 1, studyAssets: "seamline", urlBasePath: "/", jatosRun: "null", studyId: 3, studyResultId: [...runs.keys()].indexOf(run.id) + 1, studyResultUuid: run.id, workerId: 4, workerType: "GeneralMultiple" })
      .map(([key, value]) => key + "=" + value)
      .join("&") + "; Path=/";

  function say(response, status, text, headers = {}) {
    response.writeHead(status, { "Content-Type": "text/plain; charset=utf-8", ...POLICY, ...headers }).end(text);
  }

  async function append(run, request, response) {
    const failure = fails(host.trouble);
    const text = await bodyOf(request);
    if (isDone(run)) return say(response, 403, "Study run is already finished (study result 1)");
    if (failure !== "before") {
      run.components.at(-1).data += text;
      host.lines.push(...text.split("\n").filter((line) => line !== ""));
    }
    if (failure === "cut") return response.destroy();
    say(response, failure ? 500 : 200, failure ? "JATOS error: Internal JATOS error" : "");
  }

  function end(run, request, response, query) {
    const successful = query.get("successful") !== "false";
    if (!isDone(run)) Object.assign(run, { state: successful ? "FINISHED" : "FAIL", message: query.get("message") });
    const headers = { "Set-Cookie": "JATOS_IDS_0=; Path=/; Max-Age=0" };
    if (request.headers["x-requested-with"]) return say(response, 200, "", headers);
    if (!successful) return say(response, 200, run.message ?? "", headers);
    say(response, 303, "", { ...headers, Location: "/publix/" + run.id + "/final/endPage.html" });
  }

  function endPage(run, response) {
    if (!isDone(run)) return say(response, 400, "The study result " + run.id + " isn't finished yet.");
    if (endRedirectUrl) return say(response, 303, "", { Location: endRedirectUrl.replace(/\[(.*?)\]/g, (_, name) => encodeURIComponent(run.query[name] ?? "undefined")) });
    if (existsSync(join(folder + "-jatos", "endPage.html"))) return sendFile(folder + "-jatos", "/endPage.html", response);
    response.writeHead(200, { "Content-Type": "text/html; charset=utf-8" }).end("<title>End</title>This experiment is finished.");
  }

  /** jatos.js and what it loads, else the study's assets, which only a browser with a run may have. */
  function file(run, name, request, response) {
    if (OURS[name] && !library) return response.writeHead(200, { "Content-Type": "text/javascript", ...POLICY }).end(OURS[name]);
    if (name === "jatos.js") return sendFile(join(library, "javascripts"), "/jatos.js", response);
    if (name.startsWith("jatos-publix/")) return sendFile(library ?? "/nowhere", "/" + name.slice("jatos-publix/".length), response);
    if (!(request.headers.cookie ?? "").includes("studyAssets=seamline")) return say(response, 403, "Not allowed to access study assets outside of a study run");
    sendFile(folder + "-jatos", "/" + name, response);
  }

  async function answerTo(request, response, path) {
    const { searchParams } = new URL(request.url, "http://x");
    if (path === "/publix/" + CODE) {
      const run = begin(searchParams);
      return say(response, 303, "", { "Set-Cookie": cookieOf(run), Location: "/publix/" + run.id + "/" + COMPONENT + "/start" });
    }
    const [, root, id, ...rest] = path.split("/");
    const run = runs.get(id);
    if (root !== "publix" || !run) return say(response, 400, "A study result " + id + " doesn't exist.");
    if (rest[0] === "end") return end(run, request, response, searchParams);
    if (rest[0] === "heartbeat") return say(response, 200, "");
    if (path.endsWith("/final/endPage.html")) return endPage(run, response);
    if (rest[0] !== COMPONENT) return say(response, 404, "nothing here");
    const name = rest.slice(1).join("/");
    if (name === "resultData") return append(run, request, response);
    if (name === "start" || name === "initData") {
      if (isDone(run)) return say(response, 403, "Study run is already finished (study result 1)");
    }
    if (name === "start") {
      run.components.push({ data: "" }); // a component that may be loaded again begins a result of its own each time
      response.setHeader("Set-Cookie", cookieOf(run));
      return sendFile(folder + "-jatos", "/index.html", response);
    }
    if (name !== "initData") return file(run, name, request, response);
    run.state = "DATA_RETRIEVED";
    const component = { id: 2, uuid: COMPONENT, title: "page", active: true, reloadable: true, position: 1 };
    const data = { studySessionData: "{}", studyProperties: { title: "study" }, batchProperties: { title: "Default" }, componentList: [component], componentProperties: component, urlQueryParameters: run.query, studyCode: CODE };
    response.writeHead(200, { "Content-Type": "application/json", ...POLICY }).end(JSON.stringify(data));
  }

  host.server.on("upgrade", (request, socket) => {
    const run = runs.get(request.url.split("/")[2]);
    if (!run || !request.url.endsWith("/batch/open")) return socket.destroy();
    ++run.channels;
    openChannel(request, socket, '{"data":{},"version":1}');
  });

  return Object.assign(host, {
    address,
    /** In the order in which they began: {id, state, message, components: [{data}], query, channels}. */
    runs: () => [...runs.values()],
    lines: [],
    trouble,
    get ended() {
      return [...runs.values()].at(-1)?.state === "FINISHED";
    },
  });
}
