// The error against time, both on logarithmic axes.
const drawChart = (svg, points) => {
  const NS = 'http://www.w3.org/2000/svg', W = 296, H = 118, L = 40, B = 20, T = 8, R = 10;
  svg.setAttribute('viewBox', `0 0 ${W} ${H}`);
  svg.replaceChildren();
  const add = (name, attributes, text) => {
    const element = document.createElementNS(NS, name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    if (text) element.textContent = text;
    svg.append(element);
  };
  const known = points.filter(p => p[0] > 0 && p[2] > 0);
  // One point, or two of nearly one time, are no curve.
  svg.parentNode.hidden = known.length < 2 || known[known.length - 1][0] < 1.05 * known[0][0];
  if (svg.parentNode.hidden) return;
  add('path', {class: 'axis', d: `M${L} ${T}V${H - B}H${W - R}`});
  const bounds = known.filter(p => p[3] > 0);
  const times = known.map(p => Math.log(p[0]));
  const errors = [...known.map(p => p[2]), ...bounds.map(p => p[3])].map(Math.log);
  const t0 = Math.min(...times), t1 = Math.max(...times, t0 + .1);
  const e0 = Math.min(...errors), e1 = Math.max(...errors, e0 + .1);
  const x = p => L + (Math.log(p[0]) - t0) / (t1 - t0) * (W - L - R);
  const y = v => H - B - (Math.log(v) - e0) / (e1 - e0) * (H - B - T);
  const line = (all, i) => all.map((p, k) => `${k ? 'L' : 'M'}${x(p).toFixed(1)} ${y(p[i]).toFixed(1)}`).join('');
  if (bounds.length > 1) add('path', {class: 'limit', d: line(bounds, 3)});
  add('path', {class: 'estimate', d: line(known, 2)});
  const last = known[known.length - 1];
  add('circle', {cx: x(last), cy: y(last[2]), r: 3});
  const percent = v => (100 * v).toPrecision(2).replace(/\.?0+e/, 'e') * 1 + ' %';
  add('text', {x: L - 5, y: T + 8, 'text-anchor': 'end'}, percent(Math.exp(e1)));
  add('text', {x: L - 5, y: H - B, 'text-anchor': 'end'}, percent(Math.exp(e0)));
  add('text', {x: L, y: H - 5}, duration(Math.exp(t0)));
  add('text', {x: W - R, y: H - 5, 'text-anchor': 'end'}, duration(Math.exp(t1)));
  svg.setAttribute('aria-label',
    `Error against time: ${percent(known[0][2])} after ${duration(known[0][0])}, ${percent(last[2])} after ${duration(last[0])}`);
};

const duration = s => s < 10 ? s.toFixed(1) + ' s' : s < 90 ? Math.round(s) + ' s'
  : s < 5400 ? Math.round(s / 60) + ' min' : (s / 3600).toFixed(1) + ' h';
