// The live connection: it comes back by itself, and everything is read again when it does.
import { Live } from "./types";

export function connect(receive: (message: Live) => void, changed: (open: boolean, again: boolean) => void): void {
  let pause = 500;
  let before = false;
  const open = () => {
    const socket = new WebSocket(`${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/api/live`);
    const here = setInterval(() => socket.readyState === WebSocket.OPEN && socket.send('{"type":"here"}'), 20000);
    socket.addEventListener("open", () => {
      pause = 500;
      changed(true, before);
      before = true;
    });
    socket.addEventListener("message", (event) => receive(JSON.parse(event.data as string) as Live));
    socket.addEventListener("close", () => {
      clearInterval(here);
      changed(false, before);
      setTimeout(open, pause);
      pause = Math.min(2 * pause, 8000);
    });
  };
  open();
}
