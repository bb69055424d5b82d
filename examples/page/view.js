// The meshes as three.js draws them: a group for each state of a showcase, one light, one camera.

const SCALE = ['#0d0887', '#6a00a8', '#b12a90', '#e16462', '#fca636', '#f0f921']; // plasma

/** A colour of the scale, from 0 to 1, as three numbers of linear light. */
function scaleColour(value, out = new THREE.Color()) {
  const place = Math.min(Math.max(value, 0), 1) * (SCALE.length - 1);
  const k = Math.min(Math.floor(place), SCALE.length - 2);
  return out.set(SCALE[k]).lerp(new THREE.Color(SCALE[k + 1]), place - k);
}

/** A mesh for each paint of a state, and its edges; they share points and normals. */
function stateGroup(showcase, state, body) {
  const group = new THREE.Group();
  const hidden = new Set(state.hidden);
  const points = new THREE.BufferAttribute(body.points, 3);
  const normals = new THREE.BufferAttribute(normalsOf(body, hidden), 3);
  let measured = null;
  if (body.distances) {
    const colours = new Float32Array(body.points.length), colour = new THREE.Color();
    body.distances.forEach((step, v) => scaleColour(step === 65535 ? 0 : step / 65534, colour).toArray(colours, 3 * v));
    measured = new THREE.BufferAttribute(colours, 3);
  }
  partsOf(body, showcase.paints, hidden).forEach((part, k) => {
    if (part.triangles.length === 0) return;
    const paint = showcase.paints[k];
    const look = { side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
    const own = { ...look, metalness: paint.metalness, roughness: paint.roughness };
    const geometry = new THREE.BufferGeometry();
    let coloured = false;
    if (body.faceColours && !paint.joint) {
      // Colours of faces end sharply at their edges, so that vertices cannot be shared.
      const gathered = (from, at) => {
        const out = new Float32Array(3 * part.triangles.length);
        for (let c = 0; c < part.triangles.length; ++c) {
          const k = 3 * at(c);
          out.set([from[k], from[k + 1], from[k + 2]], 3 * c);
        }
        return new THREE.BufferAttribute(out, 3);
      };
      geometry.setAttribute('position', gathered(body.points, (c) => part.triangles[c]));
      geometry.setAttribute('normal', gathered(normals.array, (c) => part.triangles[c]));
      geometry.setAttribute('color', gathered(body.faceColours, (c) => part.faces[Math.floor(c / 3)]));
      coloured = true;
    } else {
      geometry.setAttribute('position', points);
      geometry.setAttribute('normal', normals);
      geometry.setIndex(new THREE.BufferAttribute(Uint32Array.from(part.triangles), 1));
      if (body.vertexColours && !paint.joint) {
        geometry.setAttribute('color', new THREE.BufferAttribute(body.vertexColours, 3));
        coloured = true;
      }
    }
    const plain = new THREE.MeshStandardMaterial({ ...own, color: coloured ? '#ffffff' : paint.colour, vertexColors: coloured });
    const mesh = new THREE.Mesh(geometry, plain);
    mesh.castShadow = mesh.receiveShadow = true;
    group.add(mesh);
    if (paint.joint && measured) {
      const geometryOfDistances = new THREE.BufferGeometry();
      geometryOfDistances.setAttribute('position', points);
      geometryOfDistances.setAttribute('normal', normals);
      geometryOfDistances.setAttribute('color', measured);
      geometryOfDistances.setIndex(geometry.index);
      mesh.userData = {
        plain: [geometry, plain],
        measured: [geometryOfDistances, new THREE.MeshStandardMaterial({ ...look, vertexColors: true, roughness: 0.7 })],
      };
    }
    const lines = new THREE.BufferGeometry();
    lines.setAttribute('position', points);
    lines.setIndex(new THREE.BufferAttribute(Uint32Array.from(part.edges), 1));
    const edges = new THREE.LineSegments(lines, new THREE.LineBasicMaterial({ color: '#101418', transparent: true, opacity: 0.5 }));
    edges.userData.isWire = true;
    edges.visible = false;
    group.add(edges);
  });
  for (const curve of body.curves) {
    const path = new THREE.CatmullRomCurve3(curve.points.map((p) => new THREE.Vector3(...p)), curve.closed);
    const tube = new THREE.TubeGeometry(path, 2 * curve.points.length, curve.radius, 8, curve.closed);
    group.add(new THREE.Mesh(tube, new THREE.MeshStandardMaterial({ color: curve.colour, roughness: 0.5 })));
  }
  return group;
}

class View {
  constructor(canvas, changed) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.toneMapping = THREE.NeutralToneMapping;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = THREE.PCFShadowMap;
    this.scene = new THREE.Scene();
    const generator = new THREE.PMREMGenerator(this.renderer);
    this.scene.environment = generator.fromScene(new THREE.RoomEnvironment(), 0.04).texture;
    this.scene.environmentIntensity = 0.5;
    this.camera = new THREE.PerspectiveCamera(28, 1, 0.1, 100);
    this.light = new THREE.DirectionalLight('#fff4e2', 1.75);
    this.light.castShadow = true;
    this.light.shadow.mapSize.set(2048, 2048);
    this.light.shadow.radius = 4;
    this.scene.add(this.light, this.light.target, this.camera);
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.addEventListener('change', changed);
    this.states = [];
  }

  /** Shows a showcase with decoded bodies, in place of the current one. */
  show(showcase, bodies) {
    for (const state of this.states) {
      state.traverse((object) => {
        object.geometry?.dispose();
        object.material?.dispose();
      });
      this.scene.remove(state);
    }
    this.showcase = showcase;
    this.bodies = bodies;
    // Up is y from here on.
    this.turn = new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(...showcase.up).normalize(), new THREE.Vector3(0, 1, 0));
    this.states = showcase.states.map((state) => {
      const group = stateGroup(showcase, state, bodies[state.body]);
      group.quaternion.copy(this.turn);
      this.scene.add(group);
      return group;
    });
    const box = new THREE.Box3();
    this.eachPoint((p) => box.expandByPoint(p));
    this.ball = box.getBoundingSphere(new THREE.Sphere());
    Object.assign(this.light.shadow.camera, { near: 0.1 * this.ball.radius, far: 8 * this.ball.radius });
    this.light.shadow.normalBias = 0.004 * this.ball.radius;
    this.light.shadow.bias = -0.0005;
    this.camera.near = 0.01 * this.ball.radius;
    this.camera.far = 60 * this.ball.radius;
  }

  /** Calls with each vertex of a face, where it is drawn; the vector is the same each time. */
  eachPoint(visit) {
    const p = new THREE.Vector3();
    for (const { points, used } of this.bodies) {
      for (let v = 0; v < used.length; ++v) {
        if (used[v]) visit(p.fromArray(points, 3 * v).applyQuaternion(this.turn));
      }
    }
  }

  setWire(on) {
    for (const state of this.states) {
      state.traverse((object) => {
        if (object.userData.isWire) object.visible = on;
      });
    }
  }

  setMeasured(on) {
    for (const state of this.states) {
      for (const object of state.children) {
        const looks = object.userData[on ? 'measured' : 'plain'];
        if (looks) [object.geometry, object.material] = looks;
      }
    }
  }

  resize(width, height, ratio) {
    this.width = width;
    this.height = height;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
  }

  /** Puts the camera where all points are seen; `share`: the part of the width that one picture has; `zoom` above 1 is nearer. */
  lookAtAll(direction, share, zoom = 1) {
    const towards = new THREE.Vector3(...direction).applyQuaternion(this.turn).normalize();
    const right = new THREE.Vector3(0, 1, 0).cross(towards).normalize(), up = towards.clone().cross(right);
    const basis = [right, up, towards], low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    const each = (visit) => this.eachPoint((p) => visit(basis.map((axis) => axis.dot(p))));
    each((p) => p.forEach((value, k) => {
      low[k] = Math.min(low[k], value);
      high[k] = Math.max(high[k], value);
    }));
    const middle = low.map((value, k) => (value + high[k]) / 2);
    const tall = Math.tan((this.camera.fov * Math.PI) / 360), wide = (tall * this.width * share) / this.height;
    let distance = 0;
    each((p) => {
      const x = Math.abs(p[0] - middle[0]) / wide, y = Math.abs(p[1] - middle[1]) / tall;
      distance = Math.max(distance, 1.08 * Math.max(x, y) + p[2] - middle[2]);
    });
    const centre = new THREE.Vector3();
    basis.forEach((axis, k) => centre.addScaledVector(axis, middle[k]));
    this.place(centre, towards, distance / zoom);
  }

  /** Puts the camera before the place for a close look. */
  lookNear(share) {
    const { centre, eye, radius } = this.showcase.near;
    const towards = new THREE.Vector3(...eye).applyQuaternion(this.turn).normalize();
    const tall = Math.tan((this.camera.fov * Math.PI) / 360), wide = (tall * this.width * share) / this.height;
    this.place(new THREE.Vector3(...centre).applyQuaternion(this.turn), towards, radius / Math.min(tall, wide));
  }

  place(centre, towards, distance) {
    this.controls.target.copy(centre);
    this.camera.position.copy(centre).addScaledVector(towards, distance);
    this.camera.updateProjectionMatrix();
    this.controls.update();
  }

  /** Turns the camera round its target, by angles. */
  orbit(aside, upwards) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const place = new THREE.Spherical().setFromVector3(offset);
    place.theta += aside;
    place.phi = Math.min(Math.max(place.phi + upwards, 0.02), Math.PI - 0.02);
    this.camera.position.setFromSpherical(place).add(this.controls.target);
    this.controls.update();
  }

  zoom(factor) {
    this.camera.position.sub(this.controls.target).multiplyScalar(factor).add(this.controls.target);
    this.controls.update();
  }

  /** Draws two states: each in a half of its own, or one to the left and one to the right of a line at `share` of the width. */
  draw(left, right, share, isSideBySide) {
    const { renderer, width, height } = this;
    // The light comes from above the reader's left shoulder; the resolution of its shadows follows the size of the
    // view.
    const { target } = this.controls, distance = this.camera.position.distanceTo(target);
    const reach = Math.min(this.ball.radius + this.ball.center.distanceTo(target), 0.45 * distance);
    this.camera.updateMatrixWorld();
    this.light.target.position.copy(target);
    this.light.position.set(-1, 1.5, 1.6).normalize().transformDirection(this.camera.matrixWorld).multiplyScalar(3 * this.ball.radius).add(target);
    Object.assign(this.light.shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach });
    this.light.shadow.camera.updateProjectionMatrix();
    const only = (shown) => this.states.forEach((state, k) => {
      state.visible = k === shown;
    });
    const half = Math.round(width / 2), line = isSideBySide ? half : Math.round(share * width);
    this.camera.aspect = (isSideBySide ? half : width) / height;
    this.camera.updateProjectionMatrix();
    renderer.setScissorTest(true);
    for (const [shown, x, w] of [[left, 0, line], [right, line, width - line]]) {
      if (w <= 0) continue;
      only(shown);
      renderer.setScissor(x, 0, w, height);
      renderer.setViewport(isSideBySide ? x : 0, 0, isSideBySide ? half : width, height);
      renderer.render(this.scene, this.camera);
    }
  }
}
