'use strict';

const at = id => document.getElementById(id);
const canvas = at('picture'), paint = canvas.getContext('2d');
const socket = new WebSocket(
    `${location.protocol === 'https:' ? 'wss' : 'ws'}://${location.host}/socket${location.search}`);
socket.binaryType = 'arraybuffer';

let inputs = 0, state = null, table = [], scenes = [];

function say(message) {
    if (socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify({ ...message, id: ++inputs }));
}

// Moves between two frames of the screen become one message.
const moves = new Map();
function move(name, amounts) {
    const sum = moves.get(name) ?? {};
    for (const [key, amount] of Object.entries(amounts)) sum[key] = (sum[key] ?? 0) + amount;
    if (moves.size === 0)
        requestAnimationFrame(() => {
            for (const [what, all] of moves) say({ do: what, ...all });
            moves.clear();
        });
    moves.set(name, sum);
}

function element(tag, properties = {}, ...children) {
    const made = Object.assign(document.createElement(tag), properties);
    made.append(...children);
    return made;
}

// --- What comes from the server ---------------------------------------------------------------------------------

function trouble(line) {
    at('trouble').textContent = line;
    at('trouble').hidden = !line;
}

const percent = part => `${(100 * part).toPrecision(2)} %`;

function tracedStatus(size, { traced, last }) {
    const { samples, noise, error, flip } = traced;
    return `${size}, traced: ${Math.round(samples)} samples${noise !== undefined ? `, noise ${percent(noise)}` : ''}; drawn picture's error ` +
        `${percent(error)}${flip === undefined ? '' : `, FLIP ${flip.toFixed(3)}`}${last ? '' : ', refining'}`;
}

const recent = [];
function showStatus(header) {
    const now = performance.now();
    recent.push(now);
    while (recent.length > 1 && now - recent[0] > 1000) recent.shift();
    const moving = header.kind === 'moving';
    const rate = moving && recent.length > 2 ? `${Math.round((recent.length - 1) * 1000 / (now - recent[0]))}/s, ` : '';
    const size = `${header.width}×${header.height}`;
    if (header.traced) {
        at('status').textContent = tracedStatus(size, header);
        return;
    }
    at('status').textContent = moving ? `${rate}${size} at ${Math.round(100 * header.scale)} %, ${header.draw_ms.toFixed(0)} ms`
                                      : `${size}, ${header.draw_ms.toFixed(0)} ms${header.kind === 'still' ? ', refining' : ''}`;
}

// One after the other, in their order.
let shown = Promise.resolve();
function showFrame(header, bytes) {
    shown = shown.then(async () => {
        const picture = await createImageBitmap(new Blob([bytes], { type: `image/${header.format}` }),
                                                { colorSpaceConversion: 'none' });
        canvas.width = picture.width;
        canvas.height = picture.height;
        paint.drawImage(picture, 0, 0);
        picture.close();
        Object.assign(canvas.dataset, { kind: header.kind, input: header.input, scale: header.scale,
                                        frames: Number(canvas.dataset.frames ?? 0) + 1 });
        showStatus(header);
        showMoment(header.moment);
    }).catch(error => trouble(`a picture could not be shown: ${error.message}`)).then(() => {
        if (socket.readyState === WebSocket.OPEN) socket.send('{"do":"seen"}');
    });
}

function keep(header, bytes) {
    const address = URL.createObjectURL(new Blob([bytes], { type: 'application/octet-stream' }));
    const link = element('a', { href: address, download: header.name });
    document.body.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(address), 60000);
}

// Of files the last part of their path, unless two have the same.
function shortNames(names) {
    const last = names.map(name => name.slice(name.lastIndexOf('/') + 1));
    return names.map((name, i) => last.indexOf(last[i]) === last.lastIndexOf(last[i]) ? last[i] : name);
}

function choose(select, name) {
    if (![...select.options].some(option => option.value === name))
        select.append(element('option', { value: name, textContent: name, title: name }));
    select.value = name;
}

function fill(select, names, chosen) {
    const shown = shortNames(names);
    select.replaceChildren(...names.map((name, i) => element('option', { value: name, textContent: shown[i], title: name })));
    choose(select, chosen);
}

const isBuiltIn = name => scenes.includes(name) && !/\.(gltf|glb)$/.test(name);

// Whether a row of the table says something about the picture.
function applies(row) {
    const phong = state.values.model === 'phong';
    return { all: true, ggx: !phong, phong_shapes: phong && isBuiltIn(state.scene) }[row.scope];
}

