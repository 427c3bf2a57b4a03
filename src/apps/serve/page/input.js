// Mouse, touch and keys.

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
    const height = canvas.clientHeight;
    const x = (event.clientX - from.x) / height, y = (event.clientY - from.y) / height;
    if (before) moveTwo(before);
    else if (event.shiftKey) move('turn', { by: x * degreesAcross });
    else if (event.buttons & 6 || event.ctrlKey) move('pan', { x, y: -y });
    else move('orbit', { x: -x * degreesAcross, y: y * degreesAcross });
});
for (const name of ['pointerup', 'pointercancel'])
    canvas.addEventListener(name, event => pointers.delete(event.pointerId));
canvas.addEventListener('contextmenu', event => event.preventDefault());
// Without these a browser would replace the page by the dropped file.
document.addEventListener('dragover', event => event.preventDefault());
document.addEventListener('drop', event => {
    event.preventDefault();
    if (event.dataTransfer.files.length > 0)
        trouble('Dropped files are not opened. Choose one from the folders of the server under Model or Environment.');
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
    if (event.key === ' ' && event.target.matches('button')) return; // a focused button is pressed by the space bar
    const action = arrow ? null : keys[event.key] ?? keys[event.key.toLowerCase()];
    if (!arrow && !action) return;
    event.preventDefault();
    action?.();
});
