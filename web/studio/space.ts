import { Model } from "./model";
export class Space {
  constructor(_model: Model, _open: (image: string) => void) {}
  async show(): Promise<void> {}
}
