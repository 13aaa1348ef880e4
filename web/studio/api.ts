// Asking the server: answers as data, refusals with their reason.
import { say } from "./words";

export class Refused extends Error {
  /** code  of the message, where the server has one */
  constructor(readonly status: number, message: string, readonly code = "") {
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

async function refusal(answer: Response): Promise<Refused> {
  const { status } = answer;
  try {
    const { error, code } = (await answer.json()) as { error: string; code?: string };
    return new Refused(status, error, code);
  } catch {
    return new Refused(status, say("studio_page.server_status", { status }), "studio_page.server_status");
  }
}

export async function ask<T>(path: string, query: Query = {}): Promise<T> {
  const answer = await fetch(address(path, query));
  if (!answer.ok) throw await refusal(answer);
  return (await answer.json()) as T;
}

export async function bytes(path: string): Promise<ArrayBuffer> {
  const answer = await fetch(path);
  if (!answer.ok) throw await refusal(answer);
  return answer.arrayBuffer();
}

export async function send<T>(path: string, body: unknown): Promise<T> {
  const answer = await fetch(path, {
    method: "POST", headers: { "content-type": "application/json" }, body: JSON.stringify(body),
  });
  if (!answer.ok) throw await refusal(answer);
  return (await answer.json()) as T;
}
