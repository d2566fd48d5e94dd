// Where three.js has the vertices of an animated glTF file: node animations.mjs FILE TIME... (npm: three@0.160.0).
import { readFileSync } from "node:fs";
import { AnimationMixer, LoopOnce, Vector3 } from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";

globalThis.self = globalThis;
globalThis.ProgressEvent = class {};
const [, , file, ...times] = process.argv;
const gltf = await new GLTFLoader().parseAsync(readFileSync(file, "utf8"), "");
const mixer = new AnimationMixer(gltf.scene);
const action = mixer.clipAction(gltf.animations[0]).setLoop(LoopOnce);
action.clampWhenFinished = true;
const moments = times.map(Number).map((time_s) => {
  action.reset().play();
  mixer.setTime(time_s);
  gltf.scene.updateMatrixWorld(true);
  const meshes = [];
  gltf.scene.traverse((node) => {
    if (!node.isMesh) return;
    const place = new Vector3();
    const positions = [];
    for (let i = 0; i < node.geometry.attributes.position.count; ++i) {
      node.getVertexPosition(i, place).applyMatrix4(node.matrixWorld);
      positions.push(place.toArray().map((number) => Number(number.toFixed(6))));
    }
    meshes.push({ name: node.name, positions });
  });
  return { time_s, meshes };
});
console.log(JSON.stringify({ meta: "three.js 0.160.0: animations.mjs " + file + " " + times.join(" "), moments }));
