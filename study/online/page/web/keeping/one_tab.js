// One tab at a time: two would answer the same trials.

const PATIENCE_MS = 1500; // a page that is being reloaded gives its lock back a moment after the new one asks

function byLock(name) {
  return new Promise((resolve) => {
    const waiting = new AbortController();
    const look = async () => {
      const { held } = await navigator.locks.query();
      if (held.some((lock) => lock.name === name)) waiting.abort();
      else patience = setTimeout(look, PATIENCE_MS); // nobody has it: this computer is slow
    };
    let patience = setTimeout(look, PATIENCE_MS);
    navigator.locks
      .request(name, { signal: waiting.signal }, () => {
        clearTimeout(patience);
        resolve(true);
        return new Promise(() => {}); // until the page is closed
      })
      .catch(() => resolve(false));
  });
}

/** Without a secure context there are no locks: the tab that is first answers those that ask. */
function byChannel(name) {
  return new Promise((resolve) => {
    const channel = new BroadcastChannel(name);
    const mine = Math.random();
    let taken = false;
    let settled = false;
    channel.onmessage = ({ data }) => {
      if (data.taken && !settled) taken = true;
      // Of two that ask at the same moment the smaller number gives way.
      if ("asks" in data && (settled ? !taken : data.asks < mine)) channel.postMessage({ taken: true });
    };
    channel.postMessage({ asks: mine });
    setTimeout(() => {
      settled = true;
      resolve(!taken);
      if (taken) channel.close();
    }, 400);
  });
}

/** Whether this tab is the only one that has the visit open; if so, it stays the only one until it is closed. */
export function onlyTab(name) {
  return navigator.locks ? byLock(name) : byChannel(name);
}
