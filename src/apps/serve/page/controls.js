// Controls for the parameters that the server lists.

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

// Parameters are linear colours; colour inputs have sRGB codes.
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