function showState(message) {
    state = message;
    for (const row of table) {
        row.show(state.values[row.name]);
        row.element.hidden = !applies(row);
    }
    choose(at('scene'), state.scene);
    choose(at('environment'), state.environment);
    showAnimation();
    at('command').value = state.command;
    at('warnings').replaceChildren(...state.warnings.map(line => element('li', { textContent: line })));
    if (!at('lights').contains(document.activeElement)) showLights(state.lights);
    document.title = `${state.scene} - lambent`;
    trouble(state.error);
    if (state.loading) at('status').textContent = 'loading';
}

socket.addEventListener('message', ({ data }) => {
    if (typeof data !== 'string') {
        const length = new DataView(data).getUint32(0, true);
        const header = JSON.parse(new TextDecoder().decode(new Uint8Array(data, 4, length)));
        const bytes = new Uint8Array(data, 4 + length);
        return header.type === 'frame' ? showFrame(header, bytes) : keep(header, bytes);
    }
    const message = JSON.parse(data);
    if (message.type === 'hello') begin(message);
    else if (message.type === 'state') showState(message);
    else if (message.type === 'error') trouble(message.line);
});
socket.addEventListener('close', ({ reason }) => {
    trouble(`The connection ended${reason ? `: ${reason}` : ''}. Reload the page to begin again.`);
    at('status').textContent = 'not connected';
});

// --- Controls -----------------------------------------------------------------------------------------------------

const sliderSteps = 1000;

function toSlider(row, value) {
    const part = row.logarithmic ? Math.log(value / row.least) / Math.log(row.most / row.least)
                                 : (value - row.least) / (row.most - row.least);
    return Math.round(part * sliderSteps);
}

function fromSlider(row, place) {
    const part = place / sliderSteps;
    const value = row.logarithmic ? row.least * (row.most / row.least) ** part
                                  : row.least + (row.most - row.least) * part;
    return row.kind === 'whole' ? Math.round(value) : Number(value.toPrecision(4));
}

const set = (row, value) => say({ do: 'set', name: row.name, value });

function numberControl(row) {
    const id = `set-${row.name}`;
    const slider = element('input', { type: 'range', id, min: 0, max: sliderSteps, step: 1 });
    const number = element('input', { type: 'number', min: row.least, max: row.most, step: 'any' });
    number.setAttribute('aria-label', row.label);
    const say = () => slider.setAttribute('aria-valuetext', number.value || 'not set');
    slider.addEventListener('input', () => {
        number.value = fromSlider(row, Number(slider.value));
        say();
        set(row, Number(number.value));
    });
    number.addEventListener('change', () => {
        if (number.value !== '') set(row, Number(number.value));
        else if (row.usual === '' && !number.validity.badInput) set(row, '');
    });
    row.show = word => {
        if (document.activeElement !== number) number.value = word;
        if (document.activeElement !== slider || word === row.usual)
            slider.value = word === '' ? sliderSteps / 2 : toSlider(row, Number(word));
        say();
    };
    return [id, slider, number];
}

function choiceControl(row) {
    const id = `set-${row.name}`;
    const select = element('select', { id });
    fill(select, row.choices, row.usual);
    select.addEventListener('change', () => set(row, select.value));
    row.show = word => choose(select, word);
    return [id, select];
}

// Colours of light are linear, those of screens are not.
const toLight = code => code <= 0.04045 ? code / 12.92 : ((code + 0.055) / 1.055) ** 2.4;
const toCode = light => light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055;
const lightOf = hex => [1, 3, 5].map(i => toLight(parseInt(hex.slice(i, i + 2), 16) / 255));
const hexOf = light => `#${light.map(part =>
    Math.round(255 * toCode(Math.min(Math.max(part, 0), 1))).toString(16).padStart(2, '0')).join('')}`;

function colorControl(row) {
    const id = `set-${row.name}`;
    const color = element('input', { type: 'color', id });
    color.addEventListener('input', () => set(row, lightOf(color.value).map(part => part.toFixed(4)).join(',')));
    row.show = word => { color.value = word ? hexOf(word.split(',').map(Number)) : '#808080'; };
    return [id, color];
}

function makeControl(row) {
    const make = { choice: choiceControl, color: colorControl }[row.kind] ?? numberControl;
    const [id, ...inputs] = make(row);
    const usual = element('button', { type: 'button', textContent: '↺', title: 'default' });
    usual.setAttribute('aria-label', `${row.label}: default`);
    usual.addEventListener('click', () => {
        row.show(row.usual);
        set(row, row.usual);
    });
    row.element = element('div', { className: `row ${row.kind}` },
                          element('label', { htmlFor: id, textContent: row.label }), ...inputs, usual);
    return row.element;
}

function begin(message) {
    table = message.parameters;
    scenes = message.scenes;
    fill(at('scene'), message.scenes, message.scenes[0]);
    fill(at('environment'), message.environments, message.environments[0]);
    const groups = new Map();
    for (const row of table) {
        if (!groups.has(row.group))
            groups.set(row.group, element('fieldset', {}, element('legend', { textContent: row.group })));
        groups.get(row.group).append(makeControl(row));
    }
    at('groups').replaceChildren(...groups.values());
    sendSize();
}

