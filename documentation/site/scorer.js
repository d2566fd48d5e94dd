// What a search finds: titles first, and of pages that hold a word equally, what to do before why, and why before how it was measured.
var Scorer = {
  score: ([page, , , , score]) => score + (/^(tutorials|how-to)\//.test(page) ? 3 : /^(reference|explanation)\//.test(page) ? 2 : 0),
  objNameMatch: 11, objPartialMatch: 6, objPrio: { 0: 15, 1: 5, 2: -5 }, objPrioDefault: 0,
  title: 15, partialTitle: 7, term: 5, partialTerm: 2,
};
