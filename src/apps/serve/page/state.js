// The state of the controls, as the server sends it.

// Returns file names without folders, except where two files then had the same name.
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
    select.replaceChildren(
        ...names.map((name, i) => element('option', { value: name, textContent: shown[i], title: name })));
    choose(select, chosen);
}

const isBuiltIn = name => scenes.includes(name) && !/\.(gltf|glb)$/.test(name);

// Returns whether a parameter affects the picture with the present model and scene.
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
    trouble(`The connection was closed${reason ? `: ${reason}` : ''}. Reload the page to connect again.`);
    at('status').textContent = 'not connected';
});
