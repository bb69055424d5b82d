// What the page uses of three.js; update.sh makes three.min.js of it.
export {
  Box3, BufferAttribute, BufferGeometry, CatmullRomCurve3, Color, DirectionalLight, DoubleSide, Group, LineBasicMaterial, LineSegments, Mesh,
  MeshStandardMaterial, NeutralToneMapping, PCFShadowMap, PerspectiveCamera, PMREMGenerator, Quaternion, Scene, Sphere, Spherical,
  TubeGeometry, Vector3, WebGLRenderer,
} from 'three';
export { OrbitControls } from 'three/addons/controls/OrbitControls.js';
export { RoomEnvironment } from 'three/addons/environments/RoomEnvironment.js';
