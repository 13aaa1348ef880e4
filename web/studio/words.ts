/*! @fluent/bundle: Copyright Mozilla Foundation and others, SPDX-License-Identifier: Apache-2.0 */
// The words of the page: entries of the catalogue in the reader's language, which the server puts into the page.
import { FluentBundle, FluentFunction, FluentNumber, FluentResource } from "@fluent/bundle";
import { fixed, grouped, short } from "./numbers";

export type Values = Record<string, string | number | null | undefined>;

/** A number that chooses words by its value, and is written as tables write it. */
class Numeral extends FluentNumber {
  constructor(value: number, private readonly text: string) {
    super(value);
  }

  toString(): string {
    return this.text;
  }
}

/** NUM of the catalogues: so many significant digits, or so many decimals. */
const NUM: FluentFunction = ([x], { digits, decimals }) => {
  if (!(x instanceof FluentNumber)) return x;
  return new Numeral(x.value, decimals ? fixed(x.value, Number(decimals.valueOf())) : short(x.value, digits ? Number(digits.valueOf()) : 3));
};

/** OPTION of the catalogues: a setting as a flag of the command line. */
const OPTION: FluentFunction = ([name]) => `--${String(name)}`;

const bundle = new FluentBundle(document.documentElement.lang, { useIsolating: false, functions: { NUM, OPTION } });
bundle.addResource(new FluentResource(JSON.parse(document.getElementById("words")!.textContent!) as string));

function written(code: string, attribute: string, values: Values): string | undefined {
  const message = bundle.getMessage(code.replace(".", "-"));
  const pattern = attribute ? message?.attributes[attribute] : message?.value;
  const numerals = Object.entries(values).map(([name, v]) =>
    [name, typeof v === "number" ? new Numeral(v, Number.isInteger(v) ? grouped(v) : short(v)) : v ?? "–"]);
  return pattern ? bundle.formatPattern(pattern, Object.fromEntries(numerals), []) : undefined;
}

/** The sentences of a code; the code itself where there are none. */
export const say = (code: string, values: Values = {}): string =>
  ["", "why", "do"].map((part) => written(code, part, values)).filter((text) => text).join(" ") || code;

/** What an entry adds as its title; "": nothing. */
export const titleOf = (code: string, values: Values = {}): string => written(code, "title", values) ?? "";

/** A word of the server, as "least-squares matching", as entries choose by it. */
export const keyed = (word: string): string => word.replace(/\W+/g, "_");

/** Put words into what stands in the page from the beginning. */
export function fillPage(): void {
  for (const each of document.querySelectorAll<HTMLElement>("[data-say], [data-label], [data-hint], [data-tip]")) {
    const { say: code, label, hint, tip } = each.dataset;
    if (code) each.textContent = say(code);
    if (code && titleOf(code)) each.title = titleOf(code);
    if (label) each.setAttribute("aria-label", say(label));
    if (hint) each.setAttribute("placeholder", say(hint));
    if (tip) each.title = say(tip);
  }
}