// --- Animation ------------------------------------------------------------------------------------------------------

const duration = () => state?.seconds ?? 0;

function showMoment(seconds) {
    if (document.activeElement !== at('moment') || state?.playing)
        at('moment').value = duration() > 0 ? Math.round(1000 * seconds / duration()) : 0;
    at('seconds').textContent = `${seconds.toFixed(2)} s`;
}

function showAnimation() {
    at('animation').hidden = state.animations.length === 0;
    at('animate').replaceChildren(element('option', { value: -1, textContent: 'none' }),
        ...state.animations.map(({ name }, index) => element('option', { value: index, textContent: name })));
    choose(at('animate'), String(state.animation));
    at('moment').disabled = !(duration() > 0);
    at('play').textContent = state.playing ? 'Pause' : 'Play';
    at('play').setAttribute('aria-pressed', String(state.playing));
    showMoment(state.moment);
}

function togglePlay() {
    if (state?.animations.length > 0) say({ do: 'play', on: !state.playing });
}

at('play').addEventListener('click', togglePlay);
at('animate').addEventListener('change', event => say({ do: 'animate', number: Number(event.target.value) }));
at('moment').addEventListener('input', event => {
    const seconds = Number(event.target.value) / 1000 * duration();
    say({ do: 'moment', seconds });
    at('seconds').textContent = `${seconds.toFixed(2)} s`;
});

// --- Lights ---------------------------------------------------------------------------------------------------------

const lightFields = {
    directional: [['Azimuth', -180, 180], ['Elevation', -90, 90]],
    point: [['X', null, null], ['Y', null, null], ['Z', null, null]],
};

function readLight(word) {
    const [kind, rest] = word.split(':'), numbers = rest.split(',').map(Number), color = numbers.slice(-3);
    const strength = Math.max(...color, 1e-6);
    return { kind, place: numbers.slice(0, -3), strength, color: hexOf(color.map(part => part / strength)) };
}

function lightWord({ kind, place, strength, color }) {
    const parts = lightOf(color), most = Math.max(...parts) || 1;
    return `${kind}:${[...place, ...parts.map(part => Number((strength * part / most).toPrecision(5)))].join(',')}`;
}

const sendLights = list => say({ do: 'lights', list: list.map(lightWord) });

function lightRow(list, index) {
    const light = list[index], name = light.kind === 'point' ? 'Lamp' : 'Sun';
    const field = (label, properties, change) => {
        const id = `light-${index}-${label.toLowerCase()}`;
        const input = element('input', { id, ...properties });
        input.addEventListener('input', () => {
            if (input.value === '' || !input.validity.valid) return;
            change(input.value);
            sendLights(list);
        });
        return element('div', { className: 'row' }, element('label', { htmlFor: id, textContent: label }), input);
    };
    const remove = element('button', { type: 'button', textContent: `Remove ${name.toLowerCase()} ${index + 1}` });
    remove.addEventListener('click', () => {
        canvas.focus();
        sendLights(list.filter(other => other !== light));
    });
    const places = lightFields[light.kind].map(([label, min, max], i) =>
        field(label, { type: min === null ? 'number' : 'range', step: min === null ? 'any' : 1, ...(min === null ? {} : { min, max }), value: light.place[i] },
              value => { light.place[i] = Number(value); }));
    return element('div', { className: 'light', role: 'group', ariaLabel: `${name} ${index + 1}` }, ...places,
                   field('Strength', { type: 'number', min: 0, step: 'any', value: Number(light.strength.toPrecision(4)) },
                         value => { light.strength = Number(value); }),
                   field('Colour', { type: 'color', value: light.color }, value => { light.color = value; }), remove);
}

function showLights(words) {
    const list = words.map(readLight);
    at('lights').replaceChildren(...list.map((_, index) => lightRow(list, index)));
}

const addLight = word => () => say({ do: 'lights', list: [...(state?.lights ?? []), word] });
at('add-directional').addEventListener('click', addLight('directional:45,45,2,2,2'));
at('add-point').addEventListener('click', addLight('point:1,2,1,2,2,2'));

// --- Moves ------------------------------------------------------------------------------------------------------------

const pointers = new Map();
const degreesAcross = 240;
const place = event => ({ x: event.clientX, y: event.clientY });

function middleOf(points) {
    const [a, b] = [...points];
    return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, apart: Math.hypot(a.x - b.x, a.y - b.y) };
}

function moveTwo(before) {
    const after = middleOf(pointers.values()), height = canvas.clientHeight;
    move('pan', { x: (after.x - before.x) / height, y: (before.y - after.y) / height });
    if (after.apart > 10 && before.apart > 10) move('dolly', { by: Math.log(before.apart / after.apart) });
}

