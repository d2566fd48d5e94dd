// What the browser keeps: every message of this visit, by its number, on the disk before anything else happens.
//
// IndexedDB with durability "strict": a write that is done is on the disk, not in a buffer that dies with the browser.

const asPromise = (request) =>
  new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });

function open(name) {
  const request = indexedDB.open(name, 1);
  request.onupgradeneeded = () => {
    request.result.createObjectStore("messages", { keyPath: "sequence" });
    request.result.createObjectStore("facts");
  };
  return asPromise(request);
}

/** Rejects when the browser keeps nothing (private windows of some, a full disk). */
export async function openStore(name) {
  const database = await open(name);
  database.onversionchange = () => database.close();

  const write = (stores, work) =>
    new Promise((resolve, reject) => {
      const transaction = database.transaction(stores, "readwrite", { durability: "strict" });
      transaction.oncomplete = () => resolve();
      transaction.onabort = () => reject(transaction.error ?? new Error("the browser's storage refused a write"));
      work(transaction);
    });

  return {
    /** All messages, in their order. */
    messages: () => asPromise(database.transaction("messages").objectStore("messages").getAll()),

    /** A number that is taken already is refused: two tabs can never write the same stream. */
    append: (message) =>
      write(["messages"], (transaction) => transaction.objectStore("messages").add(message)),

    fact: (name) => asPromise(database.transaction("facts").objectStore("facts").get(name)),

    keepFact: (name, value) =>
      write(["facts"], (transaction) => transaction.objectStore("facts").put(value, name)),

    /** Everything of this visit, for somebody who declined before anything was kept. */
    forget: () =>
      write(["messages", "facts"], (transaction) => {
        transaction.objectStore("messages").clear();
        transaction.objectStore("facts").clear();
      }),
  };
}

/** Asks the browser not to clear this site by itself. It may say no. */
export async function askForPersistence() {
  try {
    return (await navigator.storage?.persist?.()) ?? false;
  } catch {
    return false;
  }
}
