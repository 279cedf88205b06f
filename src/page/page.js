'use strict';
(function () {
  const positions = new Float32Array(bytes(data.positions)), field = new Float32Array(bytes(data.field));
  const corners = new Uint32Array(bytes(data.corners));

  // Pale bands, one for every twentieth of the field's range, so that its level lines can be seen.
  const colors = new Float32Array(positions.length);
  for (let i = 0; i < field.length; ++i) {
    const f = field[i];
    const c = f < 0 ? [0.80, 0.80, 0.78] : [0.55 + 0.42 * f, 0.80 - 0.55 * Math.pow(f - 0.5, 2), 0.92 - 0.40 * f];
    colors.set(c, 3 * i);
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
  geometry.setAttribute('color', new THREE.BufferAttribute(colors, 3));
  geometry.setAttribute('level', new THREE.BufferAttribute(field, 1));
  geometry.setIndex(new THREE.BufferAttribute(corners, 1));
  geometry.computeVertexNormals();

  const material = new THREE.MeshLambertMaterial({ vertexColors: THREE.VertexColors, side: THREE.DoubleSide,
    polygonOffset: true, polygonOffsetFactor: 1.5, polygonOffsetUnits: 1.5 });
  material.onBeforeCompile = function (shader) {
    shader.vertexShader = 'attribute float level;\nvarying float vLevel;\n' +
      shader.vertexShader.replace('#include <begin_vertex>', '#include <begin_vertex>\nvLevel = level;');
    shader.fragmentShader = 'varying float vLevel;\n' +
      shader.fragmentShader.replace('#include <color_fragment>',
        '#include <color_fragment>\n' +
        'if (vLevel >= 0.0 && mod(floor(vLevel * 40.0), 2.0) < 0.5) diffuseColor.rgb *= 0.9;');
  };
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0xffffff);
  scene.add(new THREE.Mesh(geometry, material));

  function curves(text, color, width) {
    const array = new Float32Array(bytes(text));
    if (array.length === 0) return null;
    const lines = new THREE.LineSegmentsGeometry();
    lines.setPositions(array);
    const paint = new THREE.LineMaterial({ color: color, linewidth: width });
    scene.add(new THREE.LineSegments2(lines, paint));
    return paint;
  }
  const paints = [
    curves(data.flow, 0x2f7d3b, 2), curves(data.meridians, 0xd3202a, 4), curves(data.others, 0x1535b8, 4)
  ].filter(function (p) { return p; });

  const camera = new THREE.PerspectiveCamera(35, 1, 0.01, 100);
  let radius = 0;
  for (let i = 0; i < positions.length; i += 3)
    radius = Math.max(radius, Math.hypot(positions[i], positions[i + 1], positions[i + 2]));
  camera.position.set(1.5, 1.1, 2.8).setLength(2.95 * radius);
  const light = new THREE.DirectionalLight(0xffffff, 0.55);
  camera.add(light);
  scene.add(camera);
  scene.add(new THREE.AmbientLight(0xffffff, 0.5));
  const renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
  renderer.setPixelRatio(window.devicePixelRatio);
  document.body.appendChild(renderer.domElement);
  const controls = new THREE.TrackballControls(camera, renderer.domElement);
  controls.rotateSpeed = 3;
  controls.dynamicDampingFactor = 0.3;

  // Names beside curves.
  const labels = data.labels.map(function (label) {
    const element = document.createElement('div');
    element.className = 'label kind' + label.kind;
    element.textContent = label.text;
    document.body.appendChild(element);
    return { element: element, at: new THREE.Vector3(label.at[0], label.at[1], label.at[2]) };
  });
  function render() {
    renderer.render(scene, camera);
    labels.forEach(function (label) {
      const p = label.at.clone().project(camera);
      label.element.style.left = (p.x + 1) / 2 * window.innerWidth + 'px';
      label.element.style.top = (1 - p.y) / 2 * window.innerHeight + 'px';
    });
  }
  function resize() {
    const w = window.innerWidth, h = window.innerHeight;
    renderer.setSize(w, h);
    camera.aspect = w / h;
    camera.updateProjectionMatrix();
    paints.forEach(function (p) { p.resolution.set(w, h); });
    controls.handleResize();
    render();
  }
  window.addEventListener('resize', resize);
  controls.addEventListener('change', render);
  resize();

  // With #count in the address: how many pixels show something, for whoever opens the page without eyes.
  if (location.hash === '#count') {
    const pixels = readPixels(renderer).values;
    let drawn = 0, cut = 0;
    for (let i = 0; i < pixels.length; i += 4) {
      if (pixels[i] < 250 || pixels[i + 1] < 250 || pixels[i + 2] < 250) ++drawn;
      if ((pixels[i] > 190 && pixels[i + 1] < 60) || (pixels[i + 2] > 160 && pixels[i] < 50)) ++cut;
    }
    document.body.setAttribute('data-pixels', drawn);
    document.body.setAttribute('data-cut-pixels', cut);
  }

  (function animate() {
    requestAnimationFrame(animate);
    controls.update();
  })();
})();
