// The drawn objects: points, frusta of the images, scale bars, error ellipsoids, and the rays of one point.
import * as THREE from "three";
import { disc, edges, ellipsoids, enlarge, positions } from "../common/shapes";
import { Network } from "./data";

export class Drawn {
  readonly points: THREE.Points;
  readonly special: THREE.Points;
  readonly frames: THREE.LineSegments;
  readonly proposals: THREE.LineSegments;
  readonly bars: THREE.LineSegments;
  readonly ellipsoids: THREE.InstancedMesh;
  readonly rays: THREE.LineSegments;
  readonly mark: THREE.Points;
  readonly surface: THREE.Mesh;
  readonly cloud: THREE.Points;
  private readonly specialRows: number[];

  constructor(private readonly net: Network) {
    const map = disc();
    const material = (size: number) =>
      new THREE.PointsMaterial({ size, map, alphaTest: 0.4, sizeAttenuation: false, vertexColors: true });
    this.specialRows = [...net.role.keys()].filter((i) => net.role[i] > 0);
    this.points = new THREE.Points(positions(net.xyz), material(3.5));
    const special = new Float32Array(3 * this.specialRows.length);
    this.specialRows.forEach((i, k) => special.set(net.xyz.subarray(3 * i, 3 * i + 3), 3 * k));
    this.special = new THREE.Points(positions(special), material(11));
    const proposed = new Set(net.proposed);
    const taken = [...Array(net.images).keys()].filter((i) => !proposed.has(i));
    this.frames = new THREE.LineSegments(
      positions(edges(net.frustaOf(taken))),
      new THREE.LineBasicMaterial({ color: 0x3d4f60, transparent: true, opacity: 0.75 }),
    );
    this.proposals = new THREE.LineSegments(
      positions(edges(net.frustaOf(net.proposed))),
      new THREE.LineBasicMaterial({ color: 0xd0021b }),
    );
    this.bars = new THREE.LineSegments(
      positions(joined(net)),
      new THREE.LineBasicMaterial({ color: 0x2e8b57, linewidth: 2 }),
    );
    this.ellipsoids = ellipsoids(net.ellipsoid.length);
    this.rays = new THREE.LineSegments(
      new THREE.BufferGeometry(),
      new THREE.LineBasicMaterial({ color: 0xd08a1d, transparent: true, opacity: 0.9 }),
    );
    this.mark = new THREE.Points(
      new THREE.BufferGeometry(),
      new THREE.PointsMaterial({ size: 14, map, alphaTest: 0.4, sizeAttenuation: false, color: 0xd08a1d }),
    );
    this.surface = new THREE.Mesh(
      positions(net.surface),
      new THREE.MeshLambertMaterial({ vertexColors: true, side: THREE.DoubleSide, flatShading: true }),
    );
    this.surface.geometry.computeVertexNormals();
    this.cloud = new THREE.Points(
      positions(net.cloud),
      new THREE.PointsMaterial({ size: 2, sizeAttenuation: false, vertexColors: true }),
    );
    this.rays.frustumCulled = this.mark.frustumCulled = false;
    this.enlarge(net.packed.ellipsoids.enlarged);
  }

  all(): THREE.Object3D[] {
    return [this.surface, this.cloud, this.points, this.special, this.frames, this.proposals, this.bars, this.ellipsoids, this.rays, this.mark];
  }

  /** Colours of all points, and of the control and check points that are drawn larger. */
  colour(rgb: Float32Array<ArrayBuffer>, roles: Float32Array<ArrayBuffer>): void {
    this.points.geometry.setAttribute("color", new THREE.BufferAttribute(rgb, 3));
    const special = new Float32Array(3 * this.specialRows.length);
    this.specialRows.forEach((i, k) => special.set(roles.subarray(3 * i, 3 * i + 3), 3 * k));
    this.special.geometry.setAttribute("color", new THREE.BufferAttribute(special, 3));
  }

  /** Colours of the dense points. */
  colourCloud(rgb: Float32Array<ArrayBuffer>): void {
    this.cloud.geometry.setAttribute("color", new THREE.BufferAttribute(rgb, 3));
  }

  /** Colours of the object's triangles. */
  colourSurface(rgb: Float32Array<ArrayBuffer>): void {
    const each = new Float32Array(3 * rgb.length);
    for (let k = 0; k < rgb.length / 3; k++) for (let j = 0; j < 3; j++) each.set(rgb.subarray(3 * k, 3 * k + 3), 9 * k + 3 * j);
    this.surface.geometry.setAttribute("color", new THREE.BufferAttribute(each, 3));
  }

  /** Draw the ellipsoids this many times their 1 sigma size. */
  enlarge(factor: number): void {
    const { axes, ellipsoid, xyz } = this.net;
    enlarge(this.ellipsoids, xyz, ellipsoid, axes, factor);
  }

  /** Show the rays of a point to the images that measured it. */
  select(point: number | null): void {
    const { frusta, xyz } = this.net;
    if (point === null) {
      this.rays.geometry = new THREE.BufferGeometry();
      this.mark.geometry = new THREE.BufferGeometry();
      return;
    }
    const here = xyz.subarray(3 * point, 3 * point + 3);
    const seen = this.net.imagesOf(point);
    const ends = new Float32Array(6 * seen.length);
    seen.forEach((image, k) => {
      ends.set(here, 6 * k);
      ends.set(frusta.subarray(15 * image, 15 * image + 3), 6 * k + 3);
    });
    this.rays.geometry = positions(ends);
    this.mark.geometry = positions(here.slice());
  }

  /** Show the points that an image measured. */
  selectImage(image: number): void {
    const rows: number[] = [];
    for (let p = 0; p < this.net.points; p++) if (this.net.imagesOf(p).includes(image)) rows.push(p);
    const centre = this.net.frusta.subarray(15 * image, 15 * image + 3);
    const ends = new Float32Array(6 * Math.min(rows.length, 3000));
    const step = rows.length / (ends.length / 6);
    for (let k = 0; k < ends.length / 6; k++) {
      const p = rows[Math.floor(k * step)];
      ends.set(centre, 6 * k);
      ends.set(this.net.xyz.subarray(3 * p, 3 * p + 3), 6 * k + 3);
    }
    this.rays.geometry = positions(ends);
    this.mark.geometry = positions(centre.slice());
  }
}

function joined(net: Network): Float32Array<ArrayBuffer> {
  const out = new Float32Array(3 * net.bars.length);
  net.bars.forEach((p, k) => out.set(net.xyz.subarray(3 * p, 3 * p + 3), 3 * k));
  return out;
}
