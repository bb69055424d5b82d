// The page: its controls, and the part of the address after #, select the view.
//   #show=ID  pair=0  slider=0..1  side=1  wire=1  distance=0  look=near  eye=x,y,z  zoom=1.2  theme=dark
//   plain=1: nothing but the meshes; named=1: with the names of the states

const by = (id) => document.getElementById(id);

async function start() {
  if (!window.WebGL2RenderingContext || !window.DecompressionStream) {
    throw new Error('This page needs a browser of 2023 or later, with WebGL 2.');
  }
  const source = document.createElement('script');
  source.textContent = new TextDecoder().decode(await unpacked('three'));
  document.head.append(source);
  const arrays = await unpacked('arrays');
  const showcases = JSON.parse(by('described').textContent);

  let drawn = 0, isWaiting = false;
  const draw = () => {
    isWaiting = false;
    const [left, right] = now.showcase.pairs[now.pair];
    view.draw(left, right, by('slider').value / by('slider').max, by('side').checked);
    document.documentElement.dataset.drawn = ++drawn;
  };
  const redraw = () => {
    if (!isWaiting) {
      isWaiting = true;
      requestAnimationFrame(draw);
    }
  };
  const view = new View(by('canvas'), redraw);
  const now = { showcase: null, pair: 0, look: 'whole', eye: null, zoom: 1 };

  const share = () => (by('side').checked ? 0.5 : 1);
  const look = (at) => {
    now.look = at;
    if (at === 'near') {
      view.lookNear(share());
    } else {
      view.lookAtAll(now.eye ?? now.showcase.eye, share(), now.zoom);
    }
    redraw();
  };

  const legend = () => {
    const { distance } = now.showcase;
    by('measured-label').hidden = !distance;
    by('legend').hidden = !distance || !by('measured').checked;
    if (!distance) return;
    by('legend-title').textContent = `Distance to the original, ${distance.unit}`;
    by('legend-bar').style.background = `linear-gradient(90deg, ${SCALE.join()})`;
    by('legend-ticks').replaceChildren(...[0, 0.25, 0.5, 0.75, 1].map((at) => {
      const tick = document.createElement('span');
      tick.textContent = String(Number((at * distance.shown).toPrecision(2)));
      return tick;
    }));
  };

  /** After any change of a control. */
  const apply = () => {
    const { showcase } = now, [left, right] = showcase.pairs[now.pair];
    const isSideBySide = by('side').checked, at = isSideBySide ? 0.5 : by('slider').value / by('slider').max;
    by('pairs').value = now.pair;
    by('slider').disabled = isSideBySide;
    by('stage').classList.toggle('halves', isSideBySide);
    by('slider').setAttribute('aria-valuetext', `${Math.round(100 * at)} % ${showcase.states[left].name}`);
    by('divider').style.left = `${100 * at}%`;
    by('left').textContent = showcase.states[left].name;
    by('right').textContent = showcase.states[right].name;
    by('left').hidden = at < 0.02;
    by('right').hidden = at > 0.98;
    by('near').hidden = !showcase.near;
    by('notes').replaceChildren(...[left, right].map((k) => showcase.states[k]).filter(({ note }) => note).flatMap(({ name, note }) =>
      [['dt', name], ['dd', note]].map(([kind, said]) => Object.assign(document.createElement(kind), { textContent: said }))));
    view.setWire(by('wire').checked);
    view.setMeasured(Boolean(showcase.distance) && by('measured').checked);
    legend();
    redraw();
  };

  const show = (showcase) => {
    if (now.showcase === showcase) return;
    now.showcase = showcase;
    now.pair = 0;
    view.show(showcase, showcase.bodies.map((body) => decoded(arrays, body)));
    by('text').textContent = showcase.text;
    by('pairs').replaceChildren(...showcase.pairs.map(([left, right], k) => {
      const { states } = showcase;
      return new Option(`${states[left].name} and ${states[right].name}`, k);
    }));
    for (const link of by('showcases').children) {
      link.setAttribute('aria-current', String(link.id === `show=${showcase.id}`));
    }
  };

  const resize = () => {
    const { clientWidth, clientHeight } = by('stage');
    if (clientWidth > 0 && clientHeight > 0) {
      view.resize(clientWidth, clientHeight, Math.min(window.devicePixelRatio, 2));
      redraw();
    }
  };

  const theme = (name) => {
    document.documentElement.classList.toggle('dark', name === 'dark');
    document.documentElement.classList.toggle('light', name !== 'dark');
    redraw();
  };

  /** The selection in the address. */
  const read = () => {
    const given = new URLSearchParams(location.hash.slice(1));
    const body = document.body.classList;
    body.toggle('plain', given.get('plain') === '1');
    body.toggle('named', given.get('named') === '1');
    if (given.has('theme')) theme(given.get('theme'));
    show(showcases.find((showcase) => showcase.id === given.get('show')) ?? now.showcase ?? showcases[0]);
    now.pair = Math.min(Math.max(Number(given.get('pair') ?? 0) | 0, 0), now.showcase.pairs.length - 1);
    by('slider').value = Number(given.get('slider') ?? 0.5) * by('slider').max;
    by('side').checked = given.get('side') === '1';
    by('wire').checked = given.get('wire') === '1';
    by('measured').checked = given.get('distance') === '1';
    now.eye = given.has('eye') ? given.get('eye').split(',').map(Number) : null;
    now.zoom = Number(given.get('zoom') ?? 1) || 1;
    resize();
    apply();
    look(given.get('look') === 'near' && now.showcase.near ? 'near' : 'whole');
  };

  for (const id of ['slider', 'wire', 'measured']) {
    by(id).addEventListener('input', apply);
  }
  by('side').addEventListener('input', () => {
    apply();
    look(now.look);
  });
  by('pairs').addEventListener('input', () => {
    now.pair = Number(by('pairs').value);
    apply();
  });
  by('whole').addEventListener('click', () => look('whole'));
  by('near').addEventListener('click', () => look('near'));
  by('theme').addEventListener('click', () => theme(document.documentElement.classList.contains('dark') ? 'light' : 'dark'));
  const step = Math.PI / 36;
  const keys = {
    ArrowLeft: () => view.orbit(-step, 0),
    ArrowRight: () => view.orbit(step, 0),
    ArrowUp: () => view.orbit(0, -step),
    ArrowDown: () => view.orbit(0, step),
    '+': () => view.zoom(0.9),
    '=': () => view.zoom(0.9),
    '-': () => view.zoom(1 / 0.9),
    0: () => look('whole'),
    1: () => now.showcase.near && look('near'),
  };
  by('canvas').addEventListener('keydown', (event) => {
    if (keys[event.key] && !event.ctrlKey && !event.metaKey && !event.altKey) {
      keys[event.key]();
      event.preventDefault();
    }
  });
  const dark = window.matchMedia('(prefers-color-scheme: dark)');
  dark.addEventListener('change', () => theme(dark.matches ? 'dark' : 'light'));
  theme(dark.matches ? 'dark' : 'light');
  new ResizeObserver(resize).observe(by('stage'));
  window.addEventListener('hashchange', read);
  read();
}

start().catch((error) => {
  by('message').textContent = error.message;
  by('message').hidden = false;
  document.documentElement.dataset.failed = error.message;
  throw error;
});
