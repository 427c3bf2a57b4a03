'use strict';
// The page can be read without this script. It adds sliders, the viewer, copy buttons and the theme.
(() => {
    const root = document.documentElement;
    const all = (selector, within = document) => [...within.querySelectorAll(selector)];

    const make = (tag, properties = {}, ...children) => {
        const element = Object.assign(document.createElement(tag), properties);
        element.append(...children);
        return element;
    };

    // Browsers may forbid storage, for local files in particular.
    const stored = () => {
        try { return localStorage.getItem('lambent-theme'); } catch { return null; }
    };
    const store = theme => {
        try { localStorage.setItem('lambent-theme', theme); } catch { /* the theme lasts until the page is closed */ }
    };

    // Applied at once, before the page is painted in the wrong colours.
    const chosen = stored();
    if (chosen === 'light' || chosen === 'dark') root.dataset.theme = chosen;

    function startTheme() {
        const button = document.querySelector('.theme'), system = matchMedia('(prefers-color-scheme: dark)');
        const isDark = () => (root.dataset.theme ? root.dataset.theme === 'dark' : system.matches);
        const show = () => button.setAttribute('aria-pressed', isDark());
        button.hidden = false;
        button.addEventListener('click', () => {
            root.dataset.theme = isDark() ? 'light' : 'dark';
            store(root.dataset.theme);
            show();
        });
        system.addEventListener('change', show);
        show();
    }

    const say = words => { document.getElementById('said').textContent = words; };

    // Where the clipboard is not available, the command is selected instead, for copying by keyboard.
    async function copy(button) {
        const code = button.parentElement.querySelector('code');
        let done = 'Copied';
        try {
            await navigator.clipboard.writeText(code.textContent);
        } catch {
            getSelection().selectAllChildren(code);
            done = 'Selected';
        }
        button.textContent = done;
        say(done);
        setTimeout(() => { button.textContent = 'Copy'; }, 2000);
    }

    function startCopying() {
        for (const button of all('.copy')) button.hidden = false;
        document.addEventListener('click', event => {
            const button = event.target.closest('.copy');
            if (button) copy(button);
        });
    }

    const titleOf = picture =>
        picture.querySelector('.title')?.textContent ?? picture.querySelector('img').alt;

    function makeSide(name) {
        const label = make('span');
        const side = make('div', { className: `side ${name}` });
        return {
            side,
            show(picture) {
                const image = picture.querySelector('img').cloneNode();
                label.textContent = titleOf(picture);
                side.replaceChildren(image, label);
            },
        };
    }

    function makeChooser(name, pictures, choose) {
        const select = make('select', {}, ...pictures.map((picture, i) =>
            make('option', { value: i, textContent: titleOf(picture) })));
        select.addEventListener('change', () => choose(Number(select.value)));
        return { select, label: make('label', {}, name, select) };
    }

    function startComparison(comparison) {
        const list = comparison.querySelector('.pictures'), pictures = all('.picture', list);
        if (pictures.length < 2) return;
        const sides = [makeSide('left'), makeSide('right')], shown = [0, 1];
        const range = make('input', { type: 'range', min: 0, max: 100, step: 0.5, value: 50 });
        const stage = make('div', { className: 'stage' }, sides[0].side, sides[1].side,
            make('div', { className: 'line' }), range);
        const move = () => {
            stage.style.setProperty('--split', `${range.value}%`);
            range.setAttribute('aria-valuenow', range.value);
            const left = titleOf(pictures[shown[0]]);
            range.setAttribute('aria-valuetext', `${left} on ${range.value} % of the width`);
        };
        const show = () => {
            sides.forEach((side, i) => side.show(pictures[shown[i]]));
            const [left, right] = shown.map(i => titleOf(pictures[i]));
            range.setAttribute('aria-label', `Division between ${left} and ${right}`);
            move();
        };
        range.addEventListener('input', move);
        const parts = [stage];
        if (pictures.length > 2) parts.push(makeChoosers(pictures, shown, show));
        list.before(...parts);
        show();
    }

    function makeChoosers(pictures, shown, show) {
        const choosers = ['Left', 'Right'].map((name, i) => makeChooser(name, pictures, choice => {
            // The same picture on both sides would show nothing: the sides are exchanged.
            if (shown[1 - i] === choice) shown[1 - i] = shown[i];
            shown[i] = choice;
            write();
            show();
        }));
        const write = () => choosers.forEach(({ select }, i) => { select.value = shown[i]; });
        write();
        return make('div', { className: 'choosers' }, ...choosers.map(({ label }) => label));
    }

    // Shows a picture enlarged, with its numbers and commands.
    function startViewer() {
        const viewer = document.getElementById('viewer'), views = all('.view');
        const part = selector => viewer.querySelector(selector);
        const stage = part('.viewer-stage'), pixels = part('.pixels');
        let current = 0;

        const show = index => {
            current = (index + views.length) % views.length;
            const view = views[current], image = view.querySelector('img').cloneNode();
            image.loading = 'eager';
            part('#viewer-title').textContent = view.dataset.title;
            part('.count').textContent = `${current + 1} / ${views.length}`;
            stage.replaceChildren(image);
            part('.viewer-about').replaceChildren(...about(view));
        };
        const actions = {
            previous: () => show(current - 1),
            next: () => show(current + 1),
            close: () => viewer.close(),
        };
        for (const name in actions) part(`.${name}`).addEventListener('click', actions[name]);
        pixels.addEventListener('click', () =>
            pixels.setAttribute('aria-pressed', stage.classList.toggle('as-pixels')));
        viewer.addEventListener('keydown', event => {
            if (event.key === 'ArrowLeft') actions.previous();
            else if (event.key === 'ArrowRight') actions.next();
            else if (event.key === 'Tab') keepFocus(viewer, event);
        });
        stage.addEventListener('click', event => { if (event.target === stage) viewer.close(); });
        viewer.addEventListener('close', () => views[current].focus());
        views.forEach((view, i) => view.addEventListener('click', event => {
            if (event.ctrlKey || event.metaKey || event.shiftKey) return;
            event.preventDefault();
            show(i);
            viewer.showModal();
            part('.close').focus();
        }));
    }

    function about(view) {
        const parts = [];
        const numbers = view.parentElement.querySelector('.numbers');
        if (numbers) parts.push(numbers.cloneNode(true));
        const recipe = document.getElementById(view.dataset.made ?? '');
        if (recipe) {
            const copied = recipe.cloneNode(true);
            copied.removeAttribute('id');
            parts.push(make('details', { className: 'made' },
                make('summary', { textContent: 'How this was made' }), copied));
        }
        return parts;
    }

    // A modal dialog keeps the focus out of the page, but not out of the browser's own controls.
    function keepFocus(viewer, event) {
        const stops = all('button, summary, a[href]', viewer).filter(stop => stop.checkVisibility());
        const end = event.shiftKey ? stops[0] : stops.at(-1);
        if (document.activeElement !== end) return;
        event.preventDefault();
        (event.shiftKey ? stops.at(-1) : stops[0]).focus();
    }

    // Marks the section being read in the contents beside the text.
    function startContents() {
        const places = new Map(all('.beside > ol > li').map(item =>
            [item.querySelector('a').getAttribute('href').slice(1), item]));
        const sections = all('article > section');
        const mark = () => {
            const line = innerHeight * 0.35;
            const here = sections.filter(section => section.getBoundingClientRect().top < line).at(-1);
            for (const [id, item] of places) {
                item.classList.toggle('current', id === here?.id);
                if (id === here?.id) item.firstElementChild.setAttribute('aria-current', 'true');
                else item.firstElementChild.removeAttribute('aria-current');
            }
        };
        let isDue = false;
        addEventListener('scroll', () => {
            if (isDue) return;
            isDue = true;
            requestAnimationFrame(() => { isDue = false; mark(); });
        }, { passive: true });
        mark();

        const folded = document.querySelector('.folded');
        folded.addEventListener('click', event => { if (event.target.closest('a')) folded.open = false; });
        folded.addEventListener('keydown', event => {
            if (event.key !== 'Escape') return;
            folded.open = false;
            folded.querySelector('summary').focus();
        });
    }

    function startPrinting() {
        let opened = [];
        addEventListener('beforeprint', () => {
            opened = all('.made:not([open])');
            for (const details of opened) details.open = true;
        });
        addEventListener('afterprint', () => { for (const details of opened) details.open = false; });
    }

    document.addEventListener('DOMContentLoaded', () => {
        startTheme();
        startCopying();
        all('.comparison').forEach(startComparison);
        startViewer();
        startContents();
        startPrinting();
    });
})();