canvas.addEventListener('pointerdown', event => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, place(event));
});
canvas.addEventListener('pointermove', event => {
    const from = pointers.get(event.pointerId);
    if (!from) return;
    const before = pointers.size === 2 ? middleOf(pointers.values()) : null;
    pointers.set(event.pointerId, place(event));
    const height = canvas.clientHeight, x = (event.clientX - from.x) / height, y = (event.clientY - from.y) / height;
    if (before) moveTwo(before);
    else if (event.shiftKey) move('turn', { by: x * degreesAcross });
    else if (event.buttons & 6 || event.ctrlKey) move('pan', { x, y: -y });
    else move('orbit', { x: -x * degreesAcross, y: y * degreesAcross });
});
for (const name of ['pointerup', 'pointercancel'])
    canvas.addEventListener(name, event => pointers.delete(event.pointerId));
canvas.addEventListener('contextmenu', event => event.preventDefault());
// A browser would leave the page for the file.
document.addEventListener('dragover', event => event.preventDefault());
document.addEventListener('drop', event => {
    event.preventDefault();
    if (event.dataTransfer.files.length > 0)
        trouble('Files are opened from the folders of the server: choose one under Model or Environment.');
});
canvas.addEventListener('wheel', event => {
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === 1 ? 30 : event.deltaMode === 2 ? 400 : 1);
    move('dolly', { by: Math.min(Math.max(pixels * 0.0015, -1), 1) });
}, { passive: false });
canvas.addEventListener('dblclick', event => {
    const box = canvas.getBoundingClientRect();
    say({ do: 'focus', x: (event.clientX - box.left) / box.width, y: (event.clientY - box.top) / box.height });
});

const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const keys = {
    '+': () => move('dolly', { by: -0.1 }),
    '=': () => move('dolly', { by: -0.1 }),
    '-': () => move('dolly', { by: 0.1 }),
    '[': () => move('turn', { by: -5 }),
    ']': () => move('turn', { by: 5 }),
    f: () => say({ do: 'focus', x: 0.5, y: 0.5 }),
    ' ': () => togglePlay(),
    r: () => reset(),
    s: () => say({ do: 'save', kind: 'png' }),
    p: () => togglePanel(),
    '?': () => at('help').showModal(),
    F1: () => at('help').showModal(),
};
document.addEventListener('keydown', event => {
    const typing = event.target.matches('input, select, textarea');
    if (event.ctrlKey || event.metaKey || event.altKey || at('help').open || typing && event.key !== 'F1') return;
    const arrow = event.target === canvas && arrows[event.key];
    if (arrow && event.shiftKey) move('pan', { x: -0.05 * arrow[0], y: -0.05 * arrow[1] });
    else if (arrow) move('orbit', { x: 5 * arrow[0], y: 5 * arrow[1] });
    if (event.key === ' ' && event.target.matches('button')) return; // that presses it
    const action = arrow ? null : keys[event.key] ?? keys[event.key.toLowerCase()];
    if (!arrow && !action) return;
    event.preventDefault();
    action?.();
});

// --- The rest -----------------------------------------------------------------------------------------------------------

const reset = () => say({ do: 'reset' });

function togglePanel() {
    at('panel').hidden = !at('panel').hidden;
    at('panel-toggle').setAttribute('aria-expanded', String(!at('panel').hidden));
}

let sizeTimer = 0;
function sendSize() {
    const dense = Math.min(devicePixelRatio || 1, 2);
    say({ do: 'size', width: Math.round(canvas.clientWidth * dense), height: Math.round(canvas.clientHeight * dense) });
}
new ResizeObserver(() => {
    clearTimeout(sizeTimer);
    sizeTimer = setTimeout(sendSize, 100);
}).observe(canvas);

at('panel-toggle').addEventListener('click', togglePanel);
at('help-open').addEventListener('click', () => at('help').showModal());
at('reset').addEventListener('click', reset);
at('save-png').addEventListener('click', () => say({ do: 'save', kind: 'png' }));
at('save-jpg').addEventListener('click', () => say({ do: 'save', kind: 'jpg' }));
at('scene').addEventListener('change', event => say({ do: 'scene', name: event.target.value }));
at('environment').addEventListener('change', event => say({ do: 'environment', name: event.target.value }));
at('controls').addEventListener('submit', event => event.preventDefault());
at('copy').addEventListener('click', async () => {
    // Outside localhost and https a page has no clipboard: then it is selected, to be copied by hand.
    try {
        await navigator.clipboard.writeText(at('command').value);
        at('copy').textContent = 'Copied';
        setTimeout(() => { at('copy').textContent = 'Copy'; }, 1500);
    } catch {
        at('command').select();
    }
});
