// Buttons, the panel and the size of the picture.

const reset = () => say({ do: 'reset' });

function togglePanel() {
    at('panel').hidden = !at('panel').hidden;
    at('panel-toggle').setAttribute('aria-expanded', String(!at('panel').hidden));
}

let sizeTimer = 0;
function sendSize() {
    const dense = Math.min(devicePixelRatio || 1, 2);
    const pixels = length => Math.round(length * dense);
    say({ do: 'size', width: pixels(canvas.clientWidth), height: pixels(canvas.clientHeight) });
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
    // Pages have a clipboard only on localhost and over https; elsewhere the command is selected, to be copied by hand.
    try {
        await navigator.clipboard.writeText(at('command').value);
        at('copy').textContent = 'Copied';
        setTimeout(() => { at('copy').textContent = 'Copy'; }, 1500);
    } catch {
        at('command').select();
    }
});
