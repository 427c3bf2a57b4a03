// What is looked at inside the page: each function is sent there as text, so it can use nothing from outside.

// Makes every picture load now; says which do not, or have another size than is written.
export async function wrongImages() {
    const images = [...document.images];
    for (const image of images) image.loading = 'eager';
    const wrong = await Promise.all(images.map(async image => {
        try { await image.decode(); } catch { return `${image.src} does not load`; }
        const isRight = image.naturalWidth === Number(image.getAttribute('width')) &&
            image.naturalHeight === Number(image.getAttribute('height'));
        return isRight ? '' : `${image.src} is ${image.naturalWidth} x ${image.naturalHeight}`;
    }));
    return wrong.filter(Boolean);
}

// The largest standard deviation of a channel, in codes; throws where the bytes are no picture.
export async function spreadOf(dataAddress) {
    const image = new Image();
    image.src = dataAddress;
    await image.decode();
    const canvas = Object.assign(document.createElement('canvas'), { width: 64, height: 64 });
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0, 64, 64);
    const { data } = context.getImageData(0, 0, 64, 64), count = data.length / 4;
    const spreads = [0, 1, 2].map(c => {
        let sum = 0, squares = 0;
        for (let i = c; i < data.length; i += 4) { sum += data[i]; squares += data[i] ** 2; }
        return Math.sqrt(Math.max(squares / count - (sum / count) ** 2, 0));
    });
    return Math.max(...spreads);
}

// Headings, titles, alternatives and names, as checkers of accessibility ask for them.
export function faultsOfStructure() {
    const all = selector => [...document.querySelectorAll(selector)], faults = [];
    const demand = (holds, fault) => { if (!holds) faults.push(fault); };
    demand(document.documentElement.lang, 'no language');
    demand(document.title.trim(), 'no title');
    const meta = name => document.querySelector(`meta[name=${name}]`)?.content.trim() ?? '';
    demand(meta('viewport').includes('width=device-width'), 'no viewport');
    demand(meta('description'), 'no description');
    demand(all('h1').length === 1, `${all('h1').length} headings of the first level`);
    let level = 0;
    for (const heading of all('h1, h2, h3, h4, h5, h6')) {
        const next = Number(heading.tagName[1]);
        demand(next <= level + 1, `heading "${heading.textContent}" skips a level`);
        level = next;
    }
    const ids = all('[id]').map(element => element.id);
    demand(new Set(ids).size === ids.length, 'an id is there twice');
    for (const link of all('a[href^="#"]'))
        demand(document.getElementById(link.hash.slice(1)), `${link.hash} leads nowhere`);
    for (const image of all('img')) demand(image.alt.trim(), `${image.src} has no alternative`);
    for (const svg of all('svg[role=img]')) demand(svg.getAttribute('aria-label'), 'a plot has no name');
    for (const cell of all('th')) demand(cell.scope, `"${cell.textContent}" heads nothing`);
    demand(all('main h1').length === 1, 'the heading is not in the main part');
    const nameOf = control => control.getAttribute('aria-label') || control.textContent.trim() ||
        control.labels?.[0]?.textContent.trim() || control.querySelector('img')?.alt;
    for (const control of all('a, button, input, select, summary, [tabindex="0"]')) {
        const label = document.getElementById(control.getAttribute('aria-labelledby') ?? '')?.textContent;
        demand(nameOf(control) || label, `${control.outerHTML.slice(0, 80)} has no name`);
    }
    return faults;
}

// Texts whose contrast with what is behind them is below WCAG's 4.5, or 3 where large.
export function faintTexts() {
    const parse = colour => {
        const match = /^rgba?\(([\d.]+), ([\d.]+), ([\d.]+)(?:, ([\d.]+))?\)$/.exec(colour);
        if (!match) throw new Error(`the colour ${colour}`);
        return [...match.slice(1, 4).map(Number), match[4] === undefined ? 1 : Number(match[4])];
    };
    const over = (top, under) => [0, 1, 2].map(c => top[c] * top[3] + under[c] * (1 - top[3]));
    const behind = element => {
        if (!element) return [255, 255, 255];
        const colour = parse(getComputedStyle(element).backgroundColor);
        return colour[3] === 1 ? colour.slice(0, 3) : over(colour, behind(element.parentElement));
    };
    const linear = code => (code <= 10.31475 ? code / 3294.6 : ((code / 255 + 0.055) / 1.055) ** 2.4);
    const luminance = ([r, g, b]) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
    const faint = new Set(), seen = new Set();
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
        const element = node.parentElement;
        const isSeen = element.checkVisibility({ opacityProperty: true });
        if (!isSeen || seen.has(element) || !node.data.trim()) continue;
        seen.add(element);
        if (element.closest('script, style, title, option, .unseen, .skip')) continue;
        const style = getComputedStyle(element), back = behind(element);
        const colour = parse(element instanceof SVGElement ? style.fill : style.color);
        const [low, high] = [luminance(over(colour, back)), luminance(back)].sort((a, b) => a - b);
        const size = parseFloat(style.fontSize), contrast = (high + 0.05) / (low + 0.05);
        const isLarge = size >= 24 || (size >= 18.66 && style.fontWeight >= 700);
        if (contrast < (isLarge ? 3 : 4.5)) faint.add(`${contrast.toFixed(2)}: ${node.data.trim()}`);
    }
    return { count: seen.size, faint: [...faint] };
}

// Controls that a finger would miss.
export function smallTargets() {
    const controls = [...document.querySelectorAll('a[href], button, summary, select, input')];
    const shown = controls.filter(control => control.checkVisibility() && !control.matches('.skip'));
    const small = shown.filter(control => {
        const { width, height } = control.getBoundingClientRect();
        return width < 24 || height < 24;
    });
    return small.map(control => `${control.outerHTML.slice(0, 100)}`);
}

export function openAll() {
    const foldable = document.querySelectorAll('figure details, .viewer-about details');
    for (const details of foldable) details.open = true;
}

// How far the page reaches beyond the window's right edge, in pixels.
export function overhang() {
    return document.documentElement.scrollWidth - innerWidth;
}

// What has the focus, and whether that can be seen.
export function focused() {
    const element = document.activeElement;
    if (!element || element === document.body) return null;
    const isOutlined = box => {
        const style = getComputedStyle(box);
        return style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) >= 2;
    };
    // A slider's outline is around the pictures it moves over.
    const boxes = [element, element.closest('.stage') ?? element];
    const isSeen = element.checkVisibility() && boxes.some(isOutlined);
    return { html: element.outerHTML.slice(0, 100), isSeen };
}

// Elements that move though the reader asked for none of it.
export function moving() {
    return [...document.querySelectorAll('*')].filter(element => {
        const style = getComputedStyle(element);
        const lasts = [style.transitionDuration, style.animationDuration].join(',').split(',')
            .some(time => parseFloat(time) > 0.01);
        return lasts || style.scrollBehavior === 'smooth';
    }).map(element => element.outerHTML.slice(0, 80));
}
