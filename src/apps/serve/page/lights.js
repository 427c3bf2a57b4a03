// Controls for lights, which the server knows as words of --light.

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
        field(label, { ...(min === null ? { type: 'number', step: 'any' } : { type: 'range', step: 1, min, max }),
                       value: light.place[i] },
              value => { light.place[i] = Number(value); }));
    return element('div', { className: 'light', role: 'group', ariaLabel: `${name} ${index + 1}` }, ...places,
                   field('Strength', { type: 'number', min: 0, step: 'any',
                                       value: Number(light.strength.toPrecision(4)) },
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
