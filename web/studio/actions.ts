// Actions on their way: one after the other, each sent again until it is answered; sent twice it counts once.
import { Refused, send } from "./api";
import { ActionAnswer } from "./types";

interface Waiting {
  path: string;
  body: Record<string, unknown>;
  done: (answer: ActionAnswer) => void;
  refused: (error: Error) => void;
}

const LONGEST_PAUSE = 5000;

export class Actions {
  private readonly waiting: Waiting[] = [];
  private busy = false;
  author = "";

  /** Called when the number of actions that wait for an answer changes, and whether the last try was lost. */
  onwaiting: (count: number, lost: boolean) => void = () => {};

  constructor() {
    addEventListener("beforeunload", (event) => {
      if (this.waiting.length) event.preventDefault();
    });
  }

  send(verb: string, args: Record<string, unknown>): Promise<ActionAnswer> {
    return this.put("/api/action", { verb, arguments: args });
  }

  /** A table of control coordinates. */
  control(file: string, text: string): Promise<ActionAnswer & { added: string[]; remarks: string[] }> {
    return this.put("/api/control", { file, text }) as Promise<ActionAnswer & { added: string[]; remarks: string[] }>;
  }

  /** All image observations beyond a limit: one action. */
  reject(by: string, limit: number): Promise<ActionAnswer> {
    return this.put("/api/reject", { by, limit });
  }

  /** Find the other fiducial marks of a scan. */
  fiducials(image: string): Promise<ActionAnswer & { found: string[]; left: Record<string, string> }> {
    return this.put("/api/fiducials", { image }) as Promise<ActionAnswer & { found: string[]; left: Record<string, string> }>;
  }

  private put(path: string, body: Record<string, unknown>): Promise<ActionAnswer> {
    const whole = { id: crypto.randomUUID(), author: this.author, ...body };
    return new Promise((done, refused) => {
      this.waiting.push({ path, body: whole, done, refused });
      void this.work();
    });
  }

  private async work(): Promise<void> {
    if (this.busy) return;
    this.busy = true;
    let pause = 250;
    while (this.waiting.length) {
      const { path, body, done, refused } = this.waiting[0];
      this.onwaiting(this.waiting.length, pause > 250);
      try {
        const answer = await send<ActionAnswer>(path, body);
        this.waiting.shift();
        pause = 250;
        done(answer);
      } catch (error) {
        if (error instanceof Refused && error.status < 500) {
          this.waiting.shift();
          refused(error);
          continue;
        }
        // nobody knows whether it arrived: the same id goes again
        pause = Math.min(2 * pause, LONGEST_PAUSE);
        this.onwaiting(this.waiting.length, true);
        await new Promise((go) => setTimeout(go, pause));
      }
    }
    this.busy = false;
    this.onwaiting(0, false);
  }
}
