// What is wrong with an answer in the form (stimuli/definition/form_definition.h).

// A decimal number as the program reads it: no plus, no spaces, no hexadecimal, no infinity.
const DECIMAL = /^-?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/;

function faultOfNumber(field, value) {
  const number = DECIMAL.test(value) ? Number(value) : NaN;
  if (!Number.isFinite(number) || (field.whole && !Number.isInteger(number))) return "not_a_number";
  return number < field.least || number > field.most ? "out_of_range" : null;
}

/** What is stored of a choice: the study's own options, in whatever language they are read. */
export const valuesOf = (field) => field.values ?? field.options;

/** A question with bounds stores a number, any other one of its values. */
const storesNumber = (field) => field.least !== undefined;

/** "missing", "not_a_number", "out_of_range", "not_an_option" or null. */
export function faultOf(field, value) {
  if (value === "") return field.required ? "missing" : null;
  if (storesNumber(field)) return faultOfNumber(field, value);
  return valuesOf(field).includes(value) ? null : "not_an_option";
}
