// Numbers as they are shown: a coordinate has as many digits as its standard deviation lets it have.

const DECIMAL = (1.5).toLocaleString(document.documentElement.lang)[1];

/** With the decimal sign of the reader's language. */
export const local = (text: string): string => text.replace(".", DECIMAL);

/** A whole number in groups of three digits. */
export const grouped = (n: number): string => String(n).replace(/\B(?=(\d{3})+(?!\d))/g, "\u202f");

/** Decimals that show a standard deviation with two digits. */
export function decimalsOf(sigma: number | null | undefined, otherwise = 4): number {
  if (sigma === null || sigma === undefined || !(sigma > 0) || !Number.isFinite(sigma)) return otherwise;
  return Math.min(Math.max(1 - Math.floor(Math.log10(sigma)), 0), 9);
}

export function fixed(value: number | null | undefined, decimals: number): string {
  return value === null || value === undefined || !Number.isFinite(value) ? "–" : local(value.toFixed(decimals));
}

/** A few digits, without an exponent where that can be. */
export function short(value: number | null | undefined, digits = 3): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size !== 0 && (size >= 1e7 || size < 1e-6)) return local(value.toExponential(digits - 1));
  return local(size >= 10 ** (digits - 1) ? value.toFixed(0) : String(Number(value.toPrecision(digits))));
}

export const withUnit = (text: string, unit: string): string => (unit ? `${text} ${unit}` : text);
