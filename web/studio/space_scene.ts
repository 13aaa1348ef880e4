// The drawn objects of object space: points, stations, ellipsoids, scale bars, what is chosen and measured.
import * as THREE from "three";
import { disc, edges, ellipsoids, enlarge, positions } from "../common/shapes";
import { coloured, Colouring, ROLE_COLOURS } from "./space_colours";
import { SpaceData } from "./space_data";

type Floats = Float32Array<ArrayBuffer>;

export class SpaceScene {
  readonly scene = new THREE.Scene();
  readonly points: THREE.Points;
  readonly special: THREE.Points;
  readonly stations: THREE.LineSegments;
  readonly ellipsoids: THREE.InstancedMesh;
  readonly bars: THREE.LineSegments;
  private readonly mark: THREE.Points;
  private readonly rays: THREE.LineSegments;
  private readonly measured: THREE.Line;
  private readonly ends: THREE.Points;
  private readonly beyond: THREE.Points;
  private readonly specialRows: number[] = [];
  /** Enlargement at which a typical ellipsoid is seen. */
  readonly typical: number;

  constructor(readonly data: SpaceData, pairs: THREE.LineSegments) {
    const map = disc();
    const dots = (size: number, more: THREE.PointsMaterialParameters = { vertexColors: true }) =>
      new THREE.PointsMaterial({ size: size * Math.min(devicePixelRatio, 2), map, alphaTest: 0.4, sizeAttenuation: false, ...more });
    for (let i = 0; i < data.points; i++) if (data.role[i] > 0) this.specialRows.push(i);
    // many points are drawn small and square: a disc for each costs a texture look-up for each pixel
    const many = data.points > 60000;
    const plain = new THREE.PointsMaterial({ size: 2 * Math.min(devicePixelRatio, 2), sizeAttenuation: false, vertexColors: true });
    this.points = new THREE.Points(positions(data.xyz), many ? plain : dots(4));
    this.points.geometry.setIndex(new THREE.BufferAttribute(mixed(data.points), 1));
    this.special = new THREE.Points(positions(this.picked(data.xyz)), dots(11));
    this.stations = new THREE.LineSegments(positions(edges(data.frusta)), new THREE.LineBasicMaterial({ color: 0x2a3a49 }));
    this.ellipsoids = ellipsoids(data.ellipsoid.length);
    this.bars = new THREE.LineSegments(positions(this.rowsOf(data.bars)), new THREE.LineBasicMaterial({ color: 0x007f5f, linewidth: 2 }));
    this.rays = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: 0x5b2a86 }));
    this.mark = new THREE.Points(new THREE.BufferGeometry(), dots(14, { color: 0xcc3d8f, depthTest: false }));
    this.measured = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: 0x111111, depthTest: false }));
    this.ends = new THREE.Points(new THREE.BufferGeometry(), dots(10, { color: 0x111111, depthTest: false }));
    this.beyond = new THREE.Points(new THREE.BufferGeometry(), dots(8, { color: 0xc2188f, depthTest: false }));
    for (const each of [this.rays, this.mark, this.measured, this.ends, this.beyond]) each.frustumCulled = false;
    this.scene.background = new THREE.Color(0xf7f5f0);
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x9a8f80, 3), this.points, this.special, this.stations, this.ellipsoids, this.bars, this.rays, this.mark, this.measured, this.ends, this.beyond, pairs);
    const sizes = data.sigma.filter((s) => s > 0).sort();
    this.typical = sizes.length ? (0.012 * data.head.extent) / sizes[Math.floor(sizes.length / 2)] : 1;
    this.enlarge(this.typical);
  }

  private picked(from: Floats): Floats {
    const out = new Float32Array(3 * this.specialRows.length);
    this.specialRows.forEach((i, k) => out.set(from.subarray(3 * i, 3 * i + 3), 3 * k));
    return out;
  }

  private rowsOf(rows: Uint32Array): Floats {
    const out = new Float32Array(3 * rows.length);
    rows.forEach((i, k) => out.set(this.data.at(i), 3 * k));
    return out;
  }

  /** Draw a share of the points, spread evenly: what a slow machine can turn. */
  thin(share: number): void {
    this.points.geometry.setDrawRange(0, share < 1 ? Math.ceil(share * this.data.points) : Infinity);
    this.ellipsoids.count = Math.ceil(share * this.data.ellipsoid.length);
  }

  /** Colour the points; returns the legend. */
  colour(by: Colouring): [string, string][] {
    const { rgb, legend } = coloured(this.data, by);
    this.points.geometry.setAttribute("color", new THREE.BufferAttribute(rgb, 4, true));
    const roles = new Float32Array(3 * this.specialRows.length);
    const colours = ROLE_COLOURS.map((hex) => new THREE.Color(hex));
    this.specialRows.forEach((i, k) => colours[Math.min(this.data.role[i], 2)].toArray(roles, 3 * k));
    this.special.geometry.setAttribute("color", new THREE.BufferAttribute(roles, 3));
    return legend;
  }

  enlarge(factor: number): void {
    enlarge(this.ellipsoids, this.data.xyz, this.data.ellipsoid, this.data.axes, factor);
  }

  /** Show the current point, and its rays to the images in which it is marked. */
  current(at: ArrayLike<number> | null, images: string[]): void {
    this.mark.geometry.dispose();
    this.rays.geometry.dispose();
    this.mark.geometry = at ? positions(new Float32Array(at)) : new THREE.BufferGeometry();
    const centres = at ? images.map((i) => this.data.centreOf(i)).filter((c) => c !== null) : [];
    const ends = new Float32Array(6 * centres.length);
    centres.forEach((c, k) => {
      ends.set(Array.from(at!), 6 * k);
      ends.set(c, 6 * k + 3);
    });
    this.rays.geometry = positions(ends);
  }

  /** Draw of the object what lies on the positive side of some planes; photographs stay whole. */
  cut(planes: THREE.Plane[]): void {
    for (const each of [this.points, this.special, this.ellipsoids, this.bars]) (each.material as THREE.Material).clippingPlanes = planes;
  }

  /** Show the points beyond a limit. */
  far(rows: number[]): void {
    this.beyond.geometry.dispose();
    this.beyond.geometry = positions(this.rowsOf(Uint32Array.from(rows)));
  }

  /** Show the points that are measured between. */
  between(rows: number[], closed: boolean): void {
    const all = closed && rows.length > 2 ? [...rows, rows[0]] : rows;
    this.measured.geometry.dispose();
    this.ends.geometry.dispose();
    this.measured.geometry = positions(this.rowsOf(Uint32Array.from(all)));
    this.ends.geometry = positions(this.rowsOf(Uint32Array.from(rows)));
  }

  dispose(): void {
    this.scene.traverse((each) => {
      if (each instanceof THREE.Points || each instanceof THREE.Line || each instanceof THREE.Mesh) {
        each.geometry.dispose();
        (each.material as THREE.Material).dispose();
      }
    });
  }
}

/** Rows in an order in which every beginning is an even choice of all. */
function mixed(count: number): Uint32Array<ArrayBuffer> {
  const rows = new Uint32Array(count);
  for (let i = 0; i < count; i++) rows[i] = i;
  let seed = 1;
  for (let i = count - 1; i > 0; i--) {
    seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
    const k = Math.floor((seed / 4294967296) * (i + 1));
    [rows[i], rows[k]] = [rows[k], rows[i]];
  }
  return rows;
}
