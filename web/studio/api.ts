// Asking the server: answers as data, refusals with their reason.

export class Refused extends Error {
  constructor(readonly status: number, message: string) {
    super(message);
  }
}

type Query = Record<string, string | number | string[]>;

function address(path: string, query: Query): string {
  const words = new URLSearchParams();
  for (const [name, value] of Object.entries(query))
    for (const each of Array.isArray(value) ? value : [value]) words.append(name, String(each));
  const text = words.toString();
  return text ? `${path}?${text}` : path;
}

async function reason(answer: Response): Promise<string> {
  try {
    return ((await answer.json()) as { error: string }).error;
  } catch {
    return `the server answered ${answer.status}`;
  }
}

export async function ask<T>(path: string, query: Query = {}): Promise<T> {
  const answer = await fetch(address(path, query));
  if (!answer.ok) throw new Refused(answer.status, await reason(answer));
  return (await answer.json()) as T;
}

export async function bytes(path: string): Promise<ArrayBuffer> {
  const answer = await fetch(path);
  if (!answer.ok) throw new Refused(answer.status, await reason(answer));
  return answer.arrayBuffer();
}

export async function tell<T>(path: string, body: unknown): Promise<T> {
  const answer = await fetch(path, {
    method: "POST", headers: { "content-type": "application/json" }, body: JSON.stringify(body),
  });
  if (!answer.ok) throw new Refused(answer.status, await reason(answer));
  return (await answer.json()) as T;
}
